import {expect, it} from 'vitest';
import type {PersonRow} from '../wire/types';
import {choosePeople, filterOf, groupsOf, isFiltered, queryOf} from './people_filter';

const person = (name: string, more: Partial<PersonRow> = {}): PersonRow => ({
  person_id: name, display_name: name, name: name.toLowerCase(), role: 'trainee', kind: 'live', level: 'novice', groups: [],
  disabled: false, trials: 0, last_trial_utc: null, statuses: [], ...more,
});

const people = [
  person('Resident 10', {groups: ['2026', 'Night'], trials: 3, last_trial_utc: '2026-11-20T09:00:00Z'}),
  person('Resident 2', {groups: ['2025'], level: 'expert', trials: 12, last_trial_utc: '2026-11-21T09:00:00Z'}),
  person('Teacher', {role: 'instructor', level: null}),
  person('Gone', {disabled: true, groups: ['2026']}),
  person('Operator', {kind: 'simulated'}),
];

const names = (query: string) => choosePeople(people, filterOf(new URLSearchParams(query))).map((one) => one.display_name);

it('finds by name, sign-in name and group, and narrows by role, group, level and status', () => {
  expect(names('')).toEqual(['Resident 2', 'Resident 10', 'Teacher', 'Gone']);
  expect(names('find=night')).toEqual(['Resident 10']);
  expect(names('find=RESIDENT')).toEqual(['Resident 2', 'Resident 10']);
  expect(names('role=instructor')).toEqual(['Teacher']);
  expect(names('group=2026')).toEqual(['Resident 10', 'Gone']);
  expect(names('group=2026&status=active')).toEqual(['Resident 10']);
  expect(names('level=none')).toEqual(['Teacher']);
  expect(names('status=disabled')).toEqual(['Gone']);
  expect(names('kind=simulated')).toEqual(['Operator']);
});

it('sorts by a column in both directions and keeps the usual order among equals', () => {
  expect(names('sort=-trials')).toEqual(['Resident 2', 'Resident 10', 'Teacher', 'Gone']);
  expect(names('sort=last')).toEqual(['Teacher', 'Gone', 'Resident 10', 'Resident 2']);
  expect(names('sort=level')).toEqual(['Teacher', 'Resident 10', 'Gone', 'Resident 2']);
});

it('says a filter in the address and reads it back; nonsense is as usual', () => {
  const query = 'kind=simulated&find=a+b&role=trainee&group=2026&level=expert&status=active&sort=-name&page=3';
  expect(queryOf(filterOf(new URLSearchParams(query))).toString()).toBe(query);
  expect(queryOf(filterOf(new URLSearchParams('kind=x&role=boss&sort=-size&page=-4'))).toString()).toBe('sort=-help');
  expect(isFiltered(filterOf(new URLSearchParams('sort=name')))).toBe(false);
  expect(isFiltered(filterOf(new URLSearchParams('group=2026')))).toBe(true);
});

it('names every group once', () => {
  expect(groupsOf(people)).toEqual(['2025', '2026', 'Night']);
});
