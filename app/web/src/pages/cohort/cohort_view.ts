// What the grid shows of a cohort: who matches, in the server's order, and what a cell says.
import {lookOf} from '../../parts/State';
import {formatCount, formatWhen} from '../../parts/format';
import {levelWord} from '../../parts/PersonFacts';
import type {Cohort, CohortRow} from '../../wire/types';

export type CohortExercise = Cohort['exercises'][number];
export type CohortCell = CohortRow['cells'][number];

/** Those whose name, group or reason holds every word looked for. */
export function matching(people: readonly CohortRow[], search: string): CohortRow[] {
  const words = search.trim().toLowerCase().split(/\s+/).filter((word) => word !== '');
  return people.filter((person) => {
    const text = [person.display_name, ...person.groups, person.why].join(' ').toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

/** How many at the top need help; the server puts them first. */
export function helpCount(people: readonly CohortRow[]): number {
  const end = people.findIndex((person) => !person.needs_help);
  return end < 0 ? people.length : end;
}

/** Everything a cell stands for, in words. */
export function cellSentence(cell: CohortCell): string {
  if (cell === null) return 'Not part of this person\u2019s curriculum.';
  const sentence = cell.sentence === '' || /[.!?]$/.test(cell.sentence) ? cell.sentence : `${cell.sentence}.`;
  return [`${lookOf(cell.status).word}.`, sentence, `${formatCount(cell.trials, 'trial')}.`].filter((part) => part !== '').join(' ');
}

/** The line under a name. */
export function personFacts(person: CohortRow, now: Date = new Date()): string {
  const parts = [`level ${levelWord(person.level)}`, formatCount(person.trials, 'trial')];
  if (person.last_trial_utc !== null) parts.push(`last ${formatWhen(person.last_trial_utc, now)}`);
  return parts.join(' · ');
}

export interface GridShape {
  /** px */
  readonly person: number;
  readonly now: number;
  readonly cell: number;
  /** sign over short word, the sentence in the line below the grid */
  readonly compact: boolean;
}

const widestCell = 240;
const roomyCell = 148;
const compactCell = 72;

/** How wide the grid may grow: a desk page, or as many columns as want to be read. */
export function widestGrid(exercises: number): number {
  return Math.max(1280, 272 + 96 + exercises * widestCell);
}

/** Divides the width: whole words with their sentence where there is room, sign over short word where not. */
export function shapeOf(width: number, exercises: number): GridShape {
  const person = width < 900 ? 184 : 272;
  const now = width < 900 ? 84 : 96;
  const room = (width - person - now) / Math.max(1, exercises);
  if (room >= roomyCell) return {person, now, cell: Math.min(widestCell, Math.floor(room)), compact: false};
  return {person, now, cell: Math.max(compactCell, Math.floor(room)), compact: true};
}
