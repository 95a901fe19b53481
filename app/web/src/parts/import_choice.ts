// What an administrator can do with a looked-at file, in words.
import type {ImportPreview, ImportRow} from '../wire/types';
import {formatCount} from './format';

export interface ImportChoice {
  /** The words on the button. */
  action: string;
  possible: boolean;
  /** Why not, or what the button leaves out. */
  sentence: string;
  skipBroken: boolean;
}

export function importChoice(preview: ImportPreview): ImportChoice {
  const right = preview.add + preview.change;
  const skipBroken = preview.broken > 0;
  const no = (sentence: string): ImportChoice => ({action: 'Import', possible: false, sentence, skipBroken});
  if (preview.problems.length > 0) return no('Nothing can be imported from this file. Mend it and choose it again.');
  if (preview.rows.length === 0) return no('The file has no row of a person under its headings.');
  if (right === 0) {
    return no(skipBroken ? 'No row can be imported. Mend the file and choose it again.' : 'Everybody is stored like this already; there is nothing to do.');
  }
  const rows = formatCount(right, 'row');
  if (!skipBroken) return {action: `Import ${rows}`, possible: true, sentence: 'Everybody new gets a one-time link, shown once.', skipBroken};
  return {
    action: `Import the ${right} right ${right === 1 ? 'row' : 'rows'}, leave out ${preview.broken}`, possible: true, skipBroken,
    sentence: `Or mend the ${formatCount(preview.broken, 'row')} and choose the file again: nothing has been changed yet.`,
  };
}

const order: readonly ImportRow['action'][] = ['broken', 'add', 'change', 'unchanged'];

/** What needs a look first, then as in the file. */
export function orderRows(rows: readonly ImportRow[]): ImportRow[] {
  return [...rows].sort((a, b) => order.indexOf(a.action) - order.indexOf(b.action) || a.line - b.line);
}

export const importColumns: readonly (readonly [string, string])[] = [
  ['name', 'what the person signs in with'],
  ['display_name', 'the name that others see'],
  ['email', 'may be empty'],
  ['role', 'trainee, instructor, administrator or researcher'],
  ['level', 'novice, intermediate or expert'],
  ['cases', 'procedures done so far'],
  ['groups', 'names with | between them'],
  ['curriculum', 'an id; empty for the default'],
];

export const importTemplate: readonly (readonly string[])[] = [
  importColumns.map(([name]) => name),
  ['resident14', 'Resident 14', '', 'trainee', 'novice', '0', '2026|Night shift', ''],
  ['instructor3', 'Instructor 3', '', 'instructor', '', '', '2026', ''],
];
