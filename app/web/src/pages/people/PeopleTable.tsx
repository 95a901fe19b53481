import {useState, type ReactNode} from 'react';
import {Link} from 'wouter';
import {ChartView} from '../../parts/ChartView';
import {Loaded} from '../../parts/Loaded';
import {KindTag, levelWord, roleWord} from '../../parts/PersonFacts';
import {State} from '../../parts/State';
import {useResource} from '../../parts/api';
import {formatWhen, shortTitle} from '../../parts/format';
import type {PeopleFilter, PeopleSort} from '../../parts/people_filter';
import {paths} from '../../parts/paths';
import type {PersonRow} from '../../wire/types';
import styles from '../people.module.css';

interface Props {
  people: PersonRow[];
  filter: PeopleFilter;
  /** Shows the accounts rather than the curves. */
  administers: boolean;
  onSort: (sort: PeopleSort, reverse: boolean) => void;
}

/** One page of the list of people. */
export function PeopleTable({people, filter, administers, onSort}: Props) {
  const column = (sort: PeopleSort, title: string, numeric = false) => (
    <SortHeader sort={sort} filter={filter} numeric={numeric} onSort={onSort}>{title}</SortHeader>
  );
  return (
    <div className="table-scroll">
      <table className="table">
        <thead>
          <tr>
            {column('name', 'Name')}
            {administers && column('role', 'Role')}
            {column('level', 'Level')}
            <th scope="col">Groups</th>
            <th scope="col">Exercises</th>
            {column('trials', 'Trials', true)}
            {column('last', 'Last trial')}
            {administers
              ? <th scope="col">Account</th>
              : <th scope="col"><span className="visually-hidden">Curves</span></th>}
          </tr>
        </thead>
        <tbody>
          {people.map((person) => <PersonLines key={person.person_id} person={person} administers={administers} />)}
        </tbody>
      </table>
    </div>
  );
}

interface SortHeaderProps {
  sort: PeopleSort;
  filter: PeopleFilter;
  numeric: boolean;
  onSort: Props['onSort'];
  children: ReactNode;
}

// numbers and times begin with the highest; a third click gives the usual order back
function SortHeader({sort, filter, numeric, onSort, children}: SortHeaderProps) {
  const active = filter.sort === sort;
  const first = sort === 'trials' || sort === 'last';
  const next = () => {
    if (!active) onSort(sort, first);
    else if (filter.reverse === first) onSort(sort, !first);
    else onSort('help', false);
  };
  return (
    <th scope="col" className={numeric ? 'r' : undefined} aria-sort={!active ? undefined : filter.reverse ? 'descending' : 'ascending'}>
      <button type="button" className={styles.sort} onClick={next}>
        {children}<span aria-hidden="true" className={styles.arrow}>{!active ? '' : filter.reverse ? '↓' : '↑'}</span>
      </button>
    </th>
  );
}

function PersonLines({person, administers}: {person: PersonRow; administers: boolean}) {
  const [open, setOpen] = useState(false);
  const curves = `curves-${person.person_id}`;
  return (
    <>
      <tr>
        <th scope="row">
          <span className={styles.name}>
            <Link href={paths.person(person.person_id)}>{person.display_name}</Link>
            <KindTag kind={person.kind} />
            {!administers && person.kind === 'live' && person.role !== 'trainee' && <span className="tag">{roleWord(person.role)}</span>}
            {!administers && person.disabled && <span className="tag">Disabled</span>}
          </span>
          {administers && person.kind === 'live' && <span className={`xs faint ${styles.account}`}>{person.name}</span>}
        </th>
        {administers && <td className="muted">{roleWord(person.role)}</td>}
        <td className="muted">{levelWord(person.level)}</td>
        <td className="muted">{person.groups.length === 0 ? '–' : person.groups.join(', ')}</td>
        <td><Exercises person={person} /></td>
        <td className="r">{person.trials}</td>
        <td className={`muted ${styles.when}`}>{person.kind === 'published' ? '–' : formatWhen(person.last_trial_utc)}</td>
        {administers
          ? <td>{person.kind === 'live' ? <State state={person.disabled ? 'disabled' : 'active'} /> : <span className="faint">–</span>}</td>
          : (
            <td className="r">
              {person.trials > 0 && (
                <button type="button" className={styles.toggle} aria-expanded={open} aria-controls={curves} onClick={() => setOpen(!open)}>
                  {open ? 'Hide' : 'Curves'}<span className="visually-hidden"> of {person.display_name}</span>
                </button>
              )}
            </td>
          )}
      </tr>
      {open && <tr id={curves}><td colSpan={7}><Curves personId={person.person_id} /></td></tr>}
    </>
  );
}

// How far, and what holds the person up: twenty exercises would not fit in a row.
function Exercises({person}: {person: PersonRow}) {
  if (person.statuses.length === 0) return <span className="faint">–</span>;
  const proficient = person.statuses.filter(({status}) => status === 'proficient' || status === 'waived').length;
  const stuck = person.disabled ? [] : person.statuses.filter(({status}) => status === 'exhausted' || status === 'lapsed');
  return (
    <div className={styles.statuses}>
      <span>{proficient} of {person.statuses.length} proficient</span>
      {stuck.slice(0, 2).map((card) => (
        <span key={card.exercise_id} className={styles.stuck}><State state={card.status} form="short" /> <span className="small">{shortTitle(card.title)}</span></span>
      ))}
      {stuck.length > 2 && <span className="xs faint">and {stuck.length - 2} more</span>}
    </div>
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
