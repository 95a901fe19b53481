import {Button, NativeSelect, SegmentedControl, TextInput} from '@mantine/core';
import {useState} from 'react';
import {Link, useLocation, useSearch} from 'wouter';
import {EmptyState} from '../parts/EmptyState';
import {Loaded} from '../parts/Loaded';
import {Pager} from '../parts/Pager';
import {levelChoices, roles, roleWord} from '../parts/PersonFacts';
import {useResource, useSignedIn} from '../parts/api';
import {formatCount} from '../parts/format';
import {choosePeople, filterOf, groupsOf, isFiltered, peoplePerPage, queryOf, type PeopleFilter} from '../parts/people_filter';
import {needsHelp, peopleOfKind, peopleViews, type PeopleView} from '../parts/people_order';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import type {PersonRow} from '../wire/types';
import {InviteDialog} from './people/InviteDialog';
import {PeopleTable} from './people/PeopleTable';
import styles from './people.module.css';

/** Who is here, and who needs help? */
export function People() {
  useTitle('People');
  const resource = useResource('people', (api) => api.people());
  return <Loaded resource={resource} what="the people">{({people}, retry) => <Page people={people} onChanged={retry} />}</Loaded>;
}

function Page({people, onChanged}: {people: PersonRow[]; onChanged: () => void}) {
  const {session} = useSignedIn();
  const administers = session.role === 'administrator';
  const [inviting, setInviting] = useState(false);
  return (
    <>
      <div className={`page-head ${styles.head}`}>
        <h1>People</h1>
        <span className="muted num">{headline(people)}</span>
        {administers && (
          <span className={styles.actions}>
            <Button component={Link} href={paths.importPeople} variant="default">Import from CSV</Button>
            <Button onClick={() => setInviting(true)}>Invite a person</Button>
          </span>
        )}
      </div>
      <List people={people} administers={administers} />
      {inviting && <InviteDialog onClose={(invited) => {
        setInviting(false);
        if (invited) onChanged();
      }} />}
    </>
  );
}

function headline(people: readonly PersonRow[]): string {
  const live = peopleOfKind(people, 'live');
  const helpless = live.filter(needsHelp).length;
  const here = formatCount(live.length, 'person', 'people');
  if (helpless === 0) return `${here}. Nobody is stuck.`;
  return `${here}. ${formatCount(helpless, 'needs', 'need')} help and ${helpless === 1 ? 'comes' : 'come'} first.`;
}

function List({people, administers}: {people: PersonRow[]; administers: boolean}) {
  const [, navigate] = useLocation();
  const filter = filterOf(new URLSearchParams(useSearch()));
  const change = (part: Partial<PeopleFilter>) => {
    const query = queryOf({...filter, page: 0, ...part}).toString();
    navigate(query === '' ? paths.people : `${paths.people}?${query}`, {replace: true});
  };
  const chosen = choosePeople(people, filter);
  const page = Math.min(filter.page, Math.max(0, Math.ceil(chosen.length / peoplePerPage) - 1));
  const shown = chosen.slice(page * peoplePerPage, (page + 1) * peoplePerPage);
  return (
    <>
      <Filters people={people} filter={filter} onChange={change} />
      <section className="panel" aria-label="List of people">
        <div className="panel-body">
          {shown.length === 0
            ? <Nobody filtered={isFiltered(filter)} onClear={() => change({search: '', role: '', group: '', level: '', status: ''})} />
            : <PeopleTable people={shown} filter={filter} administers={administers} onSort={(sort, reverse) => change({sort, reverse})} />}
          <Pager page={page} size={peoplePerPage} total={chosen.length} what="people" onPage={(next) => change({page: next})} />
        </div>
      </section>
    </>
  );
}

function Nobody({filtered, onClear}: {filtered: boolean; onClear: () => void}) {
  return (
    <EmptyState title="Nobody here">
      {filtered ? <Button variant="default" mt="sm" onClick={onClear}>Show everybody</Button> : 'No one of this kind has been added yet.'}
    </EmptyState>
  );
}

interface FiltersProps {
  people: PersonRow[];
  filter: PeopleFilter;
  onChange: (part: Partial<PeopleFilter>) => void;
}

function Filters({people, filter, onChange}: FiltersProps) {
  const groups = groupsOf(peopleOfKind(people, filter.view));
  return (
    <div className={styles.filters}>
      <SegmentedControl aria-label="Which people" size="sm" value={filter.view} onChange={(value) => onChange({view: value as PeopleView})}
        data={peopleViews.map(({id, label}) => ({value: id, label: `${label} ${peopleOfKind(people, id).length}`}))} />
      <TextInput aria-label="Find by name or group" placeholder="Find by name or group" value={filter.search} type="search"
        onChange={(event) => onChange({search: event.currentTarget.value})} />
      <NativeSelect aria-label="Role" value={filter.role} onChange={(event) => onChange({role: event.currentTarget.value as PeopleFilter['role']})}
        data={[{value: '', label: 'All roles'}, ...roles.map((role) => ({value: role, label: roleWord(role)}))]} />
      <NativeSelect aria-label="Group" value={filter.group} onChange={(event) => onChange({group: event.currentTarget.value})}
        data={[{value: '', label: 'All groups'}, ...groups.map((group) => ({value: group, label: group}))]} />
      <NativeSelect aria-label="Level" value={filter.level} onChange={(event) => onChange({level: event.currentTarget.value as PeopleFilter['level']})}
        data={[{value: '', label: 'All levels'}, ...levelChoices, {value: 'none', label: 'Not set'}]} />
      <NativeSelect aria-label="Status" value={filter.status} onChange={(event) => onChange({status: event.currentTarget.value as PeopleFilter['status']})}
        data={[{value: '', label: 'Any status'}, {value: 'active', label: 'Active'}, {value: 'disabled', label: 'Disabled'},
          {value: 'help', label: 'Needs help'}]} />
    </div>
  );
}
