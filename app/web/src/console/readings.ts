// Turns a frame and the briefing into what the panels show: words, fractions, levels. No drawing,
// and no judgement: whether a limit is broken and a step is done is the server's word.
import {unitWord} from '../parts/format';
import type {Frame} from '../wire/frame';
import type {Briefing, LimitInfo, StepInfo} from '../wire/types';

export type Level = 'ok' | 'near' | 'over';

/** From this part of a limit on, the words "near limit" join. */
export const nearLimit = 0.8;

const minusSign = '\u2212';

/** With a true minus sign, and no minus before zero. */
export function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return text.startsWith('-') ? (Number(text) === 0 ? text.slice(1) : minusSign + text.slice(1)) : text;
}

export function signedFixed(value: number, digits: number): string {
  const text = fixed(value, digits);
  return Number(value.toFixed(digits)) > 0 ? `+${text}` : text;
}

/** Rounded, but never so that a value within its bound reads as beyond it or the other way round. */
export function fixedAgainst(value: number, bound: number, digits: number): string {
  const rounded = Number(value.toFixed(digits));
  const unit = 10 ** -digits;
  if (value > bound && rounded <= bound) return fixed(Math.floor(bound / unit + 1e-6) * unit + unit, digits);
  if (value < bound && rounded >= bound) return fixed(Math.ceil(bound / unit - 1e-6) * unit - unit, digits);
  return fixed(value, digits);
}

const digitsOf: Record<string, number> = {N: 2, 'N mm': 1, 'N s': 1, mm: 1, s: 1};

/** Always the same number of decimals for a unit, so that the digits of an instrument stand still. */
export function digitsFor(unit: string): number {
  return digitsOf[unitWord(unit)] ?? 0;
}

/** As written behind a number: a degree sign stands close to it. */
export function unitSuffix(unit: string): string {
  const word = unitWord(unit);
  return word === '' || word === '°' ? word : `\u00a0${word}`;
}

export type StepAsk = 'feed' | 'retract' | 'clockwise' | 'counter-clockwise' | 'hold' | 'done';

export interface StepReading {
  readonly title: string;
  /** 212.4 mm */
  readonly value: string;
  readonly raw: number;
  readonly ask: StepAsk;
  /** One sentence: what is still to do. */
  readonly sentence: string;
  /** Filled part of the bar, and the goal with its tolerance on it; all 0 to 1. */
  readonly fraction: number;
  readonly goal: number;
  readonly goalLow: number;
  readonly goalHigh: number;
  /** Part of the hold time done, 0 to 1; null when the step asks for none or it has not begun. */
  readonly held: number | null;
}

const goalMark = 0.9;  // where the goal stands on the bar: behind it there is room for overshoot

export function readStep(step: StepInfo, frame: Frame): StepReading {
  return step.kind === 'hold' ? readHold(step, frame) : readMovement(step, frame);
}

function readHold(step: StepInfo, frame: Frame): StepReading {
  const asked_s = Math.max(step.target, step.hold_s);
  const part = asked_s > 0 ? Math.min(1, frame.held_s / asked_s) : 1;
  return {
    title: step.title,
    value: `${fixed(frame.held_s, 1)}${unitSuffix('s')}`,
    raw: frame.held_s,
    ask: 'hold',
    sentence: `Keep still: ${fixed(frame.held_s, 1)} of ${fixed(asked_s, 1)} s`,
    fraction: part * goalMark,
    goal: goalMark,
    goalLow: goalMark,
    goalHigh: goalMark,
    held: part,
  };
}

function readMovement(step: StepInfo, frame: Frame): StepReading {
  const way = step.target - frame.step_start;
  const left = step.target - frame.step_value;
  const span = Math.max(Math.abs(way), 4 * step.tolerance, 1e-6);
  const sense = way < 0 ? -1 : 1;
  const tolerance = (step.tolerance / span) * goalMark;
  const within = Math.abs(left) <= step.tolerance;
  const digits = digitsFor(step.unit);
  return {
    title: step.title,
    value: `${fixed(frame.step_value, digits)}${unitSuffix(step.unit)}`,
    raw: frame.step_value,
    ask: within ? 'hold' : askFor(step, left),
    sentence: within ? holdSentence(step, frame) : wayLeft(step, left),
    fraction: unitInterval(goalMark * (1 - (sense * left) / span)),
    goal: goalMark,
    goalLow: unitInterval(goalMark - tolerance),
    goalHigh: unitInterval(goalMark + tolerance),
    held: within && step.hold_s > 0 ? unitInterval(frame.held_s / step.hold_s) : null,
  };
}

function askFor(step: StepInfo, left: number): StepAsk {
  if (step.kind === 'rotate') return left > 0 ? 'clockwise' : 'counter-clockwise';
  return left > 0 ? 'feed' : 'retract';
}

const askWords: Record<Exclude<StepAsk, 'hold' | 'done'>, string> = {
  feed: 'Feed',
  retract: 'Retract',
  clockwise: 'Turn clockwise',
  'counter-clockwise': 'Turn counter-clockwise',
};

// The way left is to the target, so that the sentence and the mark on the bar say the same.
function wayLeft(step: StepInfo, left: number): string {
  const ask = askFor(step, left);
  const digits = digitsFor(step.unit);
  const word = ask === 'hold' || ask === 'done' ? '' : askWords[ask];
  return `${word} ${fixed(Math.abs(left), digits)}${unitSuffix(step.unit)} more`;
}

function holdSentence(step: StepInfo, frame: Frame): string {
  const inside = `Within ±${fixed(step.tolerance, 0)}${unitSuffix(step.unit)}.`;
  if (step.hold_s <= 0) return inside;
  return `${inside} Hold still: ${fixed(frame.held_s, 1)} of ${fixed(step.hold_s, 1)} s`;
}

/** The rows of the step list around the current step: at most `rows`, the current one among them. */
export function visibleSteps(count: number, current: number, rows: number): {first: number; last: number} {
  const first = Math.max(0, Math.min(current - 1, count - rows));
  return {first, last: Math.min(count, first + rows)};
}

export interface GaugeReading {
  readonly value: number;
  readonly peak: number;
  readonly limit: number | null;
  /** End of the scale, beyond the limit when there is one. */
  readonly scale: number;
  readonly level: Level;
}

/** A gauge without a limit takes the smallest scale of a fixed row that holds its peak. */
export function readGauge(value: number, peak: number, limit: number | null, scales: readonly number[]): GaugeReading {
  const size = Math.abs(value);
  const level: Level = limit === null || size < nearLimit * limit ? 'ok' : size < limit ? 'near' : 'over';
  const largest = Math.max(size, Math.abs(peak));
  const scale = limit !== null ? (limit * 4) / 3 : (scales.find((end) => largest <= end) ?? largest);
  return {value, peak: Math.abs(peak), limit, scale, level};
}

/** The bound on a metric, when the exercise has one that must not be exceeded. */
export function limitOn(limits: readonly LimitInfo[], metric: string): number | null {
  return limits.find((limit) => limit.metric === metric && limit.op.startsWith('<'))?.value ?? null;
}

export interface LimitReading {
  readonly title: string;
  readonly value: string;
  readonly bound: string;
  readonly fraction: number;
  readonly level: Level;
  readonly consequence: string;
}

const consequenceWords: Record<LimitInfo['on_breach'], string> = {
  mark: 'noted',
  fail: 'not passed',
  critical_error: 'critical error',
  stop: 'trial ends',
};

export function readLimits(briefing: Briefing, frame: Frame): LimitReading[] {
  return briefing.limits.map((limit, index) => {
    const state = frame.limits[index];
    const value = state?.value ?? 0;
    const digits = digitsFor(limit.unit);
    const fraction = limit.value > 0 ? unitInterval(value / limit.value) : 0;
    const near = limit.op.startsWith('<') && fraction >= nearLimit;
    return {
      title: limit.title,
      value: fixedAgainst(value, limit.value, digits),
      bound: `${fixed(limit.value, digits)}${unitSuffix(limit.unit)}`,
      fraction,
      level: state?.breached ? 'over' : near ? 'near' : 'ok',
      consequence: consequenceWords[limit.on_breach],
    };
  });
}

export interface Alarm {
  readonly level: Level;
  readonly text: string;
  /** Without the number, which would be read out again and again; empty while all is well. */
  readonly spoken: string;
}

/** The one line that names what is wrong: the worst first. */
export function readAlarm(gauges: readonly {name: string; unit: string; reading: GaugeReading}[], limits: readonly LimitReading[]): Alarm {
  for (const level of ['over', 'near'] as const) {
    for (const {name, unit, reading} of gauges) {
      if (reading.level !== level || reading.limit === null) continue;
      const digits = digitsFor(unit);
      const value = fixedAgainst(Math.abs(reading.value), reading.limit, digits);
      const bound = `${fixed(reading.limit, digits)}${unitSuffix(unit)}`;
      const spoken = level === 'over' ? `${name}: limit reached` : `${name} near limit`;
      return {level, text: `${name} ${value}, limit ${bound}`, spoken};
    }
  }
  const broken = limits.find((limit) => limit.level === 'over');
  if (broken) {
    const text = `${broken.title} was exceeded`;
    return {level: 'near', text, spoken: text};
  }
  return {level: 'ok', text: 'No alarm', spoken: ''};
}

const endSentences: Record<NonNullable<Frame['end_reason']>, string> = {
  completed: 'All steps are done.',
  timeout: 'The time limit was reached.',
  limit: 'A limit that ends the trial was exceeded.',
  aborted: 'The trial was ended before all steps were done.',
  diverged: 'The simulation could not go on; the trial is filed as invalid.',
};

export function endSentence(frame: Frame): string {
  return frame.end_reason ? endSentences[frame.end_reason] : '';
}

function unitInterval(value: number): number {
  return Math.max(0, Math.min(1, value));
}
