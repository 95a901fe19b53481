import {expect, it} from 'vitest';
import type {TrialRow} from '../wire/types';
import {changeWords} from './Standings';
import {countErrors, countTrials} from './trial_counts';
import {usualPaper, withPaper} from './paper';
import {fileNameOf} from './save_file';

const trial = (more: Partial<TrialRow>): TrialRow => ({
  trial_id: 't', exercise_id: 'linear', ordinal: 1, started_utc: '', end_reason: 'completed', source: 'live', device: 'keyboard',
  outcome: 'passed', time_s: 1, target_s: null, force_max_n: null, critical_errors: 0, voided: false, interrupted: false, ...more,
});

const trials = [
  trial({}),
  trial({outcome: 'not_passed', critical_errors: 2}),
  trial({voided: true, critical_errors: 1, end_reason: 'limit'}),
  trial({interrupted: true}),
  trial({outcome: 'invalid', end_reason: 'aborted'}),
  trial({outcome: 'not_passed', end_reason: 'timeout'}),
  trial({outcome: 'not_passed', end_reason: 'timeout', critical_errors: 1}),
  trial({outcome: null, end_reason: null}),
];

it('counts what was started, what is valid and what counts', () => {
  expect(countTrials(trials)).toEqual({started: 8, valid: 5, counted: 4});
  expect(countTrials([])).toEqual({started: 0, valid: 0, counted: 0});
});

it('counts how trials ended, the most frequent first, without voided and running ones', () => {
  expect(countErrors(trials)).toEqual({
    ended: 6, ends: [{reason: 'timeout', count: 2}, {reason: 'aborted', count: 1}], withCritical: 2, critical: 3,
  });
});

it('says whether a change is for the better, by the direction of the metric', () => {
  expect(changeWords(-8.04, 'lower')).toBe('\u22128\u00a0%, better');
  expect(changeWords(-8.04, 'higher')).toBe('\u22128\u00a0%, worse');
  expect(changeWords(12.34, 'lower')).toBe('+12.3\u00a0%, worse');
  expect(changeWords(0.04, 'lower')).toBe('the same');
  expect(changeWords(null, 'lower')).toBe('–');
});

it('knows the paper of a country and asks only for PDF', () => {
  expect([usualPaper('en-US'), usualPaper('es-MX'), usualPaper('de-CH'), usualPaper('de')]).toEqual(['letter', 'letter', 'a4', 'a4']);
  expect(withPaper('/api/cohort.pdf?group=A', 'pdf', 'letter')).toBe('/api/cohort.pdf?group=A&paper=letter');
  expect(withPaper('/api/trials/1.pdf', 'pdf', 'a4')).toBe('/api/trials/1.pdf?paper=a4');
  expect(withPaper('/api/trials/1.csv', 'csv', 'a4')).toBe('/api/trials/1.csv');
});

it('finds the name of a file', () => {
  expect(fileNameOf('attachment; filename="cohort.pdf"', '/x')).toBe('cohort.pdf');
  expect(fileNameOf("attachment; filename=\"a.pdf\"; filename*=UTF-8''%C3%84rzte.pdf", '/x')).toBe('Ärzte.pdf');
  expect(fileNameOf(null, '/api/trials/1.pdf?paper=a4')).toBe('1.pdf');
});
