// Who comes first in the list of people, and which kinds are never mixed.
import type {PersonRow} from '../wire/types';

export type PeopleView = PersonRow['kind'];

export const peopleViews: readonly {id: PeopleView; label: string}[] = [
  {id: 'live', label: 'People'},
  {id: 'simulated', label: 'Simulated operators'},
  {id: 'published', label: 'Published data'},
];

export function peopleOfKind(people: readonly PersonRow[], kind: PeopleView): PersonRow[] {
  return people.filter((person) => person.kind === kind);
}

/** Stuck without an instructor: the trials are used up or the retention test failed. */
export function needsHelp(person: PersonRow): boolean {
  return !person.disabled && person.statuses.some((card) => card.status === 'exhausted' || card.status === 'lapsed');
}

// needs help, then trainees, then staff, then the disabled
function rank(person: PersonRow): number {
  if (person.disabled) return 3;
  if (needsHelp(person)) return 0;
  return person.role === 'trainee' ? 1 : 2;
}

export function orderPeople(people: readonly PersonRow[]): PersonRow[] {
  return [...people].sort((a, b) =>
    rank(a) - rank(b) || a.display_name.localeCompare(b.display_name, 'en', {numeric: true}));
}
