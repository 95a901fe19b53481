import {describe, expect, it} from 'vitest';
import {type Surface, thinned} from './mesh_thinning';

// an open tube of radius 4 mm and length 100 mm along z
function tube(sides: number, rings: number): Surface {
  const positions: number[] = [];
  const normals: number[] = [];
  const index: number[] = [];
  for (let ring = 0; ring <= rings; ++ring) {
    for (let side = 0; side < sides; ++side) {
      const angle = (2 * Math.PI * side) / sides;
      positions.push(4 * Math.cos(angle), 4 * Math.sin(angle), (100 * ring) / rings);
      normals.push(Math.cos(angle), Math.sin(angle), 0);
      if (ring === rings) continue;
      const a = ring * sides + side;
      const b = ring * sides + ((side + 1) % sides);
      index.push(a, b, a + sides, b, b + sides, a + sides);
    }
  }
  return {positions: new Float32Array(positions), normals: new Float32Array(normals), index: new Uint32Array(index)};
}

describe('a thinned surface', () => {
  it('is the same surface when it is light enough', () => {
    const light = tube(12, 10);
    expect(thinned(light, 1000)).toBe(light);
  });

  it('has about as many triangles as asked for and lies close to the first', () => {
    const light = thinned(tube(60, 250), 4000);  // of 30 000
    const triangles = light.index.length / 3;
    expect(triangles).toBeGreaterThan(2000);
    expect(triangles).toBeLessThan(6000);
    for (let i = 0; i < light.positions.length; i += 3) {
      const radius = Math.hypot(light.positions[i] ?? 0, light.positions[i + 1] ?? 0);
      // the mean of a patch of about 1.5 mm lies at most its sagitta inside: 4 (1 - cos(0.25)) mm
      expect(Math.abs(radius - 4)).toBeLessThan(0.13);
      expect(Math.hypot(light.normals[i] ?? 0, light.normals[i + 1] ?? 0, light.normals[i + 2] ?? 0)).toBeCloseTo(1, 5);
    }
  });

  it('keeps the winding of its triangles', () => {
    const {positions, index} = thinned(tube(60, 250), 4000);
    let outward = 0;
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => (index[i + k] ?? 0) * 3) as [number, number, number];
      const at = (v: number, axis: number) => positions[v + axis] ?? 0;
      const [uy, uz, vy, vz] = [at(b, 1) - at(a, 1), at(b, 2) - at(a, 2), at(c, 1) - at(a, 1), at(c, 2) - at(a, 2)];
      const [ux, vx] = [at(b, 0) - at(a, 0), at(c, 0) - at(a, 0)];
      const facing = (uy * vz - uz * vy) * at(a, 0) + (uz * vx - ux * vz) * at(a, 1);
      if (facing > 0) outward += 1;
    }
    expect(outward / (index.length / 3)).toBeGreaterThan(0.97);
  });
});
