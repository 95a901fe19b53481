// Sends what the hand does: at once when it changes, and never more often than the server draws.
// Moves of the mouse add up until they are sent, so that none is lost.
import type {HandleMessage} from '../wire/types';
import {type HandleRates, stillRates} from './handle_keys';

export const sendInterval_ms = 1000 / 60;

// What one message may carry, from the wire schema; the rest follows in the next one.
const moveBound_mm = 50;
const rotateBound_deg = 360;

export class HandleSender {
  private rates: HandleRates = stillRates;
  private sentRates: HandleRates = stillRates;
  private move_mm = 0;
  private rotate_deg = 0;
  private lastSent_ms = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `send` says whether the message went out; one that did not is forgotten, not kept for later. */
  constructor(private readonly send: (message: HandleMessage) => boolean) {}

  setRates(rates: HandleRates): void {
    this.rates = rates;
    this.schedule();
  }

  addMove(move_mm: number, rotate_deg: number): void {
    this.move_mm += move_mm;
    this.rotate_deg += rotate_deg;
    this.schedule();
  }

  /** Stops the hand now, whatever was still to be sent. */
  release(): void {
    this.move_mm = 0;
    this.rotate_deg = 0;
    this.rates = stillRates;
    if (this.isDue()) this.flush();
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private isDue(): boolean {
    return (
      this.rates.feed_mm_s !== this.sentRates.feed_mm_s ||
      this.rates.turn_deg_s !== this.sentRates.turn_deg_s ||
      this.move_mm !== 0 ||
      this.rotate_deg !== 0
    );
  }

  private schedule(): void {
    if (this.timer !== undefined || !this.isDue()) return;
    const wait_ms = this.lastSent_ms + sendInterval_ms - performance.now();
    if (wait_ms <= 0) this.flush();
    else this.timer = setTimeout(() => this.flush(), Math.ceil(wait_ms));
  }

  private flush(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    if (!this.isDue()) return;
    const move_mm = bounded(this.move_mm, moveBound_mm);
    const rotate_deg = bounded(this.rotate_deg, rotateBound_deg);
    const message: HandleMessage = {type: 'handle', ...this.rates};
    if (move_mm !== 0) message.move_mm = move_mm;
    if (rotate_deg !== 0) message.rotate_deg = rotate_deg;
    this.lastSent_ms = performance.now();
    if (this.send(message)) {
      this.sentRates = this.rates;
      this.move_mm -= move_mm;
      this.rotate_deg -= rotate_deg;
      this.schedule();
    } else {
      // the server stops the hand when the line drops
      this.sentRates = this.rates = stillRates;
      this.move_mm = this.rotate_deg = 0;
    }
  }
}

function bounded(value: number, bound: number): number {
  return Math.max(-bound, Math.min(bound, value));
}
