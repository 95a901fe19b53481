import {NativeSelect} from '@mantine/core';
import {insertItem, setValue, setWords} from '../yaml/edit';
import {type Path, type Value, valueIn} from '../yaml/source';
import {ChoiceField, LongTextField, NumberField, RowProblems, Sentences, SwitchField, TextField, WordsField} from './fields';
import {useForm, useList, useMarks, useValue, wordsOf} from './form_desk';
import {leftOver} from './form_marks';
import {ListTools} from './ListTools';
import {freeId, orders} from './orders';
import styles from './form.module.css';

const counts = [{value: 'fail', label: 'Counts as not passed'}, {value: 'invalid', label: 'Does not count'}];
const words = (...all: string[]) => all.map((value) => ({value, label: value.charAt(0).toUpperCase() + value.slice(1).replace('_', ' ')}));

export function GeneralTab() {
  const left = leftOver(useMarks([]), [], orders.curriculum);
  const attempt: Path = ['defaults', 'attempt'];
  return (
    <>
      <Sentences marks={left} />
      <section className={styles.section} aria-label="Identity">
        <TextField path={['title', 'en']} label="Title" order={orders.curriculum} />
        <div className={styles.grid2}>
          <TextField path={['id']} label="Id" readOnly description="Never changes: records name it." />
          <TextField path={['version']} label="Version" order={orders.curriculum} description="A changed step, limit or pass mark wants a new major." />
        </div>
        <Authors />
        <Sentences marks={[...useMarks(['schema']), ...useMarks(['status'])]} />
      </section>
      <section className={styles.section} aria-label="Attempts">
        <h3>Of every exercise that does not say otherwise</h3>
        <div className={styles.grid3}>
          <NumberField path={[...attempt, 'time_limit_s']} label="Time limit" unit="s" optional="900" order={orders.attempt} />
          <ChoiceField path={[...attempt, 'on_timeout']} label="After the time limit" absent="Counts as not passed" options={counts} order={orders.attempt} />
          <ChoiceField path={[...attempt, 'on_abort']} label="Ended early" absent="Does not count" options={counts} order={orders.attempt} />
        </div>
        <WordsField path={['defaults', 'feedback', 'during']} label="Shown during a trial" options={words('force', 'torque', 'progress', 'time', 'steps')} order={orders.feedback} />
        <WordsField path={['defaults', 'feedback', 'after']} label="Shown after a trial" options={words('time', 'contact', 'target_line', 'steps', 'metrics', 'events')} order={orders.feedback} />
      </section>
    </>
  );
}

function Authors() {
  const form = useForm();
  const authors = wordsOf(useValue(['authors']));
  return (
    <div className={styles.section}>
      <div className={styles.sectionHead}>
        <h3>Authors</h3>
        <span className={styles.aside}><button type="button" className={styles.add} disabled={form.frozen}
          onClick={() => form.edit((source) => insertItem(source, ['authors'], authors.length, 'New author', orders.curriculum))}>Add author</button></span>
      </div>
      {authors.map((_, index) => (
        <div key={index} className={styles.picker}>
          <TextField path={['authors', index]} label={`Author ${index + 1}`} inRow />
          <ListTools list={['authors']} index={index} count={authors.length} what={`author ${index + 1}`} />
        </div>
      ))}
    </div>
  );
}

const rules = [
  {value: 'fixed', label: 'A fixed value'}, {value: 'mean_plus_k_sd', label: 'Mean of a group plus k deviations'},
  {value: 'percentile', label: 'Percentile of a group'}, {value: 'contrasting_groups', label: 'Where two groups part'},
];
const levels = words('novice', 'intermediate', 'expert');

export function BenchmarksTab() {
  const form = useForm();
  const all = useValue(['benchmarks']);
  const ids = typeof all === 'object' && all !== null && !Array.isArray(all) ? Object.keys(all) : [];
  const add = () => form.edit((source) => setValue(source, ['benchmarks', freeId('new-benchmark', ids)], {
    metric: 'time_s', rule: {kind: 'fixed', provisional: true}, value: 120, reason: {en: 'Say where this value comes from.'},
  }, orders.curriculum));
  return (
    <>
      <div className={styles.sectionHead}>
        <p className="small muted">Values that pass rules name. Provisional until five local experts have recorded trials.</p>
        <span className={styles.aside}><button type="button" className={styles.add} disabled={form.frozen} onClick={add}>Add benchmark</button></span>
      </div>
      {ids.length === 0 && <p className="small faint">None yet.</p>}
      {ids.map((id) => <Benchmark key={id} id={id} />)}
    </>
  );
}

function Benchmark({id}: {id: string}) {
  const form = useForm();
  const path = ['benchmarks', id];
  const kind = useValue([...path, 'rule', 'kind']);
  const metric = form.catalogue.metrics.find((one) => one.id === valueIn(form.source.value, [...path, 'metric']));
  const rule = [...path, 'rule'];
  return (
    <section className={styles.card} aria-label={`Benchmark ${id}`}>
      <div className={styles.cardHead}>
        <h3>{id}</h3>
        <button type="button" className={styles.add} disabled={form.frozen} onClick={() => form.edit((source) => setValue(source, path, undefined))}>Remove</button>
      </div>
      <Sentences marks={leftOver(useMarks(path), path, orders.benchmark)} />
      <div className={styles.grid2}>
        <ChoiceField path={[...path, 'metric']} label="Metric" options={form.catalogue.metrics.map((one) => ({value: one.id, label: one.title}))} />
        <ChoiceField path={[...rule, 'kind']} label="Rule" options={rules} />
        {kind === 'fixed' && <NumberField path={[...path, 'value']} label="Value" unit={metric?.unit} order={orders.benchmark} />}
        {kind === 'mean_plus_k_sd' && <NumberField path={[...rule, 'k']} label="k" />}
        {kind === 'percentile' && <NumberField path={[...rule, 'percentile']} label="Percentile" />}
        {(kind === 'mean_plus_k_sd' || kind === 'percentile') && <ChoiceField path={[...rule, 'group']} label="Of the group" options={levels} />}
        {kind === 'contrasting_groups' && <ChoiceField path={[...rule, 'below']} label="Group below" options={levels} />}
        {kind === 'contrasting_groups' && <ChoiceField path={[...rule, 'above']} label="Group above" options={levels} />}
        {kind !== 'fixed' && <TextField path={[...path, 'source', 'cohort']} label="Cohort" order={orders.benchmark} />}
        {kind !== 'fixed' && <TextField path={[...path, 'source', 'apparatus']} label="Apparatus" />}
        {kind === 'fixed' && <SwitchField path={[...rule, 'provisional']} label="Provisional" usual={false} />}
      </div>
      <LongTextField path={[...path, 'reason']} label="Where it comes from" order={orders.benchmark} />
    </section>
  );
}

const exerciseIds = (exercises: readonly Value[]) => exercises.map((one) => String(valueIn(one, ['id']) ?? ''));

export function PlanTab() {
  const form = useForm();
  const blocks = useList(['plan']);
  const exercises = exerciseIds(useList(['exercises']));
  const ids = blocks.map((block) => String(valueIn(block, ['block']) ?? ''));
  const planned = blocks.flatMap((block) => wordsOf(valueIn(block, ['exercises'])));
  const free = exercises.filter((id) => !planned.includes(id));
  const add = () => form.edit((source) => insertItem(source, ['plan'], blocks.length,
    {block: freeId('block', ids), exercises: free.slice(0, 1), order: 'any'}, orders.curriculum));
  return (
    <>
      <div className={styles.sectionHead}>
        <p className="small muted">{free.length === 0 ? 'Every exercise is in a block.' : `In no block yet: ${free.join(', ')}.`}</p>
        <span className={styles.aside}><button type="button" className={styles.add} disabled={form.frozen || free.length === 0} onClick={add}>Add block</button></span>
      </div>
      <Sentences marks={useMarks(['plan']).filter((one) => one.path.length === 1)} />
      {blocks.map((_, index) => <Block key={index} index={index} count={blocks.length} ids={ids} free={free} />)}
    </>
  );
}

function Block({index, count, ids, free}: {index: number; count: number; ids: readonly string[]; free: readonly string[]}) {
  const form = useForm();
  const path: Path = ['plan', index];
  const list = [...path, 'exercises'];
  const exercises = wordsOf(useValue(list));
  const others = ids.filter((_, at) => at !== index);
  return (
    <section className={styles.card} aria-label={`Block ${index + 1}`}>
      <div className={styles.cardHead}><h3>Block {index + 1}</h3><ListTools list={['plan']} index={index} count={count} what={`block ${index + 1}`} whenEmpty="keep" /></div>
      <div className={styles.grid2}>
        <TextField path={[...path, 'title', 'en']} label="Title" order={orders.block} emptyRemoves={[...path, 'title']} />
        <TextField path={[...path, 'block']} label="Id" />
        <ChoiceField path={[...path, 'order']} label="Order" absent="Any" options={[{value: 'any', label: 'Any'}, {value: 'listed', label: 'As listed'}]} order={orders.block} />
        <NumberField path={[...path, 'max_trials_per_day']} label="Trials a day" optional="no limit" order={orders.block} />
        <ChoiceField path={[...path, 'after']} label="Opens after" absent="At once" options={others.map((id) => ({value: id, label: id}))} order={orders.block} />
      </div>
      <div className={styles.rows}>
        {exercises.map((id, at) => (
          <div key={id} className={`${styles.row} ${styles.exerciseRow}`}>
            <span className={styles.ordinal}>{at + 1}</span><span className="small">{id}</span>
            <ListTools list={list} index={at} count={exercises.length} what={id} whenEmpty="keep" />
            <RowProblems path={[...list, at]} />
          </div>
        ))}
      </div>
      <Sentences marks={leftOver(useMarks(path), path, ['title', 'block', 'order', 'max_trials_per_day', 'after', ...(exercises.length > 0 ? ['exercises'] : [])])} />
      {free.length > 0 && (
        <NativeSelect aria-label={`Add an exercise to block ${index + 1}`} value="" disabled={form.frozen} data={[{value: '', label: 'Add an exercise'}, ...free]}
          onChange={(event) => { const id = event.currentTarget.value; if (id !== '') form.edit((source) => setWords(source, list, [...exercises, id], orders.block)); }} />
      )}
    </section>
  );
}

export function CompletionTab() {
  const form = useForm();
  const test: Path = ['completion', 'retention_test'];
  const has = useValue(test) !== undefined;
  const exercises = exerciseIds(useList(['exercises']));
  const toggle = () => form.edit((source) => (has ? setValue(source, test, undefined)
    : setValue(source, test, {after_days: 42, exercises: exercises.slice(0, 1), trials: 2}, orders.completion)));
  return (
    <>
      <section className={styles.section} aria-label="Completion">
        <SwitchField path={['completion', 'all_blocks']} label="All blocks must be proficient" usual order={orders.completion} />
        <ChoiceField path={['completion', 'sign_off']} label="Signed off by" absent="Nobody" options={[{value: 'instructor', label: 'An instructor'}, {value: 'none', label: 'Nobody'}]} order={orders.completion} />
        <Sentences marks={leftOver(useMarks(['completion']), ['completion'], orders.completion)} />
      </section>
      <section className={styles.section} aria-label="Retention test">
        <div className={styles.sectionHead}>
          <h3>Retention test</h3>
          <span className={styles.aside}><button type="button" className={styles.add} disabled={form.frozen} onClick={toggle}>{has ? 'Take it out' : 'Add one'}</button></span>
        </div>
        {!has && <p className="small faint">None.</p>}
        {has && (
          <div className={styles.grid2}>
            <NumberField path={[...test, 'after_days']} label="After" unit="days" />
            <NumberField path={[...test, 'trials']} label="Trials" />
            <div className={styles.wide}><WordsField path={[...test, 'exercises']} label="Exercises" options={exercises.map((id) => ({value: id, label: id}))} /></div>
          </div>
        )}
        <Sentences marks={useMarks(test).filter((one) => one.path.length === 2)} />
      </section>
    </>
  );
}

