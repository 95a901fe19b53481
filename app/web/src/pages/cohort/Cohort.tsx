import {NativeSelect, TextInput} from '@mantine/core';
import {useEffect, useMemo, useRef, useState} from 'react';
import {useLocation, useSearch} from 'wouter';
import {Downloads} from '../../parts/Downloads';
import {EmptyState} from '../../parts/EmptyState';
import {ErrorState} from '../../parts/ErrorState';
import {Loading} from '../../parts/Loading';
import {useResource} from '../../parts/api';
import {formatCount} from '../../parts/format';
import {paths} from '../../parts/paths';
import {usePolled} from '../../parts/use_polled';
import {useTitle} from '../../parts/use_title';
import {downloads} from '../../wire/downloads';
import type {Cohort as CohortData} from '../../wire/types';
import styles from './cohort.module.css';
import {CohortGrid} from './CohortGrid';
import {matching, widestGrid} from './cohort_view';

const liveInterval_ms = 5000;

/** Who needs help, and why? */
export function Cohort() {
  useTitle('Cohort');
  const group = new URLSearchParams(useSearch()).get('group') ?? '';
  const resource = useResource(`cohort ${group}`, (api) => api.cohort(group));
  // what was there stays while another group, or news, is being loaded
  const [kept, setKept] = useState<CohortData | null>(null);
  if (resource.state === 'ready' && resource.value !== kept) setKept(resource.value);

  if (resource.state === 'failed') return <ErrorState problem={resource.problem} onRetry={resource.retry} />;
  if (!kept) return <Loading what="the cohort" />;
  return <Page cohort={kept} group={group} busy={resource.state === 'loading'} refresh={resource.state === 'ready' ? resource.retry : null} />;
}

interface Props {
  cohort: CohortData;
  group: string;
  busy: boolean;
  refresh: (() => void) | null;
}

function Page({cohort, group, busy, refresh}: Props) {
  const [search, setSearch] = useState('');
  const [, navigate] = useLocation();
  const running = useRunning(cohort, refresh);
  const people = useMemo(() => matching(cohort.people, search), [cohort, search]);
  return (
    <div className={styles.cohort} style={{maxWidth: widestGrid(cohort.exercises.length)}} aria-busy={busy}>
      <div className={styles.top}>
        <h1>Cohort</h1>
        <NativeSelect aria-label="Group" value={group}
          data={[{value: '', label: cohort.groups.length === 1 ? cohort.groups[0] ?? 'My group' : 'All my groups'},
            ...(cohort.groups.length === 1 ? [] : cohort.groups.map((name) => ({value: name, label: name})))]}
          onChange={(event) => {
            const chosen = event.currentTarget.value;
            navigate(chosen === '' ? paths.cohort : paths.cohortOf(chosen));
          }} />
        <TextInput aria-label="Find by name, group or reason" placeholder="Find by name, group or reason" className={styles.search}
          value={search} onChange={(event) => setSearch(event.currentTarget.value)} />
        <span className="small muted num">{formatCount(people.length, 'person', 'people')}</span>
        <span className="grow" />
        <Downloads what="cohort report" href={(kind) => downloads.cohort(group, kind)} />
      </div>
      <p className={`num ${styles.headline}`}>{cohort.headline}</p>
      {people.length > 0
        ? (
          <CohortGrid
            caption={`${group === '' ? 'All my groups' : group}: state of each exercise, person by person`}
            people={people} exercises={cohort.exercises} running={running}
          />
        )
        : (
          <section className="panel"><div className="panel-body">
            {search === ''
              ? <EmptyState title="Nobody here yet">Trainees who share a group with you stand here. Ask your administrator to put you and them in one.</EmptyState>
              : <EmptyState title="Nobody matches">No name, group or reason holds these words. Clear the search to see everybody.</EmptyState>}
          </div></section>
        )}
    </div>
  );
}

// Who is at it right now; when one begins or ends the states may have changed too.
function useRunning(cohort: CohortData, refresh: (() => void) | null): ReadonlyMap<string, string> {
  const {value} = usePolled((api) => api.live(), liveInterval_ms);
  const heard = useRef<string | null>(null);
  const news = value?.trials.map((trial) => trial.trial_id).sort().join(' ') ?? null;
  useEffect(() => {
    if (news === null || !refresh) return;
    const before = heard.current;
    heard.current = news;
    if (before !== null && before !== news) refresh();
  }, [news, refresh]);
  return useMemo(() => {
    const pairs = value
      ? value.trials.map((trial) => [trial.person_id, trial.trial_id] as const)
      : cohort.people.flatMap((person) => (person.running_trial_id === null ? [] : [[person.person_id, person.running_trial_id] as const]));
    return new Map(pairs);
  }, [value, cohort]);
}
