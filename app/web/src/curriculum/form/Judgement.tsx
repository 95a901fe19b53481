import {insertItem, renameKey, setValue} from '../yaml/edit';
import {lineNumber, type Path, placeOf, type Value, valueIn} from '../yaml/source';
import {ChoiceField, NumberField, RowProblems, switchKey, WordsField} from './fields';
import {useForm, useList, useValue, wordsOf} from './form_desk';
import {ListTools} from './ListTools';
import {orders} from './orders';
import {unitWord} from '../../parts/format';
import styles from './form.module.css';

const watched = ['force_max_n', 'handle_force_max_n', 'torque_max_n_mm', 'wall_hits', 'time_s', 'contact_impulse_n_s'];
const consequences = [
  {value: 'mark', label: 'Noted'}, {value: 'fail', label: 'Fails the trial'}, {value: 'critical_error', label: 'Critical error'}, {value: 'stop', label: 'Ends the trial'},
];
const comparisons = [
  {value: '<=', label: 'At most'}, {value: '<', label: 'Less than'}, {value: '==', label: 'Exactly'}, {value: '>=', label: 'At least'},
  {value: '>', label: 'More than'}, {value: '!=', label: 'Not'},
];

function useMetrics() {
  const {catalogue} = useForm();
  const unit = (id: Value | undefined) => unitWord(catalogue.metrics.find((metric) => metric.id === id)?.unit ?? '');
  return {options: catalogue.metrics.map((metric) => ({value: metric.id, label: metric.title})), unit};
}

export function Limits({exercise}: {exercise: Path}) {
  const form = useForm();
  const list = [...exercise, 'limits'];
  const limits = useList(list);
  const {options, unit} = useMetrics();
  const add = () => form.edit((source) => insertItem(source, list, limits.length,
    {metric: 'force_max_n', op: '<=', value: 2, on_breach: 'critical_error'}, orders.exercise));
  return (
    <section className={styles.section} aria-label="Limits">
      <div className={styles.sectionHead}>
        <h3>Limits</h3><span className="xs faint">training values, not clinical</span>
        <span className={styles.aside}><button type="button" className={styles.add} disabled={form.frozen} onClick={add}>Add limit</button></span>
      </div>
      <div className={styles.rows}>
        {limits.map((limit, index) => (
          <div key={index} className={`${styles.row} ${styles.limitRow}`} role="group" aria-label={`Limit ${index + 1}`}>
            <ChoiceField path={[...list, index, 'metric']} label="Metric" inRow options={options.filter((one) => watched.includes(one.value))} />
            <NumberField path={[...list, index, 'value']} label="At most" unit={unit(valueIn(limit, ['metric']))} inRow order={orders.limit} />
            <ChoiceField path={[...list, index, 'on_breach']} label="When it is passed" inRow options={consequences} order={orders.limit} />
            <ListTools list={list} index={index} count={limits.length} what={`limit ${index + 1}`} />
            <RowProblems path={[...list, index]} />
          </div>
        ))}
        {limits.length === 0 && <p className="small faint">None. Nothing ends or fails a trial but its pass rule.</p>}
      </div>
    </section>
  );
}

export function Recorded({exercise}: {exercise: Path}) {
  const path = [...exercise, 'record'];
  const {options} = useMetrics();
  const count = wordsOf(useValue(path)).length;
  return (
    <details className={styles.fold}>
      <summary>Recorded <span className="faint num">{count} of {options.length} metrics</span></summary>
      <WordsField path={path} label="What is measured and kept of every trial" options={options} order={orders.exercise} />
    </details>
  );
}

const isMap = (value: Value | undefined): value is {[key: string]: Value} => typeof value === 'object' && value !== null && !Array.isArray(value);

/** The key of the list of criteria when all of them are simple; null when only the text can say it. */
export function simpleRule(rule: Value | undefined): 'all' | 'any' | null {
  if (!isMap(rule)) return null;
  const key = 'all' in rule ? 'all' : 'any' in rule ? 'any' : null;
  const list = key === null ? null : rule[key];
  const simple = (one: Value) => isMap(one) && ('metric' in one || 'errors' in one || 'goal' in one);
  return key !== null && Object.keys(rule).length === 1 && Array.isArray(list) && list.every(simple) ? key : null;
}

export function PassRule({exercise}: {exercise: Path}) {
  const form = useForm();
  const path = [...exercise, 'pass'];
  const rule = useValue(path);
  const key = simpleRule(rule);
  const line = lineNumber(form.source.text, placeOf(form.source, path));
  if (rule === undefined) {
    const begin = () => form.edit((source) => setValue(source, path, {all: [{errors: 'critical', op: '==', value: 0}]}, orders.exercise));
    return (
      <section className={styles.section} aria-label="Pass rule">
        <h3>Pass rule</h3>
        <p className="small faint">None: this exercise cannot be passed. <button type="button" className={styles.add} disabled={form.frozen} onClick={begin}>Add a rule</button></p>
        <RowProblems path={path} />
      </section>
    );
  }
  if (key === null) {
    return (
      <section className={styles.section} aria-label="Pass rule">
        <h3>Pass rule</h3>
        <p className={styles.textOnly}>
          <span className="grow">This rule nests its parts, which only the text can show.</span>
          <button type="button" className={styles.add} onClick={() => form.goTo(path)}>Go to line {line}</button>
        </p>
        <RowProblems path={path} />
      </section>
    );
  }
  return <SimpleRule path={path} at={key} />;
}

function SimpleRule({path, at}: {path: Path; at: 'all' | 'any'}) {
  const form = useForm();
  const list = [...path, at];
  const criteria = useList(list);
  const add = () => form.edit((source) => insertItem(source, list, criteria.length, {metric: 'time_s', op: '<=', value: 120}));
  return (
    <section className={styles.section} aria-label="Pass rule">
      <div className={styles.sectionHead}>
        <h3>Pass when</h3>
        <select className={styles.add} aria-label="How many must hold" value={at} disabled={form.frozen}
          onChange={(event) => { const next = event.currentTarget.value; form.edit((source) => renameKey(source, path, at, next)); }}>
          <option value="all">all hold</option><option value="any">any one holds</option>
        </select>
        <span className={styles.aside}><button type="button" className={styles.add} disabled={form.frozen} onClick={add}>Add criterion</button></span>
      </div>
      <div className={styles.rows}>
        {criteria.map((criterion, index) => <Criterion key={index} list={list} index={index} count={criteria.length} criterion={criterion} />)}
      </div>
    </section>
  );
}

function Criterion({list, index, count, criterion}: {list: Path; index: number; count: number; criterion: Value}) {
  const form = useForm();
  const {options, unit} = useMetrics();
  const benchmarks = useValue(['benchmarks']);
  const path = [...list, index];
  const map = isMap(criterion) ? criterion : {};
  const subject = 'errors' in map ? 'errors' : 'goal' in map ? 'goal' : 'metric';
  const mine = isMap(benchmarks) ? Object.entries(benchmarks).filter(([, one]) => valueIn(one, ['metric']) === map.metric).map(([id]) => id) : [];
  const choose = (next: string) => {
    const [kind, word] = next.includes(':') ? next.split(':') : ['metric', next];
    const whole: {[key: string]: Value} = kind === 'goal' ? {goal: 'reached'}
      : kind === 'errors' ? {errors: word ?? 'critical', op: '==', value: 0} : {metric: word ?? '', op: map.op ?? '<=', value: typeof map.value === 'number' ? map.value : 0};
    form.edit((source) => (kind === 'metric' && 'metric' in map && 'value' in map
      ? setValue(source, [...path, 'metric'], word ?? '') : setValue(source, path, whole)));
  };
  const chosen = subject === 'metric' ? String(map.metric ?? '') : subject === 'goal' ? 'goal:reached' : `errors:${String(map.errors)}`;
  const subjects = [
    ...options, {value: 'errors:critical', label: 'Critical errors'}, {value: 'errors:fail', label: 'Failing errors'},
    {value: 'errors:mark', label: 'Noted errors'}, {value: 'goal:reached', label: 'All steps done'},
  ];
  return (
    <div className={`${styles.row} ${styles.criterionRow}`} role="group" aria-label={`Criterion ${index + 1}`}>
      <Subject path={[...path, subject]} options={subjects} value={chosen} onChoose={choose} />
      {subject === 'goal' ? <span className="small muted">Reached</span> : <ChoiceField path={[...path, 'op']} label="Comparison" inRow options={comparisons} />}
      {subject === 'goal' ? <span /> : 'benchmark' in map
        ? <ChoiceField path={[...path, 'benchmark']} label="Benchmark" inRow
            options={[...mine.map((id) => ({value: id, label: id})), {value: '#value', label: 'A value of its own'}]}
            onChoose={(next) => (next === '#value'
              ? switchKey(form, path, 'benchmark', 'value', Number(valueIn(benchmarks, [String(map.benchmark), 'value']) ?? 0))
              : form.edit((source) => setValue(source, [...path, 'benchmark'], next)))} />
        : <NumberField path={[...path, 'value']} label="Value" unit={subject === 'metric' ? unit(map.metric) : ''} inRow order={orders.criterion} />}
      <span className={styles.tools}>
        {'value' in map && mine[0] !== undefined && (
          <button type="button" className={styles.add} disabled={form.frozen} onClick={() => switchKey(form, path, 'value', 'benchmark', mine[0] ?? '')}>Benchmark</button>
        )}
        <ListTools list={list} index={index} count={count} what={`criterion ${index + 1}`} whenEmpty="keep" />
      </span>
      <RowProblems path={path} />
    </div>
  );
}

// what a criterion is about is a metric, a kind of error or the goal: one list for three keys
function Subject({path, options, value, onChoose}: {path: Path; options: {value: string; label: string}[]; value: string; onChoose: (value: string) => void}) {
  const shown = path.at(-1) === 'metric' ? options : options.map((one) => (one.value === value ? {...one, value: value.split(':')[1] ?? ''} : one));
  return <ChoiceField path={path} label="What is judged" inRow options={shown}
    onChoose={(next) => onChoose(options.find((_, index) => shown[index]?.value === next)?.value ?? next)} />;
}
