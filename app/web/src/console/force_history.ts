// The largest contact force in each tenth of a second, for the last half minute of simulated time.
// A peak shorter than a pixel stays visible.
export const binLength_s = 0.1;
export const binCount = 300;

export class ForceHistory {
  private readonly bins = new Float32Array(binCount);
  private last = -1;   // number of the newest bin, counted from the start of the trial
  private first = 0;   // number of the oldest that was seen

  /** False when the bin shown last did not change. */
  push(time_s: number, force_n: number): boolean {
    const bin = Math.floor(time_s / binLength_s);
    if (bin < this.last) return false;
    if (this.last < 0) this.first = bin;
    const isNew = bin > this.last;
    for (let empty = Math.max(this.last + 1, bin - binCount + 1); empty <= bin; ++empty) this.bins[empty % binCount] = 0;
    this.last = bin;
    const slot = bin % binCount;
    const higher = force_n > (this.bins[slot] ?? 0);
    if (higher) this.bins[slot] = force_n;
    return isNew || higher;
  }

  /** Force `age` bins ago; null before what was seen. */
  at(age: number): number | null {
    const bin = this.last - age;
    if (age < 0 || age >= binCount || bin < this.first || this.last < 0) return null;
    return this.bins[bin % binCount] ?? null;
  }
}
