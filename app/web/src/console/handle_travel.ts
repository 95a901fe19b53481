// The ruler beside the handle and what a drag on it means. Pure.
import type {StepInfo} from '../wire/types';

export interface Travel {
  readonly low_mm: number;
  readonly high_mm: number;
}

const leastSpan_mm = 100;
const margin = 0.08;

/** From the start of the trial over every target, with room behind the last. */
export function travelOf(steps: readonly StepInfo[]): Travel {
  const targets = steps.filter((step) => step.kind === 'translate').map((step) => step.target);
  const low = Math.min(0, ...targets);
  const high = Math.max(0, ...targets);
  const missing = Math.max(0, leastSpan_mm - (high - low));
  const room = Math.max(missing / 2, margin * (high - low));
  return {low_mm: Math.floor((low - room) / 10) * 10, high_mm: Math.ceil((high + room) / 10) * 10};
}

/** Distance from the upper end, 0 to 1; what lies beyond an end stands on it. */
export function placeOn(travel: Travel, axial_mm: number): number {
  const part = (travel.high_mm - axial_mm) / (travel.high_mm - travel.low_mm);
  return Math.max(0, Math.min(1, part));
}

export interface Tick {
  readonly at_mm: number;
  readonly major: boolean;
}

export function ticksOf(travel: Travel): Tick[] {
  const step = travel.high_mm - travel.low_mm > 150 ? 10 : 5;
  const ticks: Tick[] = [];
  for (let at_mm = Math.ceil(travel.low_mm / step) * step; at_mm <= travel.high_mm; at_mm += step) {
    ticks.push({at_mm, major: at_mm % (step * 5) === 0});
  }
  return ticks;
}

export const turnPerPixel_deg = 1;
export const fineDrag = 0.1;
export const wheelNotch_mm = 1;

/** A drag keeps the direction in which it began: a feed does not turn by accident. */
export type DragAxis = 'feed' | 'turn' | null;
const decision_px = 3;

export function axisOf(dx_px: number, dy_px: number): DragAxis {
  if (Math.max(Math.abs(dx_px), Math.abs(dy_px)) < decision_px) return null;
  return Math.abs(dy_px) >= Math.abs(dx_px) ? 'feed' : 'turn';
}
