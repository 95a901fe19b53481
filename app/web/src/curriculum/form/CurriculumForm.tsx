import {useMemo} from 'react';
import {Icon} from '../../parts/Icon';
import type {Path, Stop} from '../yaml/source';
import {type FormDesk, FormContext} from './form_desk';
import {ExerciseTab} from './ExerciseTab';
import {BenchmarksTab, CompletionTab, GeneralTab, PlanTab} from './OtherTabs';
import styles from './form.module.css';

export interface FormPlace {
  tab: TabId;
  exercise: number;
}

const tabs = [
  {id: 'general', label: 'General'}, {id: 'benchmarks', label: 'Benchmarks'}, {id: 'exercises', label: 'Exercises'},
  {id: 'plan', label: 'Plan'}, {id: 'completion', label: 'Completion'},
] as const;
export type TabId = (typeof tabs)[number]['id'];

/** Where the form shows a place of the text. */
export function formPlace(path: Path, before: FormPlace): FormPlace {
  const [top, index] = path;
  if (top === undefined) return before;
  const tab = tabs.find((one) => one.id === top)?.id ?? 'general';
  return {tab, exercise: tab === 'exercises' && typeof index === 'number' ? index : before.exercise};
}

interface Props {
  desk: FormDesk;
  stop: Stop | null;
  place: FormPlace;
  onPlace: (place: FormPlace) => void;
  onGoToLine: (line: number) => void;
}

export function CurriculumForm({desk, stop, place, onPlace, onGoToLine}: Props) {
  const counts = useMemo(() => new Map(tabs.map(({id}) => [id,
    desk.marks.filter((one) => one.mark.problem.severity === 'error' && formPlace(one.path, {tab: 'general', exercise: 0}).tab === id).length])), [desk.marks]);
  return (
    <FormContext value={desk}>
      <div className={styles.form}>
        <div className={styles.tabs} role="tablist" aria-label="Parts of the curriculum" onKeyDown={(event) => {
          const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
          if (step === 0) return;
          const next = tabs[(tabs.findIndex((one) => one.id === place.tab) + step + tabs.length) % tabs.length];
          if (!next) return;
          onPlace({...place, tab: next.id});
          event.currentTarget.querySelector<HTMLElement>(`#tab-${next.id}`)?.focus();
        }}>
          {tabs.map(({id, label}) => (
            <button key={id} id={`tab-${id}`} type="button" role="tab" aria-selected={place.tab === id} aria-controls="form-body" tabIndex={place.tab === id ? 0 : -1}
              onClick={() => onPlace({...place, tab: id})}>
              {label}
              {(counts.get(id) ?? 0) > 0 && (
                <span className={styles.count}><Icon name="octagon" />{counts.get(id)}<span className="visually-hidden"> problems</span></span>
              )}
            </button>
          ))}
        </div>
        {stop && (
          <p className={styles.stop} role="status">
            <Icon name="octagon" />
            <span>
              <strong>Line {stop.line}:</strong> {stop.sentence}. Mend it in the text; until then the form only shows what was there before.{' '}
              <button type="button" className={styles.link} onClick={() => onGoToLine(stop.line)}>Go to line {stop.line}</button>
            </span>
          </p>
        )}
        <div className={styles.body} id="form-body" role="tabpanel" aria-labelledby={`tab-${place.tab}`} tabIndex={0}>
          {place.tab === 'general' && <GeneralTab />}
          {place.tab === 'benchmarks' && <BenchmarksTab />}
          {place.tab === 'exercises' && <ExerciseTab chosen={place.exercise} onChoose={(exercise) => onPlace({tab: 'exercises', exercise})} />}
          {place.tab === 'plan' && <PlanTab />}
          {place.tab === 'completion' && <CompletionTab />}
        </div>
      </div>
    </FormContext>
  );
}
