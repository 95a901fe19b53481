import {describe, expect, it} from 'vitest';
import {chunksOf} from './mesh_chunks';
import type {Surface} from './mesh_thinning';

// a ribbon of 50 squares of 2 mm along x
function ribbon(): Surface {
  const positions: number[] = [];
  const index: number[] = [];
  for (let i = 0; i <= 50; ++i) positions.push(2 * i, 0, 0, 2 * i, 2, 0);
  for (let i = 0; i < 50; ++i) index.push(2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3);
  return {positions: new Float32Array(positions), normals: new Float32Array(positions.length), index: new Uint32Array(index)};
}

describe('the pieces of a surface', () => {
  const surface = ribbon();
  const chunks = chunksOf(surface, 20);

  it('are as many as the surface crosses cubes, and hold each triangle once', () => {
    expect(chunks).toHaveLength(5);
    const triangles = (index: Uint32Array) =>
      Array.from({length: index.length / 3}, (_, i) => index.slice(3 * i, 3 * i + 3).join());
    expect(chunks.flatMap((chunk) => triangles(chunk.index)).sort()).toEqual(triangles(surface.index).sort());
  });

  it('lie within their spheres', () => {
    for (const {index, centre, radius} of chunks) {
      for (const vertex of index) {
        const away = [0, 1, 2].map((axis) => (surface.positions[vertex * 3 + axis] ?? 0) - (centre[axis] ?? 0));
        expect(Math.hypot(...away)).toBeLessThanOrEqual(radius + 1e-6);
      }
      expect(radius).toBeLessThan(12);
    }
  });
});
