import {expect, it} from 'vitest';
import {commentProblem, lastMoment, readTrialTime, reasonProblem} from './judgement';

it('takes a reason of 10 to 500 characters, blanks around it not counted', () => {
  expect(reasonProblem('1234567890')).toBe('');
  expect(reasonProblem('x'.repeat(500))).toBe('');
  expect(reasonProblem(`  ${'x'.repeat(500)}\n`)).toBe('');
  expect(reasonProblem('123456789')).toMatch(/at least 10/);
  expect(reasonProblem('   12345    ')).toMatch(/at least 10/);
  expect(reasonProblem('x'.repeat(501))).toMatch(/at most 500/);
});

it('counts long text as the server does, where a letter may take more than one byte', () => {
  expect(reasonProblem('ü'.repeat(250))).toBe('');
  expect(reasonProblem('ü'.repeat(251))).toMatch(/at most 500/);
  expect(commentProblem('é'.repeat(1001))).toMatch(/at most 2000/);
});

it('takes a comment that says something', () => {
  expect(commentProblem('Slow down.')).toBe('');
  expect(commentProblem('x'.repeat(2000))).toBe('');
  expect(commentProblem(' \n ')).toMatch(/Write something/);
});

it('reads a time as minutes and seconds, as seconds, or as none', () => {
  expect(readTrialTime('', 60)).toEqual({time_s: null});
  expect(readTrialTime('  ', 60)).toEqual({time_s: null});
  expect(readTrialTime('1:23', null)).toEqual({time_s: 83});
  expect(readTrialTime('1:03,5', null)).toEqual({time_s: 63.5});
  expect(readTrialTime('83', null)).toEqual({time_s: 83});
  expect(readTrialTime('12.5', null)).toEqual({time_s: 12.5});
});

it.each(['1:60', '1:2', '1:234', ':10', '-3', 'at the end', '1:2:3', '1e3', '.5'])('refuses the time %s', (written) => {
  expect(readTrialTime(written, null)).toHaveProperty('problem');
});

it('refuses a time after the end, where the end is known', () => {
  expect(readTrialTime('1:23', 82.4)).toEqual({time_s: 83});
  expect(readTrialTime('1:24', 82.4)).toHaveProperty('problem');
  expect(readTrialTime('20:00', null)).toEqual({time_s: 1200});
});

it('knows the end of a trial from its time and events', () => {
  expect(lastMoment(60, [{time_s: 12}, {time_s: 61.5}])).toBe(61.5);
  expect(lastMoment(60, [])).toBe(60);
  expect(lastMoment(null, [{time_s: 12}])).toBeNull();
});
