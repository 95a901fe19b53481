// Where the instrument presses on the wall: the force on any 6 mm of it, as the contact force is
// defined, and the few places where that is largest. Works on the node list of a frame.
import {nodeFields, nodeStride} from '../../wire/frame';

/** Length of instrument over which forces count as one contact. */
export const contactWindow_mm = 6;
/** Below this nothing is shown. */
export const leastForce_n = 0.01;

export interface ContactPlace {
  node: number;
  force_n: number;
}

/** Buffers are reused from frame to frame and grow when a longer instrument comes. */
export class ContactFinder {
  /** Force of the window around each node, N. */
  windowForce_n = new Float32Array(0);
  private arc_mm = new Float32Array(0);
  private taken = new Uint8Array(0);
  readonly places: ContactPlace[];
  placeCount = 0;

  constructor(mostPlaces: number) {
    this.places = Array.from({length: mostPlaces}, () => ({node: 0, force_n: 0}));
  }

  update(nodes: Float32Array, count: number): void {
    if (this.arc_mm.length < count) {
      this.windowForce_n = new Float32Array(count);
      this.arc_mm = new Float32Array(count);
      this.taken = new Uint8Array(count);
    }
    this.measureArc(nodes, count);
    this.sumWindows(nodes, count);
    this.pickPlaces(nodes, count);
  }

  private measureArc(nodes: Float32Array, count: number): void {
    let arc = 0;
    for (let i = 0; i < count; ++i) {
      if (i > 0) {
        const a = (i - 1) * nodeStride;
        const b = i * nodeStride;
        arc += Math.hypot(at(nodes, b) - at(nodes, a), at(nodes, b + 1) - at(nodes, a + 1), at(nodes, b + 2) - at(nodes, a + 2));
      }
      this.arc_mm[i] = arc;
    }
  }

  // Two ends run along the instrument, so that the whole takes one pass.
  private sumWindows(nodes: Float32Array, count: number): void {
    let first = 0;
    let end = 0;
    let sum = 0;
    for (let i = 0; i < count; ++i) {
      const centre = at(this.arc_mm, i);
      while (end < count && at(this.arc_mm, end) <= centre + contactWindow_mm / 2) {
        sum += at(nodes, end * nodeStride + nodeFields.force_n);
        ++end;
      }
      while (at(this.arc_mm, first) < centre - contactWindow_mm / 2) {
        sum -= at(nodes, first * nodeStride + nodeFields.force_n);
        ++first;
      }
      this.windowForce_n[i] = Math.max(0, sum);
    }
  }

  // The strongest first; what lies within two windows of a place taken belongs to it. Of windows with
  // the same sum, the one around the node that presses most.
  private pickPlaces(nodes: Float32Array, count: number): void {
    this.taken.fill(0, 0, count);
    this.placeCount = 0;
    for (const place of this.places) {
      let best = -1;
      let most = leastForce_n;
      for (let i = 0; i < count; ++i) {
        const own = at(nodes, i * nodeStride + nodeFields.force_n);
        const score = at(this.windowForce_n, i) + 1e-3 * own;
        if (!this.taken[i] && score > most) {
          best = i;
          most = score;
        }
      }
      if (best < 0) return;
      place.node = best;
      place.force_n = at(this.windowForce_n, best);
      this.placeCount += 1;
      const centre = at(this.arc_mm, best);
      for (let i = 0; i < count; ++i) {
        if (Math.abs(at(this.arc_mm, i) - centre) < 2 * contactWindow_mm) this.taken[i] = 1;
      }
    }
  }
}

function at(values: Float32Array, index: number): number {
  return values[index] ?? 0;
}
