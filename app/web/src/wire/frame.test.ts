import {describe, expect, it} from 'vitest';
import {decodeFrame, FrameError} from './frame';

// One frame written byte by byte from the list in wire.schema.yaml, with 1 limit and 2 nodes.
function handWrittenFrame(): DataView {
  const bytes = new DataView(new ArrayBuffer(104 + 8 + 2 * 16));
  bytes.setUint32(0, 0x46544143, true); // magic, "CATF" in memory order
  bytes.setUint16(4, 1, true); // version
  bytes.setUint16(6, 8 | 2, true); // started, ended
  bytes.setUint32(8, 77, true); // frame
  bytes.setUint32(12, 123456, true); // step
  bytes.setFloat64(16, 123.456, true); // time_s
  bytes.setFloat64(24, 120.5, true); // elapsed_s
  bytes.setFloat64(32, 2.25, true); // paused_s
  const floats = [0.5, 350, -90, 340, 0.75, 1.5, 3, 4, 0.25, 1.75, 12.5, 6, 0.125];
  floats.forEach((value, index) => bytes.setFloat32(40 + 4 * index, value, true)); // slowed_s to held_s
  [3, 2, 9, 1, 2, 0].forEach((value, index) => bytes.setUint16(92 + 2 * index, value, true)); // step_index to reserved
  bytes.setFloat32(104, 1.5, true); // limit: value
  bytes.setUint32(108, 1, true); // limit: breached
  [1, 2, 3, 0.5, 4, 5, 6, 0].forEach((value, index) => bytes.setFloat32(112 + 4 * index, value, true));
  return bytes;
}

describe('decodeFrame', () => {
  it('reads every field where the schema puts it', () => {
    expect(decodeFrame(handWrittenFrame().buffer as ArrayBuffer)).toEqual({
      paused: false, ended: true, filed: false, started: true,
      frame: 77, step: 123456, time_s: 123.456, elapsed_s: 120.5, paused_s: 2.25, slowed_s: 0.5,
      handle_axial_mm: 350, handle_rotation_deg: -90, inserted_mm: 340,
      handle_force_n: 0.75, handle_force_peak_n: 1.5, handle_torque_n_mm: 3, handle_torque_peak_n_mm: 4,
      contact_force_n: 0.25, contact_force_peak_n: 1.75, step_value: 12.5, step_start: 6, held_s: 0.125,
      step_index: 3, end_reason: 'limit', contact_count: 9, limit_count: 1, node_count: 2,
      limits: [{value: 1.5, breached: true}],
      nodes: new Float32Array([1, 2, 3, 0.5, 4, 5, 6, 0]),
    });
  });

  it('gives no end reason while the trial runs', () => {
    const bytes = handWrittenFrame();
    bytes.setUint16(6, 8, true);
    expect(decodeFrame(bytes.buffer as ArrayBuffer).end_reason).toBeNull();
  });

  it.each([
    ['an empty message', () => new ArrayBuffer(0)],
    ['a wrong magic', (bytes: DataView) => { bytes.setUint32(0, 1, true); return bytes.buffer; }],
    ['another version', (bytes: DataView) => { bytes.setUint16(4, 2, true); return bytes.buffer; }],
    ['a cut frame', (bytes: DataView) => bytes.buffer.slice(0, bytes.byteLength - 1)],
    ['more nodes than bytes', (bytes: DataView) => { bytes.setUint16(100, 3, true); return bytes.buffer; }],
    ['an unknown end reason', (bytes: DataView) => { bytes.setUint16(94, 99, true); return bytes.buffer; }],
  ])('refuses %s', (_name, spoil) => {
    expect(() => decodeFrame(spoil(handWrittenFrame()) as ArrayBuffer)).toThrow(FrameError);
  });
});
