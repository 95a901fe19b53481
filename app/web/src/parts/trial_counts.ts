// How many trials there are, by what they are good for, and how they ended. The three numbers are the
// same everywhere; the sentences beside them say what they count.
import type {TrialRow} from '../wire/types';

export interface TrialCounts {
  started: number;
  valid: number;
  counted: number;
}

export const countDefinitions: Readonly<Record<keyof TrialCounts, string>> = {
  started: 'Every trial begun, also those that run, were cut off or voided.',
  valid: 'Of these: ended and judged, and not voided.',
  counted: 'Of these: without an interruption. They decide on proficiency.',
};

const isValid = (trial: TrialRow) => !trial.voided && (trial.outcome === 'passed' || trial.outcome === 'not_passed');

export function countTrials(trials: readonly TrialRow[]): TrialCounts {
  const valid = trials.filter(isValid);
  return {started: trials.length, valid: valid.length, counted: valid.filter((trial) => !trial.interrupted).length};
}

export interface TrialErrors {
  /** trials that have ended and were not voided: what the rest is a part of */
  ended: number;
  /** of these, by the way they ended; most frequent first, without those that completed */
  ends: {reason: NonNullable<TrialRow['end_reason']>; count: number}[];
  withCritical: number;
  critical: number;
}

/** What went wrong, how often, among trials that ended and were not voided. */
export function countErrors(trials: readonly TrialRow[]): TrialErrors {
  const ended = trials.filter((trial) => trial.end_reason !== null && !trial.voided);
  const counts = new Map<NonNullable<TrialRow['end_reason']>, number>();
  for (const {end_reason} of ended) {
    if (end_reason !== null && end_reason !== 'completed') counts.set(end_reason, (counts.get(end_reason) ?? 0) + 1);
  }
  return {
    ended: ended.length,
    ends: [...counts].map(([reason, count]) => ({reason, count})).sort((a, b) => b.count - a.count),
    withCritical: ended.filter((trial) => trial.critical_errors > 0).length,
    critical: ended.reduce((sum, trial) => sum + trial.critical_errors, 0),
  };
}
