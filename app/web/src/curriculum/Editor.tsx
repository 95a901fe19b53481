import {Button} from '@mantine/core';
import {useEffect, useMemo, useState, useSyncExternalStore} from 'react';
import {Link} from 'wouter';
import {Icon} from '../parts/Icon';
import {useSignedIn} from '../parts/api';
import {formatCount, formatWhen} from '../parts/format';
import {paths} from '../parts/paths';
import type {Catalogue, CurriculumRow, CurriculumText} from '../wire/types';
import {DraftSaver, type Saving, unsavedCopy} from './draft/draft_saver';
import {PublishDialog} from './draft/PublishDialog';
import {SavingProblem} from './draft/SavingProblem';
import {useCheck} from './draft/use_check';
import {DryRunPanel} from './dry_run/DryRunPanel';
import {CurriculumForm, type FormPlace, formPlace} from './form/CurriculumForm';
import type {FormDesk} from './form/form_desk';
import {formMarks, markPath} from './form/form_marks';
import {TextDesk} from './text/desk';
import {TextView} from './text/TextView';
import {placeOf, valueIn} from './yaml/source';
import styles from './editor.module.css';

interface Props {
  draft: CurriculumText;
  row: CurriculumRow | null;
  catalogue: Catalogue;
  onPublished: () => void;
}

const styleNonce = () => document.querySelector<HTMLMetaElement>('meta[name="csp-nonce"]')?.content ?? '';

function newDesk(draft: CurriculumText): TextDesk {
  const desk = new TextDesk({text: draft.yaml, readOnly: false, nonce: styleNonce(), label: 'Text of the curriculum'});
  desk.setProblems(draft.check.problems);
  return desk;
}

/** Form and text of a draft: two views of one file with one history. */
export function Editor({draft, row, catalogue, onPublished}: Props) {
  const {api} = useSignedIn();
  const shelfKey = `cathedra.unsaved.${draft.id}`;
  const [desk] = useState(() => newDesk(draft));
  const [copy, setCopy] = useState(() => unsavedCopy(localStorage.getItem(shelfKey), draft.yaml));
  const [saver] = useState(() => new DraftSaver(
    {save: (body) => api.saveDraft(draft.id, body), load: () => api.curriculum(draft.id, 'draft')}, localStorage, shelfKey, draft));
  const state = useSyncExternalStore(desk.subscribe, desk.snapshot);
  const saving = useSyncExternalStore(saver.subscribe, saver.snapshot);
  const checked = useCheck(desk, state.text, draft);
  const [place, setPlace] = useState<FormPlace>({tab: 'general', exercise: 0});
  const [caret, setCaret] = useState(state.caret);
  const [shown, setShown] = useState<'form' | 'text'>('form');
  const [dryRun, setDryRun] = useState(() => sessionStorage.getItem(`cathedra.dry-run.${draft.id}`) !== null);
  const [publishing, setPublishing] = useState(false);
  const [notice, setNotice] = useState('');
  // the form follows the caret in the text
  if (caret !== state.caret) {
    setCaret(state.caret);
    setPlace(formPlace(state.caret, place));
  }

  const {text, readable, source, marks} = state;
  useEffect(() => saver.changed(text), [saver, text]);
  useEffect(() => () => saver.stop(), [saver]);
  useEffect(() => {
    const guard = (event: BeforeUnloadEvent) => { if (!saver.isSaved) event.preventDefault(); };
    window.addEventListener('beforeunload', guard);
    return () => window.removeEventListener('beforeunload', guard);
  }, [saver]);

  const form = useMemo<FormDesk>(() => ({
    source: readable, catalogue, frozen: source.stop !== null,
    marks: source.stop ? [] : formMarks(readable, marks, (offset) => desk.lineOf(offset)),
    edit: (make, kind) => setNotice(desk.edit(make, kind) ?? ''),
    show: (path) => desk.show(placeOf(readable, path), false),
    goTo: (path) => {
      setShown('text');
      desk.show(placeOf(readable, path), true);
    },
    repair: (one) => setNotice(desk.repair(one.mark.problem) ? '' : 'This line was changed since it was checked. Wait a moment and try again.'),
  }), [desk, readable, source, marks, catalogue]);

  const toMark = (step: 1 | -1) => {
    const mark = desk.nextMark(step);
    if (!mark) return;
    if (!source.stop) setPlace(formPlace(markPath(readable, mark), place));
    desk.show(mark.from, true);
  };
  const keys = (event: React.KeyboardEvent) => {
    const command = (event.ctrlKey || event.metaKey) && !event.altKey;
    const key = event.key.toLowerCase();
    const inText = desk.view.dom.contains(event.target as Node);
    if (event.key === 'F8') toMark(event.shiftKey ? -1 : 1);
    else if (command && key === 's') void saver.saveNow();
    else if (command && key === 'z' && !inText) {
      if (event.shiftKey) desk.redo();
      else desk.undo();
    } else if (command && key === 'y' && !inText) desk.redo();
    else return;
    event.preventDefault();
  };

  const current = checked.text === text && checked.problem === '';
  const errors = marks.filter((mark) => mark.problem.severity === 'error').length;
  const warnings = marks.length - errors;
  const obstacle = source.stop || errors > 0 ? `Mend ${formatCount(Math.max(1, errors), 'problem')} first.`
    : !current ? 'Checking the text.' : '';
  const title = String(valueIn(readable.value, ['title', 'en']) ?? draft.title);
  const version = String(valueIn(readable.value, ['version']) ?? '');
  const published = row?.published_version ?? null;
  const list = valueIn(readable.value, ['exercises']);
  const exercises = Array.isArray(list) ? list.map((one) => ({
    id: String(valueIn(one, ['id']) ?? ''), title: String(valueIn(one, ['title', 'en']) ?? ''),
  })) : [];

  return (
    <div className={styles.editor} onKeyDown={keys}>
      <div className={styles.head}>
        <nav className={styles.crumbs} aria-label="Breadcrumb"><Link href={paths.curricula}>Curricula</Link> <span aria-hidden="true">/</span></nav>
        <h1>{title}</h1>
        <span className="tag num">{version}</span><span className="tag">Draft</span>
        <span className="small faint num" role="status">{savingWord(saving)}</span>
        <span className="grow" />
        <Problems errors={errors} warnings={warnings} checking={!current} failure={checked.problem} onNext={() => toMark(1)} />
        <Button variant="default" disabled={!state.canUndo} onClick={() => desk.undo()}>Undo</Button>
        <Button variant="default" disabled={!state.canRedo} onClick={() => desk.redo()}>Redo</Button>
        {published !== null && <Button variant="default" component={Link} href={paths.curriculumDiff(draft.id, published, 'draft')}>Changes since {published}</Button>}
        <Button variant="default" aria-expanded={dryRun} onClick={() => setDryRun(!dryRun)}>Dry run</Button>
        <Button disabled={obstacle !== ''} title={obstacle} onClick={() => setPublishing(true)}>Publish</Button>
      </div>
      {copy && (
        <p className={styles.notice} role="status">
          <Icon name="info" /><span className="grow">Changes of {formatWhen(copy.utc)} were never saved. This browser kept them.</span>
          <Button variant="default" onClick={() => { desk.replace(copy.text); setCopy(null); }}>Bring them back</Button>
          <Button variant="default" onClick={() => { localStorage.removeItem(shelfKey); setCopy(null); }}>Discard</Button>
        </p>
      )}
      <SavingProblem saving={saving} saver={saver} onTake={(theirs) => { saver.accept(theirs); desk.replace(theirs.yaml); }} />
      {notice !== '' && <p className={styles.notice} role="alert"><Icon name="triangle" />{notice}</p>}
      <div className={styles.switch} role="group" aria-label="View">
        <button type="button" aria-pressed={shown === 'form'} onClick={() => setShown('form')}>Form</button>
        <button type="button" aria-pressed={shown === 'text'} onClick={() => setShown('text')}>Text</button>
      </div>
      <div className={styles.views} data-shown={shown}>
        <section className={styles.formSide} aria-label="Form">
          <h2 className="visually-hidden">Form</h2>
          <CurriculumForm desk={form} stop={source.stop} place={place} onPlace={setPlace} onGoToLine={(line) => {
            setShown('text');
            desk.show(desk.view.state.doc.line(Math.min(line, desk.view.state.doc.lines)).from, true);
          }} />
        </section>
        <section className={styles.textSide} aria-label="Text">
          <TextView desk={desk} hint="Tab indents; Esc, then Tab leaves the text. F8: next problem. Ctrl+. mends the one at the caret. Ctrl+S saves." />
        </section>
      </div>
      {dryRun && (
        <DryRunPanel curriculumId={draft.id} yaml={text} sha256={current ? checked.check.sha256 : ''} obstacle={obstacle} exercises={exercises}
          onClose={() => setDryRun(false)} />
      )}
      {publishing && <PublishDialog draft={draft} row={row} version={version} saver={saver} onClose={() => setPublishing(false)} onPublished={onPublished} />}
    </div>
  );
}

function savingWord(saving: Saving): string {
  if (saving.kind === 'saving') return 'Saving';
  if (saving.kind === 'unsaved') return 'Not saved yet';
  if (saving.kind === 'failed') return 'Not saved';
  if (saving.kind === 'conflict') return 'Not saved: conflict';
  return saving.utc === null ? 'Saved' : `Saved ${formatWhen(saving.utc).replace('Today, ', '')}`;
}

function Problems({errors, warnings, checking, failure, onNext}: {errors: number; warnings: number; checking: boolean; failure: string; onNext: () => void}) {
  if (failure !== '') return <span className="state tone-warn" title={failure}><Icon name="triangle" /><span>Not checked</span></span>;
  if (errors + warnings === 0) {
    return <span className={`state ${checking ? 'tone-idle' : 'tone-ok'}`}><Icon name={checking ? 'circle' : 'tick'} /><span>{checking ? 'Checking' : 'No problems'}</span></span>;
  }
  const words = [errors > 0 ? formatCount(errors, 'problem') : '', warnings > 0 ? formatCount(warnings, 'warning') : ''].filter((word) => word !== '').join(', ');
  return (
    <button type="button" className={`state ${styles.problems} ${errors > 0 ? 'tone-bad' : 'tone-warn'}`} onClick={onNext} title="Next problem (F8)">
      <Icon name={errors > 0 ? 'octagon' : 'triangle'} /><span>{words}</span>
    </button>
  );
}
