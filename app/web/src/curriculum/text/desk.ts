// One text, one history, two views: what the form changes and what is typed both go through here.
import {defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory, redo, redoDepth, undo, undoDepth} from '@codemirror/commands';
import {yaml} from '@codemirror/lang-yaml';
import {bracketMatching, foldKeymap, indentUnit} from '@codemirror/language';
import {EditorState, Transaction} from '@codemirror/state';
import {drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers} from '@codemirror/view';
import type {CurriculumProblem} from '../../wire/types';
import {type Change, differenceOf, EditRefused} from '../yaml/edit';
import {pathAt, type Path, readSource, type Source} from '../yaml/source';
import {look} from './look';
import {applyRepair, type Mark, marksField, placeProblems, problemMarks, setMarks} from './marks';

export interface Snapshot {
  readonly text: string;
  readonly source: Source;
  /** The newest text that could be read as a whole: what the form shows. */
  readonly readable: Source;
  readonly marks: readonly Mark[];
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Where the caret was put in the text, as a place of the tree. */
  readonly caret: Path;
}

export interface DeskOptions {
  text: string;
  readOnly: boolean;
  nonce: string;
  label: string;
}

export class TextDesk {
  readonly view: EditorView;
  private state: Snapshot;
  private readonly listeners = new Set<() => void>();

  constructor({text, readOnly, nonce, label}: DeskOptions) {
    const source = readSource(text);
    this.state = {text, source, readable: source, marks: [], canUndo: false, canRedo: false, caret: []};
    this.view = new EditorView({
      state: EditorState.create({
        doc: text,
        extensions: [
          problemMarks, lineNumbers(), highlightActiveLineGutter(), look, history(), drawSelection(), highlightActiveLine(),
          bracketMatching(), yaml(), indentUnit.of('  '), EditorState.tabSize.of(2), EditorState.readOnly.of(readOnly),
          keymap.of([
            {key: 'Mod-.', run: () => this.repairAtCaret()}, ...defaultKeymap, ...historyKeymap, ...foldKeymap,
            ...(readOnly ? [] : [indentWithTab]),
          ]),
          EditorView.contentAttributes.of({'aria-label': label, 'aria-describedby': 'text-keys', 'spellcheck': 'false', 'tabindex': '0'}),
          nonce === '' ? [] : EditorView.cspNonce.of(nonce),
          EditorView.updateListener.of(({transactions}) => this.follow(transactions)),
        ],
      }),
    });
  }

  readonly snapshot = (): Snapshot => this.state;

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  /** A change by the form. Typing into one field is one step back, anything else a step of its own. The answer says why not. */
  edit(make: (source: Source) => Change[], kind: 'typing' | 'step' = 'step'): string | null {
    let changes: Change[];
    try {
      changes = make(this.state.source);
    } catch (problem) {
      if (problem instanceof EditRefused) return problem.message;
      throw problem;
    }
    if (changes.length === 0) return null;
    this.view.dispatch({
      changes: [...changes], userEvent: kind === 'typing' ? 'input.type' : 'input.form',
      annotations: kind === 'typing' ? [] : isolateHistory.of('full'),
    });
    return null;
  }

  /** Another text as one step that can be taken back. */
  replace(text: string): void {
    this.edit((source) => differenceOf(source.text, text));
  }

  undo(): void {
    undo(this.view);
  }

  redo(): void {
    redo(this.view);
  }

  setProblems(problems: readonly CurriculumProblem[]): void {
    this.view.dispatch({effects: setMarks.of(placeProblems(this.view.state.doc, problems)), annotations: Transaction.addToHistory.of(false)});
  }

  /** Shows a place in the text; `focus` also puts the caret there. */
  show(offset: number, focus: boolean): void {
    const at = Math.min(offset, this.view.state.doc.length);
    this.view.dispatch({
      ...(focus ? {selection: {anchor: at}} : {}),
      effects: EditorView.scrollIntoView(at, {y: focus ? 'center' : 'nearest', yMargin: 40}),
    });
    if (focus) this.view.focus();
  }

  /** The next problem after the caret (or the one before), all around the text. */
  nextMark(step: 1 | -1): Mark | null {
    const marks = [...this.state.marks].sort((a, b) => a.from - b.from);
    const caret = this.view.state.selection.main.head;
    const found = step === 1
      ? marks.find((mark) => mark.from > caret) ?? marks[0]
      : marks.findLast((mark) => mark.from < caret) ?? marks.at(-1);
    return found ?? null;
  }

  repair(problem: CurriculumProblem): boolean {
    return applyRepair(this.view, problem);
  }

  /** 1-based line of an offset. */
  lineOf(offset: number): number {
    return this.view.state.doc.lineAt(Math.min(offset, this.view.state.doc.length)).number;
  }

  private repairAtCaret(): boolean {
    const {doc, selection} = this.view.state;
    const line = doc.lineAt(selection.main.head);
    const mark = this.state.marks.find((one) => one.problem.repair && doc.lineAt(one.from).number === line.number);
    return mark !== undefined && this.repair(mark.problem);
  }

  private follow(transactions: readonly Transaction[]): void {
    const {state} = this.view;
    const changed = transactions.some((one) => one.docChanged);
    const moved = transactions.some((one) => one.isUserEvent('select') || one.isUserEvent('input.type') && this.view.hasFocus);
    const marks = state.field(marksField);
    if (!changed && !moved && marks === this.state.marks) return;
    const text = changed ? state.doc.toString() : this.state.text;
    const source = changed ? readSource(text) : this.state.source;
    this.state = {
      text, source, marks,
      readable: source.stop ? this.state.readable : source,
      canUndo: undoDepth(state) > 0, canRedo: redoDepth(state) > 0,
      caret: moved && !source.stop ? pathAt(source, state.selection.main.head) : this.state.caret,
    };
    this.listeners.forEach((listener) => listener());
  }
}
