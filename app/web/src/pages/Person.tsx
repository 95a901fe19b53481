import {NativeSelect} from '@mantine/core';
import {useState} from 'react';
import {Link, useLocation, useSearch} from 'wouter';
import {Downloads} from '../parts/Downloads';
import {EmptyState} from '../parts/EmptyState';
import {Loaded} from '../parts/Loaded';
import {KindTag, levelWord} from '../parts/PersonFacts';
import {ProgressSections} from '../parts/ProgressSections';
import {useResource, useSignedIn} from '../parts/api';
import {formatCount, formatWhen, shortTitle} from '../parts/format';
import {isThere, paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import {downloads} from '../wire/downloads';
import type {ProgressReport} from '../wire/types';
import {PersonAdministration} from './people/PersonAdministration';
import styles from './person.module.css';

/** How does this person's skill grow? */
export function Person({personId}: {personId: string}) {
  const resource = useResource(`progress ${personId}`, (api) => api.progress(personId));
  return <Loaded resource={resource} what="this person">{(report) => <Page report={report} />}</Loaded>;
}

function Page({report}: {report: ProgressReport}) {
  const {exercises} = report;
  const [person, setPerson] = useState(report.person);
  useTitle(person.display_name);
  const {session} = useSignedIn();
  const chosen = new URLSearchParams(useSearch()).get('exercise') ?? '';
  const shown = chosen === '' ? exercises : exercises.filter((exercise) => exercise.exercise_id === chosen);
  const up = session.role === 'instructor' && person.kind === 'live' && isThere(paths.cohort)
    ? {path: paths.cohort, label: 'Cohort'} : {path: paths.people, label: 'People'};
  return (
    <>
      <nav className="crumbs" aria-label="Breadcrumb">
        <ol><li><Link href={up.path}>{up.label}</Link></li><li aria-hidden="true">/</li><li>{person.display_name}</li></ol>
      </nav>
      <div className={styles.head}>
        <div className={styles.who}>
          <h1>{person.display_name}</h1>
          <KindTag kind={person.kind} />
          <span className="muted num">
            {[`level ${levelWord(person.level)}`, ...person.groups, formatCount(person.trials, 'trial'),
              ...(person.kind === 'published' ? [] : [`last ${formatWhen(person.last_trial_utc)}`])].join(' · ')}
          </span>
        </div>
        <Downloads what={`progress of ${person.display_name}`} href={(kind) => downloads.progress(person.person_id, kind)} />
      </div>
      {session.role === 'administrator' && person.kind === 'live' && (
        <PersonAdministration personId={person.person_id} onChanged={setPerson} />
      )}
      <ExerciseFilter report={report} chosen={chosen} />
      {chosen !== '' && shown.length === 0
        ? <EmptyState title="No such exercise here">This person has no trial of it, and it is not part of the curriculum. Choose another one above.</EmptyState>
        : <ProgressSections exercises={shown} own={false} />}
    </>
  );
}

function ExerciseFilter({report, chosen}: {report: ProgressReport; chosen: string}) {
  const {person, exercises} = report;
  const [, navigate] = useLocation();
  if (exercises.length < 2 && chosen === '') return null;
  const known = exercises.some((exercise) => exercise.exercise_id === chosen);
  return (
    <div className={styles.filter}>
      <NativeSelect aria-label="Exercise" value={chosen}
        data={[
          {value: '', label: `All ${formatCount(exercises.length, 'exercise')}`},
          ...exercises.map((exercise) => ({value: exercise.exercise_id, label: shortTitle(exercise.title)})),
          ...(chosen === '' || known ? [] : [{value: chosen, label: chosen}]),
        ]}
        onChange={(event) => {
          const id = event.currentTarget.value;
          navigate(id === '' ? paths.person(person.person_id) : paths.personExercise(person.person_id, id), {replace: true});
        }} />
    </div>
  );
}
