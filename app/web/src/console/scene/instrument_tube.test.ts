import {describe, expect, it} from 'vitest';
import {InstrumentTube, tubeIndex} from './instrument_tube';

// a quarter circle of 50 mm radius in the x-z plane
function arc(count: number): Float32Array {
  const nodes = new Float32Array(count * 4);
  for (let i = 0; i < count; ++i) {
    const angle = (i / (count - 1)) * (Math.PI / 2);
    nodes.set([50 * (1 - Math.cos(angle)), 0, 50 * Math.sin(angle), 0], i * 4);
  }
  return nodes;
}
const none = new Float32Array(64);

function values(tube: InstrumentTube, name: string): Float32Array {
  return tube.mesh.geometry.getAttribute(name).array as Float32Array;
}

describe('the tube of the instrument', () => {
  it('has normals of unit length across the instrument', () => {
    const tube = new InstrumentTube();
    const count = 33;
    tube.update(arc(count), count, none, 2);
    const normals = values(tube, 'normal');
    for (let ring = 1; ring + 1 < count; ++ring) {
      const angle = (ring / (count - 1)) * (Math.PI / 2);
      const tangent = [Math.sin(angle), 0, Math.cos(angle)];
      for (let side = 0; side < 8; ++side) {
        const n = [0, 1, 2].map((axis) => normals[(ring * 8 + side) * 3 + axis] ?? NaN);
        // float32 in the buffer
        expect(Math.hypot(...n)).toBeCloseTo(1, 5);
        expect(n.reduce((sum, part, axis) => sum + part * (tangent[axis] ?? 0), 0)).toBeCloseTo(0, 5);
      }
    }
  });

  it('winds its triangles outward', () => {
    const tube = new InstrumentTube();
    tube.update(new Float32Array([0, 0, 0, 0, 0, 0, 10, 0]), 2, none, 2);
    const [centres, normals] = [values(tube, 'position'), values(tube, 'normal')];
    const corner = (vertex: number) => [0, 1, 2].map((k) => (centres[vertex * 3 + k] ?? 0) + (normals[vertex * 3 + k] ?? 0));
    const index = tubeIndex(2);
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => corner(index[i + k] ?? 0)) as [number[], number[], number[]];
      const [p, q] = [b, c].map((point) => point.map((part, k) => part - (a[k] ?? 0))) as [number[], number[]];
      const face = [
        (p[1] ?? 0) * (q[2] ?? 0) - (p[2] ?? 0) * (q[1] ?? 0),
        (p[2] ?? 0) * (q[0] ?? 0) - (p[0] ?? 0) * (q[2] ?? 0),
      ];
      expect((face[0] ?? 0) * (a[0] ?? 0) + (face[1] ?? 0) * (a[1] ?? 0)).toBeGreaterThan(0);
    }
  });

  it('draws as much as there is, and keeps its buffers when the instrument gets shorter', () => {
    const tube = new InstrumentTube();
    tube.update(arc(40), 40, none, 2);
    const before = tube.mesh.geometry;
    tube.update(arc(20), 20, none, 2);
    expect(tube.mesh.geometry).toBe(before);
    expect(before.drawRange.count).toBe(19 * 8 * 6);
    tube.update(arc(2), 0, none, 2);
    expect(tube.mesh.visible).toBe(false);
  });

  it('is red where the force is at the limit and steel where nothing presses', () => {
    const tube = new InstrumentTube();
    const force = new Float32Array(20);
    force[10] = 2;
    tube.update(arc(20), 20, force, 2);
    const tints = values(tube, 'tint');
    const tint = (ring: number) => [0, 1, 2].map((k) => Math.round((tints[ring * 24 + k] ?? 0) * 255));
    expect(tint(10)).toEqual([0xff, 0x7a, 0x6e]);
    expect(tint(5)).toEqual([0xcf, 0xdb, 0xe6]);
  });
});
