import {expect, it} from 'vitest';
import type {PersonRow, Status} from '../wire/types';
import {numericColumns} from './DataTable';
import {navigationOf} from './paths';
import {needsHelp, orderPeople, peopleOfKind} from './people_order';

const person = (name: string, status: Status, more: Partial<PersonRow> = {}): PersonRow => ({
  person_id: name, display_name: name, name, role: 'trainee', kind: 'live', level: 'novice', groups: [], disabled: false,
  trials: 0, last_trial_utc: null, statuses: [{exercise_id: 'linear', title: 'Linear', status, sentence: ''}], ...more,
});

it('puts who needs help first, staff after trainees and the disabled last', () => {
  const people = [
    person('Away', 'exhausted', {disabled: true}), person('Teacher', 'available', {role: 'instructor'}),
    person('Trainee 10', 'practised'), person('Trainee 2', 'practised'), person('Zoe', 'lapsed'),
  ];
  expect(orderPeople(people).map((one) => one.name)).toEqual(['Zoe', 'Trainee 2', 'Trainee 10', 'Teacher', 'Away']);
  expect(people.filter(needsHelp).map((one) => one.name)).toEqual(['Zoe']);
});

it('never mixes people with simulated operators and published data', () => {
  const people = [person('A', 'available'), person('B', 'available', {kind: 'simulated'}), person('C', 'available', {kind: 'published'})];
  expect(peopleOfKind(people, 'live').map((one) => one.name)).toEqual(['A']);
});

it('lines numbers up and leaves words alone', () => {
  expect(numericColumns({
    columns: ['Person', 'Mean', 'Change', 'Nothing'],
    rows: [['No. 1', '237.3 s', '−12 %', ''], ['No. 2', '≤ 288 s', '–', '']],
  })).toEqual([false, true, true, false]);
});

it('gives each role its own bar', () => {
  expect(navigationOf('trainee').map((entry) => entry.label)).toEqual(['My training', 'My progress', 'Controls', 'Help']);
  expect(navigationOf('instructor').map((entry) => entry.label)).toEqual(['People', 'Compare', 'Help']);
  expect(navigationOf('researcher').map((entry) => entry.label)).toEqual(['Compare', 'Help']);
  expect(navigationOf('administrator')[0]?.label).toBe('People');
  expect(navigationOf('administrator').map((entry) => entry.label)).toContain('System');
});
