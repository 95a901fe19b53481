// Which people a list shows and in which order, as the address says it: the way back leads to the same list.
import type {Level, PersonRow, Role} from '../wire/types';
import {needsHelp, orderPeople, peopleOfKind, peopleViews, type PeopleView} from './people_order';

export const peoplePerPage = 50;

export type PeopleSort = 'help' | 'name' | 'role' | 'level' | 'trials' | 'last';
export type PersonStatus = 'active' | 'disabled' | 'help';

export interface PeopleFilter {
  view: PeopleView;
  search: string;
  role: Role | '';
  group: string;
  level: Level | 'none' | '';
  status: PersonStatus | '';
  sort: PeopleSort;
  reverse: boolean;
  page: number;   // 0-based
}

const one = <T extends string>(value: string | null, allowed: readonly T[], otherwise: T): T =>
  allowed.find((word) => word === value) ?? otherwise;

export function filterOf(query: URLSearchParams): PeopleFilter {
  const sort = query.get('sort') ?? '';
  const page = Number(query.get('page') ?? '1');
  return {
    view: one(query.get('kind'), peopleViews.map(({id}) => id), 'live'),
    search: query.get('find') ?? '',
    role: one(query.get('role'), ['', 'trainee', 'instructor', 'administrator', 'researcher'], ''),
    group: query.get('group') ?? '',
    level: one(query.get('level'), ['', 'none', 'novice', 'intermediate', 'expert'], ''),
    status: one(query.get('status'), ['', 'active', 'disabled', 'help'], ''),
    sort: one(sort.replace(/^-/, ''), ['help', 'name', 'role', 'level', 'trials', 'last'], 'help'),
    reverse: sort.startsWith('-'),
    page: Number.isInteger(page) && page > 0 ? page - 1 : 0,
  };
}

/** What is as usual stays out of the address. */
export function queryOf(filter: PeopleFilter): URLSearchParams {
  const query = new URLSearchParams();
  const say = (name: string, value: string, usual: string) => { if (value !== usual) query.set(name, value); };
  say('kind', filter.view, 'live');
  say('find', filter.search, '');
  say('role', filter.role, '');
  say('group', filter.group, '');
  say('level', filter.level, '');
  say('status', filter.status, '');
  say('sort', `${filter.reverse ? '-' : ''}${filter.sort}`, 'help');
  say('page', String(filter.page + 1), '1');
  return query;
}

export function isFiltered(filter: PeopleFilter): boolean {
  return filter.search.trim() !== '' || filter.role !== '' || filter.group !== '' || filter.level !== '' || filter.status !== '';
}

function matches(person: PersonRow, filter: PeopleFilter, wanted: string): boolean {
  if (filter.role !== '' && person.role !== filter.role) return false;
  if (filter.group !== '' && !person.groups.includes(filter.group)) return false;
  if (filter.level !== '' && (person.level ?? 'none') !== filter.level) return false;
  if (filter.status === 'disabled' && !person.disabled) return false;
  if (filter.status === 'active' && person.disabled) return false;
  if (filter.status === 'help' && !needsHelp(person)) return false;
  return wanted === '' || [person.display_name, person.name, ...person.groups].some((text) => text.toLowerCase().includes(wanted));
}

const levels: readonly (Level | null)[] = [null, 'novice', 'intermediate', 'expert'];

const compare: Readonly<Record<Exclude<PeopleSort, 'help'>, (a: PersonRow, b: PersonRow) => number>> = {
  name: (a, b) => a.display_name.localeCompare(b.display_name, 'en', {numeric: true}),
  role: (a, b) => a.role.localeCompare(b.role),
  level: (a, b) => levels.indexOf(a.level) - levels.indexOf(b.level),
  trials: (a, b) => a.trials - b.trials,
  last: (a, b) => (a.last_trial_utc ?? '').localeCompare(b.last_trial_utc ?? ''),
};

/** Everybody who matches, in order; the page is cut by the caller. */
export function choosePeople(people: readonly PersonRow[], filter: PeopleFilter): PersonRow[] {
  const wanted = filter.search.trim().toLowerCase();
  const chosen = orderPeople(peopleOfKind(people, filter.view).filter((person) => matches(person, filter, wanted)));
  if (filter.sort === 'help') return filter.reverse ? chosen.reverse() : chosen;
  const order = compare[filter.sort];
  // equal ones stay in the usual order
  return chosen.sort((a, b) => (filter.reverse ? order(b, a) : order(a, b)));
}

/** All groups that occur, as people sort them. */
export function groupsOf(people: readonly PersonRow[]): string[] {
  return [...new Set(people.flatMap((person) => person.groups))].sort((a, b) => a.localeCompare(b, 'en', {numeric: true}));
}
