import {NativeSelect, TextInput} from '@mantine/core';
import {lazy, Suspense, useState} from 'react';
import {duplicateItem, insertItem, setValue} from '../yaml/edit';
import {type Path, type Source, type Value, valueIn} from '../yaml/source';
import {ChoiceField, LongTextField, NumberField, Sentences, TextField} from './fields';
import {useForm, useList, useMarks, useValue} from './form_desk';
import {leftOver} from './form_marks';
import {Limits, PassRule, Recorded} from './Judgement';
import {ListTools} from './ListTools';
import {freeId, orders} from './orders';
import {Steps} from './Steps';
import styles from './form.module.css';

// three.js comes only when a picture is asked for
const ScenePicture = lazy(() => import('../scene/ScenePicture'));

const idOf = (exercise: Value) => String(valueIn(exercise, ['id']) ?? '');
const titleOf = (exercise: Value) => String(valueIn(exercise, ['title', 'en']) ?? idOf(exercise));

export function ExerciseTab({chosen, onChoose}: {chosen: number; onChoose: (index: number) => void}) {
  const form = useForm();
  const exercises = useList(['exercises']);
  const index = Math.min(chosen, exercises.length - 1);
  const ids = exercises.map(idOf);
  const {anatomies, instruments} = form.catalogue;
  const add = () => {
    form.edit((source) => insertItem(source, ['exercises'], exercises.length, {
      id: freeId('new-exercise', ids), version: 1, title: {en: 'New exercise'},
      scene: {anatomy: anatomies[0]?.id ?? '', instruments: [instruments[0]?.id ?? ''], seed: 17},
      steps: [{id: 'feed-1', do: 'translate', to_mm: 100, tolerance_mm: 2, hold_s: 1}],
      limits: [{metric: 'force_max_n', op: '<=', value: 2, on_breach: 'critical_error'}],
      record: ['time_s', 'force_max_n'],
      pass: {all: [{metric: 'time_s', op: '<=', value: 120}, {errors: 'critical', op: '==', value: 0}]},
      proficiency: {consecutive: 2, additional: 0, min_trials: 3, max_trials: 80},
    }, orders.curriculum));
    onChoose(exercises.length);
  };
  const duplicate = () => {
    form.edit((source) => duplicateItem(source, ['exercises'], index, [{path: ['id'], value: freeId(ids[index] ?? 'exercise', ids)}]));
    onChoose(index + 1);
  };
  return (
    <>
      <div className={styles.picker}>
        <NativeSelect label="Exercise" value={String(index)} onChange={(event) => onChoose(Number(event.currentTarget.value))}
          data={exercises.map((exercise, at) => ({value: String(at), label: titleOf(exercise)}))} />
        <span className={styles.tools}>
          {index >= 0 && <ListTools list={['exercises']} index={index} count={exercises.length} what="exercise" whenEmpty="keep" onDuplicate={duplicate} />}
          <button type="button" className={styles.add} disabled={form.frozen} onClick={add}>Add</button>
        </span>
      </div>
      {exercises[index] !== undefined && <Exercise key={index} index={index} ids={ids} />}
    </>
  );
}

function Exercise({index, ids}: {index: number; ids: readonly string[]}) {
  const form = useForm();
  const path: Path = ['exercises', index];
  const left = leftOver(useMarks(path), path, orders.exercise);
  const instruments = [...path, 'scene', 'instruments', 0];
  const {catalogue} = form;
  const scene = [...path, 'scene'];
  return (
    <>
      <Sentences marks={left} />
      <section className={styles.section} aria-label="Words">
        <div className={styles.grid2}>
          <div className={styles.wide}><TextField path={[...path, 'title', 'en']} label="Title" order={orders.exercise} /></div>
          <IdField path={[...path, 'id']} others={ids.filter((_, at) => at !== index)} />
          <NumberField path={[...path, 'version']} label="Version of the exercise" order={orders.exercise} />
        </div>
        <LongTextField path={[...path, 'goal']} label="What to do and why" order={orders.exercise} />
      </section>
      <section className={styles.section} aria-label="Scene">
        <h3>Scene</h3>
        <div className={styles.grid2}>
          <ChoiceField path={[...scene, 'anatomy']} label="Anatomy" order={orders.scene} options={catalogue.anatomies.map(({id, title}) => ({value: id, label: title}))} />
          <ChoiceField path={instruments} label="Instrument" options={catalogue.instruments.map(({id, title}) => ({value: id, label: title}))} />
          <NumberField path={[...scene, 'start_mm']} label="Inserted at the start" unit="mm" optional="0" order={orders.scene} />
          <NumberField path={[...scene, 'seed']} label="Seed" optional="0" order={orders.scene} />
        </div>
        <Picture path={path} />
      </section>
      <Steps exercise={path} />
      <Limits exercise={path} />
      <PassRule exercise={path} />
      <Recorded exercise={path} />
      <section className={styles.section} aria-label="Proficiency">
        <h3>Proficient after</h3>
        <div className={styles.grid4}>
          <NumberField path={[...path, 'proficiency', 'consecutive']} label="Passes in a row" order={orders.proficiency} />
          <NumberField path={[...path, 'proficiency', 'additional']} label="And more" optional="0" order={orders.proficiency} />
          <NumberField path={[...path, 'proficiency', 'min_trials']} label="At least trials" optional="0" order={orders.proficiency} />
          <NumberField path={[...path, 'proficiency', 'max_trials']} label="At most trials" optional="no limit" order={orders.proficiency} />
        </div>
      </section>
      <Requires path={path} others={ids.filter((_, at) => at !== index)} />
    </>
  );
}

// an id that others name changes in all of these places at once
function IdField({path, others}: {path: Path; others: readonly string[]}) {
  const form = useForm();
  const id = String(useValue(path) ?? '');
  const marks = useMarks(path);
  const [typed, setTyped] = useState<string | null>(null);
  const refusal = typed === null || typed === id ? '' : others.includes(typed) ? 'Another exercise has this id.'
    : /^[a-z][a-z0-9_-]*$/.test(typed) ? '' : 'Use small letters, digits, "-" and "_", beginning with a letter.';
  const rename = () => {
    if (typed !== null && typed !== id && refusal === '') {
      form.edit((source) => [path, ...referencesTo(source, id)].flatMap((place) => setValue(source, place, typed)));
    }
    setTyped(null);
  };
  return (
    <TextInput label="Id" value={typed ?? id} disabled={form.frozen} onFocus={() => form.show(path)} onBlur={rename}
      error={refusal === '' ? marks.length > 0 && <Sentences marks={marks} /> : refusal}
      onChange={(event) => setTyped(event.currentTarget.value)} onKeyDown={(event) => { if (event.key === 'Enter') rename(); }} />
  );
}

/** Where other parts of the curriculum name this exercise. */
export function referencesTo(source: Source, id: string): Path[] {
  const found: Path[] = [];
  const look = (list: Path, key?: string) => {
    const all = valueIn(source.value, list);
    if (!Array.isArray(all)) return;
    all.forEach((one, index) => {
      const place = key === undefined ? [...list, index] : [...list, index, key];
      if ((key === undefined ? one : valueIn(one, [key])) === id) found.push(place);
    });
  };
  const count = (path: Path) => { const list = valueIn(source.value, path); return Array.isArray(list) ? list.length : 0; };
  for (let i = 0; i < count(['exercises']); ++i) look(['exercises', i, 'requires', 'all'], 'exercise');
  for (let i = 0; i < count(['plan']); ++i) look(['plan', i, 'exercises']);
  look(['completion', 'retention_test', 'exercises']);
  return found;
}

function Requires({path, others}: {path: Path; others: readonly string[]}) {
  const form = useForm();
  const list = [...path, 'requires', 'all'];
  const required = useList(list).map((one) => String(valueIn(one, ['exercise']) ?? ''));
  const marks = useMarks([...path, 'requires']);
  const free = others.filter((id) => !required.includes(id));
  return (
    <section className={styles.section} aria-label="Prerequisites">
      <div className={styles.sectionHead}>
        <h3>Opens when proficient in</h3>
        {free.length > 0 && (
          <NativeSelect className={styles.aside} size="xs" aria-label="Add a prerequisite" value="" disabled={form.frozen}
            data={[{value: '', label: 'Add'}, ...free]}
            onChange={(event) => {
              const id = event.currentTarget.value;
              if (id !== '') form.edit((source) => insertItem(source, list, required.length, {exercise: id, state: 'proficient'}, orders.exercise));
            }} />
        )}
      </div>
      {required.length === 0 && <p className="small faint">Nothing: it opens with its block of the plan.</p>}
      <div className={styles.rows}>
        {required.map((id, at) => (
          <div key={id} className={`${styles.row} ${styles.exerciseRow}`}>
            <span className={styles.ordinal}>{at + 1}</span><span className="small">{id}</span>
            <ListTools list={list} index={at} count={required.length} what={id} whole={[...path, 'requires']} />
          </div>
        ))}
      </div>
      <Sentences marks={marks} />
    </section>
  );
}

function Picture({path}: {path: Path}) {
  const [open, setOpen] = useState(false);
  const anatomy = useValue([...path, 'scene', 'anatomy']);
  const known = useForm().catalogue.anatomies.some((one) => one.id === anatomy);
  if (!known) return null;
  return (
    <details className={styles.fold} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>Picture of the anatomy</summary>
      {open && <Suspense fallback={<p className="small faint">Loading the picture</p>}><ScenePicture key={String(anatomy)} anatomyId={String(anatomy)} /></Suspense>}
    </details>
  );
}

