// Cuts a surface into pieces that lie together, so that what is out of the picture need not be drawn.
import type {Surface} from './mesh_thinning';

export interface Chunk {
  readonly index: Uint32Array;   // into the vertices of the surface
  readonly centre: readonly [number, number, number];
  readonly radius: number;
}

/** One piece for each cube of `size` that holds the first corner of a triangle. Every triangle is in one piece. */
export function chunksOf({positions, index}: Surface, size: number): Chunk[] {
  const corners = new Map<string, number[]>();
  for (let i = 0; i + 2 < index.length; i += 3) {
    const start = (index[i] ?? 0) * 3;
    const key = [0, 1, 2].map((axis) => Math.floor((positions[start + axis] ?? 0) / size)).join(' ');
    const list = corners.get(key) ?? [];
    if (list.length === 0) corners.set(key, list);
    list.push(index[i] ?? 0, index[i + 1] ?? 0, index[i + 2] ?? 0);
  }
  return [...corners.values()].map((list) => ({index: new Uint32Array(list), ...sphereAround(positions, list)}));
}

// around the middle of the box: not the smallest, but close
function sphereAround(positions: Float32Array, vertices: readonly number[]): Pick<Chunk, 'centre' | 'radius'> {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const vertex of vertices) {
    for (let axis = 0; axis < 3; ++axis) {
      const value = positions[vertex * 3 + axis] ?? 0;
      low[axis] = Math.min(low[axis] ?? value, value);
      high[axis] = Math.max(high[axis] ?? value, value);
    }
  }
  const middle = (axis: number) => ((low[axis] ?? 0) + (high[axis] ?? 0)) / 2;
  const centre = [middle(0), middle(1), middle(2)] as const;
  const radius = Math.hypot(...[0, 1, 2].map((axis) => ((high[axis] ?? 0) - (low[axis] ?? 0)) / 2));
  return {centre, radius};
}
