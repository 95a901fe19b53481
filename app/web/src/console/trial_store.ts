// What the page knows of the running trial. Frames come 60 times a second; React hears of them
// about 12 times a second and at once when something other than a number changed. The picture
// reads `latest` and listens to every frame.
import type {Frame} from '../wire/frame';
import type {Connection} from './live_channel';

export interface TrialSnapshot {
  readonly connection: Connection;
  /** the line was lost at least once and the trial has not been resumed since */
  readonly interrupted: boolean;
  readonly latency_ms: number | null;
  readonly frame: Frame | null;
  /** elapsed time at which each step was done, as far as this page saw it */
  readonly done_s: readonly (number | null)[];
  readonly filed: boolean;
  readonly problem: string | null;
}

const start: TrialSnapshot = {
  connection: 'connecting',
  interrupted: false,
  latency_ms: null,
  frame: null,
  done_s: [],
  filed: false,
  problem: null,
};

export const publishInterval_ms = 80;

export class TrialStore {
  latest: Frame | null = null;
  private snapshot = start;
  private published_ms = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly listeners = new Set<() => void>();
  private readonly frameListeners = new Set<(frame: Frame) => void>();

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getSnapshot = (): TrialSnapshot => this.snapshot;

  onFrame(listener: (frame: Frame) => void): () => void {
    this.frameListeners.add(listener);
    return () => this.frameListeners.delete(listener);
  }

  frame(frame: Frame): void {
    const before = this.latest;
    this.latest = frame;
    for (const listener of this.frameListeners) listener(frame);
    if (this.timer !== undefined) {
      if (!differsInKind(before, frame)) return;
      clearTimeout(this.timer);
      this.timer = undefined;
    }
    const wait_ms = differsInKind(before, frame) ? 0 : this.published_ms + publishInterval_ms - performance.now();
    if (wait_ms <= 0) this.publishFrame();
    else this.timer = setTimeout(() => this.publishFrame(), wait_ms);
  }

  connection(connection: Connection): void {
    const lost = connection === 'lost' && this.latest !== null;
    this.change({
      connection,
      interrupted: this.snapshot.interrupted || lost,
      latency_ms: connection === 'open' ? this.snapshot.latency_ms : null,
    });
  }

  latency(latency_ms: number): void {
    this.change({latency_ms});
  }

  filed(): void {
    this.change({filed: true});
  }

  problem(problem: string | null): void {
    this.change({problem});
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private publishFrame(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.published_ms = performance.now();
    const frame = this.latest;
    if (!frame) return;
    this.change({
      frame,
      filed: this.snapshot.filed || frame.filed,
      interrupted: this.snapshot.interrupted && (frame.paused || this.snapshot.connection !== 'open'),
      done_s: doneTimes(this.snapshot, frame),
    });
  }

  private change(part: Partial<TrialSnapshot>): void {
    this.snapshot = {...this.snapshot, ...part};
    for (const listener of this.listeners) listener();
  }
}

function differsInKind(before: Frame | null, after: Frame): boolean {
  return (
    before === null ||
    before.paused !== after.paused ||
    before.ended !== after.ended ||
    before.filed !== after.filed ||
    before.step_index !== after.step_index
  );
}

// A page opened in the middle of a trial did not see the steps before: their times stay unknown.
function doneTimes(before: TrialSnapshot, frame: Frame): readonly (number | null)[] {
  if (before.done_s.length >= frame.step_index) return before.done_s;
  const done: (number | null)[] = [...before.done_s];
  while (done.length < frame.step_index) {
    const seen = before.frame !== null && done.length === frame.step_index - 1;
    done.push(seen ? frame.elapsed_s : null);
  }
  return done;
}
