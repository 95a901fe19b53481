import {SegmentedControl, TextInput} from '@mantine/core';
import {useState} from 'react';
import {Link} from 'wouter';
import {ChartView} from '../parts/ChartView';
import {EmptyState} from '../parts/EmptyState';
import {Loaded} from '../parts/Loaded';
import {KindTag, levelWord} from '../parts/PersonFacts';
import {State} from '../parts/State';
import {useResource} from '../parts/api';
import {formatCount, formatWhen, shortTitle} from '../parts/format';
import {needsHelp, orderPeople, peopleOfKind, peopleViews, type PeopleView} from '../parts/people_order';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import type {PersonRow} from '../wire/types';
import styles from './people.module.css';

/** Who needs help? */
export function People() {
  useTitle('People');
  const resource = useResource('people', (api) => api.people());
  return <Loaded resource={resource} what="the people">{({people}) => <List people={people} />}</Loaded>;
}

function List({people}: {people: PersonRow[]}) {
  const [view, setView] = useState<PeopleView>('live');
  const [search, setSearch] = useState('');
  const wanted = search.trim().toLowerCase();
  const matches = (person: PersonRow) =>
    [person.display_name, person.name, ...person.groups].some((text) => text.toLowerCase().includes(wanted));
  const shown = orderPeople(peopleOfKind(people, view).filter(matches));
  const helpless = peopleOfKind(people, 'live').filter(needsHelp).length;
  return (
    <>
      <div className="page-head">
        <h1>People</h1>
        <span className="muted num">
          {helpless === 0 ? 'Nobody is stuck.' : `${formatCount(helpless, 'person needs', 'people need')} help; they come first.`}
        </span>
      </div>
      <div className={styles.filters}>
        <SegmentedControl aria-label="Which people" size="sm" value={view} onChange={(value) => setView(value as PeopleView)}
          data={peopleViews.map(({id, label}) => ({value: id, label: `${label} ${peopleOfKind(people, id).length}`}))} />
        <TextInput aria-label="Find by name or group" placeholder="Find by name or group" value={search}
          onChange={(event) => setSearch(event.currentTarget.value)} />
      </div>
      <section className="panel" aria-label="List of people">
        <div className="panel-body">
          {shown.length === 0
            ? <EmptyState title="Nobody here">{wanted === '' ? 'No one of this kind has been added yet.' : 'No name or group matches. Clear the search.'}</EmptyState>
            : <PeopleTable people={shown} />}
        </div>
      </section>
    </>
  );
}

function PeopleTable({people}: {people: PersonRow[]}) {
  return (
    <div className="table-scroll">
      <table className="table">
        <thead>
          <tr>
            <th scope="col">Name</th>
            <th scope="col">Level</th>
            <th scope="col">Groups</th>
            <th scope="col">Exercises</th>
            <th scope="col" className="r">Trials</th>
            <th scope="col">Last trial</th>
            <th scope="col"><span className="visually-hidden">Curves</span></th>
          </tr>
        </thead>
        <tbody>
          {people.map((person) => <PersonLines key={person.person_id} person={person} />)}
        </tbody>
      </table>
    </div>
  );
}

function PersonLines({person}: {person: PersonRow}) {
  const [open, setOpen] = useState(false);
  const curves = `curves-${person.person_id}`;
  return (
    <>
      <tr>
        <th scope="row">
          <span className={styles.name}>
            <Link href={paths.person(person.person_id)}>{person.display_name}</Link>
            <KindTag kind={person.kind} />
            {person.kind === 'live' && person.role !== 'trainee' && <span className="tag">{person.role}</span>}
            {person.disabled && <span className="tag">Disabled</span>}
          </span>
        </th>
        <td className="muted">{levelWord(person.level)}</td>
        <td className="muted">{person.groups.length === 0 ? '–' : person.groups.join(', ')}</td>
        <td>{person.statuses.length === 0 ? <span className="faint">–</span> : <Statuses person={person} />}</td>
        <td className="r">{person.trials}</td>
        <td className="muted">{person.kind === 'published' ? '–' : formatWhen(person.last_trial_utc)}</td>
        <td className="r">
          {person.trials > 0 && (
            <button type="button" className={styles.toggle} aria-expanded={open} aria-controls={curves} onClick={() => setOpen(!open)}>
              {open ? 'Hide' : 'Curves'}<span className="visually-hidden"> of {person.display_name}</span>
            </button>
          )}
        </td>
      </tr>
      {open && <tr id={curves}><td colSpan={7}><Curves personId={person.person_id} /></td></tr>}
    </>
  );
}

// The learning curves in place, loaded when they are asked for.
function Curves({personId}: {personId: string}) {
  const resource = useResource(`progress ${personId}`, (api) => api.progress(personId));
  return (
    <Loaded resource={resource} what="the curves">
      {({exercises}) => (
        <div className={styles.curves}>
          {exercises.flatMap((exercise) => exercise.charts.slice(0, 1).map((chart) =>
            <ChartView key={`${exercise.exercise_id} ${chart.id}`} chart={{...chart, title: `${shortTitle(exercise.title)}: ${chart.title}`}} />))}
        </div>
      )}
    </Loaded>
  );
}

function Statuses({person}: {person: PersonRow}) {
  return (
    <ul className={styles.statuses}>
      {person.statuses.map((card) => (
        <li key={card.exercise_id}>
          <span className="small">{shortTitle(card.title)}</span>
          <State state={card.status} />
          <span className={`xs faint ${styles.sentence}`}>{card.sentence}</span>
        </li>
      ))}
    </ul>
  );
}
