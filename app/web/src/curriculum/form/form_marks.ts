// Which field of the form a problem belongs to: the place of the tree where it stands in the text.
import {nodeAt, pathAt, type Path, type Source, type Value, valueIn} from '../yaml/source';
import type {Mark} from '../text/marks';

export interface FormMark {
  readonly path: Path;
  readonly mark: Mark;
  readonly line: number;
}

export function formMarks(source: Source, marks: readonly Mark[], lineOf: (offset: number) => number): FormMark[] {
  return marks.map((mark) => ({path: markPath(source, mark), mark, line: lineOf(mark.from)}));
}

/** "a limit needs 'metric': add it" stands where the limit begins, but belongs to the field that is empty. */
export function markPath(source: Source, mark: Mark): Path {
  const path = pathAt(source, mark.from);
  const missing = /^[^']* needs '([\w-]+)': add it$/.exec(mark.problem.message)?.[1]
    ?? /^'[^']*' needs '([\w-]+)': add it$/.exec(mark.problem.message)?.[1];
  if (missing === undefined) return path;
  // a block begins at its first key, so that the deepest place there may be inside of what is meant
  for (let depth = path.length; depth >= 0; --depth) {
    const above = path.slice(0, depth);
    const value: Value | undefined = valueIn(source.value, above);
    const isMap = typeof value === 'object' && value !== null && !Array.isArray(value);
    if (isMap && !(missing in value) && (depth === 0 || (nodeAt(source, above)?.range?.[0] ?? -1) === mark.from)) return [...above, missing];
  }
  return path;
}

export function isWithin(path: Path, group: Path): boolean {
  return group.every((key, index) => path[index] === key);
}

/** The marks of a group that none of its own fields shows. */
export function leftOver(marks: readonly FormMark[], group: Path, fields: readonly string[]): FormMark[] {
  return marks.filter((one) => isWithin(one.path, group) && !fields.includes(String(one.path[group.length] ?? '')));
}
