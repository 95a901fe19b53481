// Makes a surface lighter for machines that draw in software: vertices that share a cell of a grid
// become one, at their mean. Good enough to look at; nothing is measured on it.
export interface Surface {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly index: Uint32Array;
}

// a grid of cell c meets a surface in about this many triangles per c^2 of it
const trianglesPerCell = 3.5;

/** The surface as it is when it has no more than `most` triangles. */
export function thinned(surface: Surface, most: number): Surface {
  if (surface.index.length / 3 <= most) return surface;
  const cell = Math.sqrt((trianglesPerCell * areaOf(surface)) / most);
  return cell > 0 ? clustered(surface, cell) : surface;
}

function clustered({positions, normals, index}: Surface, cell: number): Surface {
  const clusters = new Map<string, number>();
  const clusterOf = new Uint32Array(positions.length / 3);
  const sums: number[] = [];  // x, y, z, nx, ny, nz, count
  for (let vertex = 0; vertex < clusterOf.length; ++vertex) {
    const start = vertex * 3;
    const key = [0, 1, 2].map((axis) => Math.floor((positions[start + axis] ?? 0) / cell)).join(' ');
    let cluster = clusters.get(key);
    if (cluster === undefined) {
      cluster = clusters.size;
      clusters.set(key, cluster);
      sums.push(0, 0, 0, 0, 0, 0, 0);
    }
    clusterOf[vertex] = cluster;
    for (let axis = 0; axis < 3; ++axis) {
      sums[cluster * 7 + axis] = (sums[cluster * 7 + axis] ?? 0) + (positions[start + axis] ?? 0);
      sums[cluster * 7 + 3 + axis] = (sums[cluster * 7 + 3 + axis] ?? 0) + (normals[start + axis] ?? 0);
    }
    sums[cluster * 7 + 6] = (sums[cluster * 7 + 6] ?? 0) + 1;
  }
  return {...means(sums, clusters.size), index: keptTriangles(index, clusterOf)};
}

function means(sums: readonly number[], count: number): Pick<Surface, 'positions' | 'normals'> {
  const positions = new Float32Array(count * 3);
  const normals = new Float32Array(count * 3);
  for (let cluster = 0; cluster < count; ++cluster) {
    const at = (offset: number) => sums[cluster * 7 + offset] ?? 0;
    const length = Math.hypot(at(3), at(4), at(5)) || 1;
    for (let axis = 0; axis < 3; ++axis) {
      positions[cluster * 3 + axis] = at(axis) / at(6);
      normals[cluster * 3 + axis] = at(3 + axis) / length;
    }
  }
  return {positions, normals};
}

// those whose corners fell into three different cells
function keptTriangles(index: Uint32Array, clusterOf: Uint32Array): Uint32Array {
  const kept = new Uint32Array(index.length);
  let length = 0;
  for (let i = 0; i + 2 < index.length; i += 3) {
    const a = clusterOf[index[i] ?? 0] ?? 0;
    const b = clusterOf[index[i + 1] ?? 0] ?? 0;
    const c = clusterOf[index[i + 2] ?? 0] ?? 0;
    if (a === b || b === c || c === a) continue;
    kept.set([a, b, c], length);
    length += 3;
  }
  return kept.slice(0, length);
}

function areaOf({positions, index}: Surface): number {
  let area = 0;
  const p = (vertex: number, axis: number) => positions[vertex * 3 + axis] ?? 0;
  for (let i = 0; i + 2 < index.length; i += 3) {
    const [a, b, c] = [index[i] ?? 0, index[i + 1] ?? 0, index[i + 2] ?? 0];
    const [ux, uy, uz] = [p(b, 0) - p(a, 0), p(b, 1) - p(a, 1), p(b, 2) - p(a, 2)];
    const [vx, vy, vz] = [p(c, 0) - p(a, 0), p(c, 1) - p(a, 1), p(c, 2) - p(a, 2)];
    area += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
  }
  return area;
}
