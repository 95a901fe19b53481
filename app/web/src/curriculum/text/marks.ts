// The problems of a curriculum where they stand in the text. They come from the server for the text
// as it was sent; what is typed since then moves them along.
import {RangeSet, RangeSetBuilder, StateEffect, StateField, type EditorState, type Text} from '@codemirror/state';
import {Decoration, type DecorationSet, EditorView, gutter, GutterMarker, WidgetType} from '@codemirror/view';
import type {CurriculumProblem} from '../../wire/types';
import {sentenceOf, signPath} from './problem_words';

export interface Mark {
  readonly problem: CurriculumProblem;
  readonly from: number;
  readonly to: number;
  /** start of the line that the repair replaces */
  readonly repairAt: number;
}

export const setMarks = StateEffect.define<readonly Mark[]>();

/** Where the checker's lines and columns are in this text; columns count characters, not code units. */
export function placeProblems(doc: Text, problems: readonly CurriculumProblem[]): Mark[] {
  return problems.map((problem) => {
    const line = doc.line(clamp(problem.line, 1, doc.lines));
    const before = [...line.text].slice(0, Math.max(0, problem.column - 1)).join('').length;
    const from = Math.min(line.to, line.from + before);
    const rest = line.text.slice(from - line.from);
    const word = /^("(?:[^"\\]|\\.)*"|'[^']*'|[^\s,{}[\]#]+:?|[{[]\S*)/.exec(rest)?.[0] ?? rest.slice(0, 1);
    const repairAt = doc.line(clamp(problem.repair?.line ?? problem.line, 1, doc.lines)).from;
    return {problem, from, to: Math.max(from, Math.min(line.to, from + word.replace(/:$/, '').length)), repairAt};
  });
}

function clamp(value: number, low: number, high: number): number {
  return Math.max(low, Math.min(high, value));
}

export const marksField = StateField.define<readonly Mark[]>({
  create: () => [],
  update(marks, transaction) {
    let next = marks;
    if (transaction.docChanged) {
      next = next.map((mark) => ({
        ...mark,
        from: transaction.changes.mapPos(mark.from, 1),
        to: transaction.changes.mapPos(mark.to, -1),
        repairAt: transaction.changes.mapPos(mark.repairAt, -1),
      }));
    }
    for (const effect of transaction.effects) if (effect.is(setMarks)) next = effect.value;
    return next;
  },
});

class SentenceBelow extends WidgetType {
  constructor(private readonly line: number, private readonly problems: readonly CurriculumProblem[]) {
    super();
  }

  override eq(other: SentenceBelow): boolean {
    return other.line === this.line && other.problems.length === this.problems.length
      && other.problems.every((problem, index) => problem === this.problems[index]);
  }

  override toDOM(view: EditorView): HTMLElement {
    const box = element('div', 'cm-sentences');
    for (const problem of this.problems) {
      const row = element('div', `cm-sentence cm-${problem.severity}`);
      const where = element('b', '', `${problem.severity === 'error' ? 'Line' : 'Warning, line'} ${this.line}.`);
      row.append(where, ` ${sentenceOf(problem.message)} `);
      if (problem.repair) {
        const button = element('button', 'cm-repair', problem.repair.title);
        button.setAttribute('type', 'button');
        button.addEventListener('click', () => applyRepair(view, problem));
        row.append(button);
      }
      box.append(row);
    }
    return box;
  }

  override ignoreEvent(): boolean {
    return true;
  }
}

/** Mends a problem as the server proposed; false when its line was changed since. */
export function applyRepair(view: EditorView, problem: CurriculumProblem): boolean {
  const mark = view.state.field(marksField).find((one) => one.problem === problem);
  if (!mark || !problem.repair || view.state.readOnly) return false;
  const line = view.state.doc.lineAt(mark.repairAt);
  if (line.text !== problem.repair.before) return false;
  view.dispatch({changes: {from: line.from, to: line.to, insert: problem.repair.after}, userEvent: 'input.repair', scrollIntoView: true});
  return true;
}

function element(tag: string, className: string, text = ''): HTMLElement {
  const made = document.createElement(tag);
  if (className !== '') made.className = className;
  made.textContent = text;
  return made;
}

const squiggles = {error: Decoration.mark({class: 'cm-squiggle cm-error'}), warning: Decoration.mark({class: 'cm-squiggle cm-warning'})};
const lines = {error: Decoration.line({class: 'cm-line-error'}), warning: Decoration.line({class: 'cm-line-warning'})};

interface OnLine {
  from: number;
  to: number;
  number: number;
  marks: Mark[];
}

function byLine(state: EditorState): OnLine[] {
  const found = new Map<number, OnLine>();
  for (const mark of state.field(marksField)) {
    const line = state.doc.lineAt(mark.from);
    const entry = found.get(line.number) ?? {from: line.from, to: line.to, number: line.number, marks: []};
    entry.marks.push(mark);
    found.set(line.number, entry);
  }
  return [...found.values()].sort((a, b) => a.number - b.number);
}

const worst = (marks: readonly Mark[]) => (marks.some((mark) => mark.problem.severity === 'error') ? 'error' : 'warning');

const drawn = EditorView.decorations.compute([marksField, 'doc'], (state): DecorationSet => {
  const ranges = byLine(state).flatMap((line) => [
    lines[worst(line.marks)].range(line.from),
    ...line.marks.filter((mark) => mark.to > mark.from).map((mark) => squiggles[mark.problem.severity].range(mark.from, mark.to)),
    Decoration.widget({
      widget: new SentenceBelow(line.number, line.marks.map((mark) => mark.problem)), block: true, side: 1,
    }).range(line.to),
  ]);
  return Decoration.set(ranges, true);
});

class Sign extends GutterMarker {
  constructor(private readonly severity: 'error' | 'warning') {
    super();
  }

  override eq(other: Sign): boolean {
    return other.severity === this.severity;
  }

  override toDOM(): Node {
    const sign = element('span', `cm-sign cm-${this.severity}`);
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', '0 0 16 16');
    svg.setAttribute('class', 'icon');
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('d', signPath(this.severity));
    svg.append(path);
    sign.append(svg);
    return sign;
  }
}

const signs = {error: new Sign('error'), warning: new Sign('warning')};

const signGutter = gutter({
  class: 'cm-signs',
  markers: (view) => {
    const builder = new RangeSetBuilder<GutterMarker>();
    for (const line of byLine(view.state)) builder.add(line.from, line.from, signs[worst(line.marks)]);
    const set: RangeSet<GutterMarker> = builder.finish();
    return set;
  },
  initialSpacer: () => signs.error,
});

export const problemMarks = [marksField, drawn, signGutter];
