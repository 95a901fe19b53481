// The instrument between the last two frames, so that the picture moves evenly although frames
// come when they come. Nodes are matched from the tip: what grows and shrinks is the end at the access.
import {type Frame, nodeStride} from '../../wire/frame';

const usualInterval_ms = 1000 / 60;
const longestInterval_ms = 100;

export class NodeInterpolation {
  /** node_count x (x, y, z, force) of the moment asked for. */
  nodes = new Float32Array(0);
  count = 0;
  private before: Frame | null = null;
  private last: Frame | null = null;
  private arrived_ms = 0;
  private interval_ms = usualInterval_ms;
  private shown = -1;

  push(frame: Frame, now_ms: number): void {
    if (this.last?.step === frame.step) return;  // the simulation stands still
    if (this.last) {
      const gap = Math.min(longestInterval_ms, Math.max(1, now_ms - this.arrived_ms));
      this.interval_ms += 0.1 * (gap - this.interval_ms);
    }
    this.before = this.last ?? frame;
    this.last = frame;
    this.arrived_ms = now_ms;
    this.shown = -1;
  }

  /** Fills `nodes`; false when nothing changed since the last call. */
  sample(now_ms: number): boolean {
    const {before, last} = this;
    if (!before || !last) return false;
    const part = Math.min(1, (now_ms - this.arrived_ms) / this.interval_ms);
    if (part === this.shown) return false;
    this.shown = part;
    this.mix(before, last, Math.max(0, part));
    return true;
  }

  private mix(before: Frame, last: Frame, part: number): void {
    const length = last.node_count * nodeStride;
    if (this.nodes.length < length) this.nodes = new Float32Array(Math.ceil(length * 1.5));
    this.count = last.node_count;
    const shift = length - before.node_count * nodeStride;
    for (let i = 0; i < length; ++i) {
      const to = last.nodes[i] ?? 0;
      const from = i - shift >= 0 ? (before.nodes[i - shift] ?? to) : to;
      this.nodes[i] = from + (to - from) * part;
    }
  }
}
