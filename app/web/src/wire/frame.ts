// Written by app/wire/generate.mjs from wire.schema.yaml. Change the schema, not this file.
// Decodes one binary frame of the live channel. Little endian, packed: header, limits, nodes.
import type {EndReason} from './types';

export const frameMagic = 0x46544143;
export const frameVersion = 1;
export const frameHeaderSize = 104;
export const frameLimitSize = 8;
export const frameNodeSize = 16;
export const flagBits = {paused: 1, ended: 2, filed: 4, started: 8} as const;
export const endReasons: readonly EndReason[] = ['completed', 'timeout', 'limit', 'aborted', 'diverged'];

/** Position of each value of a node in `nodes`: node i starts at i * nodeStride. */
export const nodeStride = 4;
export const nodeFields = {x_mm: 0, y_mm: 1, z_mm: 2, force_n: 3} as const;

export interface FrameLimit {
  value: number;
  breached: boolean;
}

export interface Frame {
  paused: boolean;
  ended: boolean;
  filed: boolean;
  started: boolean;
  frame: number;
  step: number;
  time_s: number;
  elapsed_s: number;
  paused_s: number;
  slowed_s: number;
  handle_axial_mm: number;
  handle_rotation_deg: number;
  inserted_mm: number;
  handle_force_n: number;
  handle_force_peak_n: number;
  handle_torque_n_mm: number;
  handle_torque_peak_n_mm: number;
  contact_force_n: number;
  contact_force_peak_n: number;
  step_value: number;
  step_start: number;
  held_s: number;
  step_index: number;
  contact_count: number;
  limit_count: number;
  node_count: number;
  /** Why the trial ended; null while it runs. */
  end_reason: EndReason | null;
  limits: FrameLimit[];
  /** node_count times x_mm, y_mm, z_mm, force_n, from the access to the tip. */
  nodes: Float32Array;
}

export class FrameError extends Error {}

/** Throws FrameError when the bytes are not one whole frame of this version. */
export function decodeFrame(bytes: ArrayBuffer): Frame {
  if (bytes.byteLength < frameHeaderSize) throw new FrameError(`A frame of ${bytes.byteLength} bytes is too short.`);
  const view = new DataView(bytes);
  if (view.getUint32(0, true) !== frameMagic) throw new FrameError('These bytes are not a frame.');
  const version = view.getUint16(4, true);
  if (version !== frameVersion) {
    throw new FrameError(`The server sends frames of version ${version}; this page reads version ${frameVersion}. Reload the page.`);
  }
  const flags = view.getUint16(6, true);
  const limitCount = view.getUint16(98, true);
  const nodeCount = view.getUint16(100, true);
  const size = frameHeaderSize + limitCount * frameLimitSize + nodeCount * frameNodeSize;
  if (bytes.byteLength !== size) {
    throw new FrameError(`A frame of ${bytes.byteLength} bytes should have ${size}.`);
  }
  const ended = (flags & flagBits.ended) !== 0;
  const reason = endReasons[view.getUint16(94, true)];
  if (ended && reason === undefined) throw new FrameError('The frame names an end reason that this page does not know.');
  return {
    paused: (flags & flagBits.paused) !== 0,
    ended: (flags & flagBits.ended) !== 0,
    filed: (flags & flagBits.filed) !== 0,
    started: (flags & flagBits.started) !== 0,
    frame: view.getUint32(8, true),
    step: view.getUint32(12, true),
    time_s: view.getFloat64(16, true),
    elapsed_s: view.getFloat64(24, true),
    paused_s: view.getFloat64(32, true),
    slowed_s: view.getFloat32(40, true),
    handle_axial_mm: view.getFloat32(44, true),
    handle_rotation_deg: view.getFloat32(48, true),
    inserted_mm: view.getFloat32(52, true),
    handle_force_n: view.getFloat32(56, true),
    handle_force_peak_n: view.getFloat32(60, true),
    handle_torque_n_mm: view.getFloat32(64, true),
    handle_torque_peak_n_mm: view.getFloat32(68, true),
    contact_force_n: view.getFloat32(72, true),
    contact_force_peak_n: view.getFloat32(76, true),
    step_value: view.getFloat32(80, true),
    step_start: view.getFloat32(84, true),
    held_s: view.getFloat32(88, true),
    step_index: view.getUint16(92, true),
    contact_count: view.getUint16(96, true),
    limit_count: view.getUint16(98, true),
    node_count: view.getUint16(100, true),
    end_reason: ended && reason !== undefined ? reason : null,
    limits: readLimits(view, limitCount),
    nodes: readNodes(view, frameHeaderSize + limitCount * frameLimitSize, nodeCount),
  };
}

function readLimits(view: DataView, count: number): FrameLimit[] {
  const limits: FrameLimit[] = [];
  for (let index = 0; index < count; ++index) {
    const start = frameHeaderSize + index * frameLimitSize;
    limits.push({value: view.getFloat32(start + 0, true), breached: view.getUint32(start + 4, true) !== 0});
  }
  return limits;
}

function readNodes(view: DataView, start: number, count: number): Float32Array {
  const nodes = new Float32Array(count * nodeStride);
  for (let index = 0; index < nodes.length; ++index) nodes[index] = view.getFloat32(start + index * 4, true);
  return nodes;
}
