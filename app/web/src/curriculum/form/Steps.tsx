import {duplicateItem, insertItem, setValue} from '../yaml/edit';
import {type Path, type Source, type Value, valueIn} from '../yaml/source';
import {ChoiceField, NumberField, RowProblems} from './fields';
import {useForm, useList} from './form_desk';
import {ListTools} from './ListTools';
import {freeId, orders} from './orders';
import styles from './form.module.css';

type Kind = 'translate' | 'rotate' | 'hold';

const kinds = [{value: 'translate', label: 'Feed to'}, {value: 'rotate', label: 'Turn to'}, {value: 'hold', label: 'Hold still'}];

/** Every step id of the exercise: none may come twice, in a repeat either. */
function idsOf(steps: Value | undefined): string[] {
  if (!Array.isArray(steps)) return [];
  return steps.flatMap((step) => {
    if (typeof step !== 'object' || step === null || Array.isArray(step)) return [];
    return [...(typeof step.id === 'string' ? [step.id] : []), ...idsOf(step.steps)];
  });
}

function newStep(kind: Kind, id: string): {[key: string]: Value} {
  if (kind === 'translate') return {id, do: kind, to_mm: 100, tolerance_mm: 2, hold_s: 1};
  if (kind === 'rotate') return {id, do: kind, to_deg: 360, tolerance_deg: 5};
  return {id, do: kind, seconds: 3};
}

export function Steps({exercise}: {exercise: Path}) {
  const form = useForm();
  const list = [...exercise, 'steps'];
  const steps = useList(list);
  const addRepeat = () => form.edit((source) => {
    const id = freeId('step', idsOf(valueIn(source.value, list)));
    return insertItem(source, list, steps.length, {repeat: 2, steps: [newStep('translate', id)]}, orders.exercise);
  });
  return (
    <section className={styles.section} aria-label="Steps">
      <div className={styles.sectionHead}>
        <h3>Steps</h3>
        <span className={styles.aside}>
          <AddStep exercise={exercise} list={list} />
          <button type="button" className={styles.add} disabled={form.frozen} onClick={addRepeat}>Add repeat</button>
        </span>
      </div>
      <StepRows exercise={exercise} list={list} />
      <RowProblems path={list} />
    </section>
  );
}

function AddStep({exercise, list}: {exercise: Path; list: Path}) {
  const form = useForm();
  const count = useList(list).length;
  const add = () => form.edit((source: Source) => {
    const all = valueIn(source.value, [...exercise, 'steps']);
    return insertItem(source, list, count, newStep('translate', freeId(`step-${count + 1}`, idsOf(all))), orders.exercise);
  });
  return <button type="button" className={styles.add} disabled={form.frozen} onClick={add}>Add step</button>;
}

function StepRows({exercise, list}: {exercise: Path; list: Path}) {
  const steps = useList(list);
  return (
    <div className={styles.rows}>
      {steps.map((step, index) => <StepRow key={index} exercise={exercise} list={list} index={index} count={steps.length} step={step} />)}
    </div>
  );
}

function StepRow({exercise, list, index, count, step}: {exercise: Path; list: Path; index: number; count: number; step: Value}) {
  const form = useForm();
  const path = [...list, index];
  const what = `step ${index + 1}`;
  const map = typeof step === 'object' && step !== null && !Array.isArray(step) ? step : {};
  const duplicate = () => form.edit((source) => {
    const taken = idsOf(valueIn(source.value, [...exercise, 'steps']));
    const patches = 'repeat' in map
      ? idsOf(map.steps).map((id, at) => ({path: ['steps', at, 'id'], value: freeId(id, taken)}))
      : [{path: ['id'], value: freeId(String(map.id ?? 'step'), taken)}];
    return duplicateItem(source, list, index, patches);
  });
  const tools = <ListTools list={list} index={index} count={count} what={what} whenEmpty="keep" onDuplicate={duplicate} />;
  if ('repeat' in map) {
    return (
      <div className={`${styles.row} ${styles.repeatRow}`} role="group" aria-label={`Step ${index + 1}, repeat`}>
        <span className={styles.ordinal}>{index + 1}</span>
        <span className="small strong">Repeat</span>
        <NumberField path={[...path, 'repeat']} label="Rounds" unit="rounds" inRow />
        <AddStep exercise={exercise} list={[...path, 'steps']} />
        {tools}
        <div className={styles.inner}><StepRows exercise={exercise} list={[...path, 'steps']} /></div>
      </div>
    );
  }
  const kind = map.do as Kind;
  const change = (next: string) => form.edit((source) => {
    const hold: {[key: string]: Value} = next !== 'hold' && typeof map.hold_s === 'number' ? {hold_s: map.hold_s} : {};
    return setValue(source, path, {...newStep(next as Kind, String(map.id ?? '')), ...hold});
  });
  const unit = kind === 'rotate' ? 'deg' : 'mm';
  const sign = kind === 'rotate' ? '°' : 'mm';
  return (
    <div className={`${styles.row} ${styles.stepRow}`} role="group" aria-label={`Step ${index + 1}`}>
      <span className={styles.ordinal} title={`id ${String(map.id ?? '')}`}>{index + 1}</span>
      <ChoiceField path={[...path, 'do']} label="What to do" inRow options={kinds} onChoose={change} />
      {kind === 'hold'
        ? <NumberField path={[...path, 'seconds']} label="For" unit="s" inRow order={orders.step} />
        : <NumberField path={[...path, `to_${unit}`]} label="Target" unit={sign} inRow order={orders.step} />}
      <NumberField path={[...path, `tolerance_${kind === 'rotate' ? 'deg' : 'mm'}`]} label="Tolerance" unit={`± ${sign}`} inRow order={orders.step}
        {...(kind === 'hold' ? {optional: '2'} : {})} />
      {kind === 'hold' ? <span /> : <NumberField path={[...path, 'hold_s']} label="Hold at the mark" unit="s hold" inRow optional="0" order={orders.step} />}
      {tools}
      <RowProblems path={path} />
    </div>
  );
}
