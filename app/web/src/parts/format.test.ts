import {describe, expect, it} from 'vitest';
import {
  digitsToTellApart, formatBound, formatBytes, formatClock, formatCount, formatDifference, formatDuration, formatNumber, formatValue, formatWhen, initialsOf, shortTitle, withoutTitle,
} from './format';

const thin = '\u00a0';

describe('numbers', () => {
  it('has a true minus sign and no trailing zeros', () => {
    expect(formatNumber(-6.22)).toBe('\u22126.22');
    expect(formatNumber(350)).toBe('350');
    expect(formatNumber(0.1)).toBe('0.1');
  });
  it('never shows minus zero', () => expect(formatNumber(-0.001)).toBe('0'));
  it('says that there is no number', () => expect(formatNumber(Number.NaN)).toBe('not a number'));
});

describe('values', () => {
  it.each([
    [379, 's', `379${thin}s`],
    [288.24, 's', `288.2${thin}s`],
    [1.62, 'N', `1.62${thin}N`],
    [0.0431, 'N', `0.043${thin}N`],
    [41, 'N s', `41${thin}N s`],
    [720, 'deg', '720°'],
    [9, 'count', '9'],
  ])('%d %s is %s', (value, unit, text) => expect(formatValue(value, unit)).toBe(text));
  it('says what was not measured', () => expect(formatValue(null, 's')).toBe('not measured'));
  it('shows on which side of a bound a value lies', () => {
    expect(formatDifference(91, 's')).toBe(`+91${thin}s`);
    expect(formatDifference(-12.5, 's')).toBe(`\u221212.5${thin}s`);
    expect(formatBound('<=', 2, 'N')).toBe(`≤${thin}2${thin}N`);
  });
});

it('shows enough decimals to tell a value from its bound', () => {
  expect(digitsToTellApart(379, 288.24, 's')).toBe(1);
  expect(digitsToTellApart(288.249, 288.24, 's')).toBe(2);
  expect(digitsToTellApart(2.00004, 2, 'N')).toBe(5);
  expect(digitsToTellApart(2, 2, 'N')).toBe(2);
  expect(digitsToTellApart(null, 2, 'N')).toBe(2);
});

describe('times', () => {
  it('counts minutes and seconds', () => {
    expect(formatClock(140.9)).toBe('2:20');
    expect(formatClock(-1)).toBe('0:00');
    expect(formatDuration(600)).toBe(`10${thin}minutes`);
    expect(formatDuration(60)).toBe(`1${thin}minute`);
    expect(formatDuration(90)).toBe(`1${thin}minute 30${thin}s`);
    expect(formatDuration(45)).toBe(`45${thin}s`);
  });
  it('names today, then the day, then the year', () => {
    const now = new Date(2026, 10, 22, 12, 0);
    expect(formatWhen(new Date(2026, 10, 22, 9, 42).toISOString(), now)).toBe('Today, 09:42');
    expect(formatWhen(new Date(2026, 10, 20, 16, 5).toISOString(), now)).toBe('20 Nov, 16:05');
    expect(formatWhen(new Date(2025, 10, 20, 16, 5).toISOString(), now)).toBe('20 Nov 2025, 16:05');
    expect(formatWhen(null, now)).toBe('never');
    expect(formatWhen('soon', now)).toBe('soon');
  });
});

it('counts in words', () => {
  expect(formatCount(1, 'trial')).toBe(`1${thin}trial`);
  expect(formatCount(0, 'person', 'people')).toBe(`0${thin}people`);
});

it('shortens a title to its name', () => {
  expect(shortTitle('Linear: feed, retract, feed')).toBe('Linear');
  expect(shortTitle('Sign-off')).toBe('Sign-off');
});

it('does not say the title twice', () => {
  expect(withoutTitle('Linear: a, b: last trial 32.9 s.', 'Linear: a, b')).toBe('Last trial 32.9 s.');
  expect(withoutTitle('Nothing yet.', 'Linear')).toBe('Nothing yet.');
});

it('makes initials', () => {
  expect(initialsOf('Trainee 14')).toBe('T14');
  expect(initialsOf('Ada Lovelace')).toBe('AL');
  expect(initialsOf('')).toBe('');
});

it('says sizes in the unit that reads best', () => {
  expect([0, 999, 1000, 1_250_000, 99_960_000, 999_700_000, 2.5e12].map(formatBytes)).toEqual(
    [`0${thin}bytes`, `999${thin}bytes`, `1${thin}kB`, `1.3${thin}MB`, `100${thin}MB`, `1${thin}GB`, `2.5${thin}TB`]);
});
