import {describe, expect, it} from 'vitest';
import type {CohortRow} from '../../wire/types';
import {cellSentence, helpCount, matching, personFacts, shapeOf} from './cohort_view';
import {placeAfterKey} from './grid_place';
import {heightOf, rowAt, rowsWithin, topOf, totalHeight, type Rows} from './row_window';

const row = (name: string, more: Partial<CohortRow> = {}): CohortRow => ({
  person_id: name, display_name: name, level: 'novice', groups: ['Residents'], needs_help: false, why: '', trials: 3,
  last_trial_utc: null, running_trial_id: null, cells: [], ...more,
});

describe('keys in the grid', () => {
  const size = {rows: 500, columns: 22, page: 10};
  const press = (row_: number, column: number, key: string, ctrl = false) =>
    placeAfterKey({row: row_, column}, {key, ctrl}, size);

  it('moves by one and stops at the edges', () => {
    expect(press(4, 4, 'ArrowDown')).toEqual({row: 5, column: 4});
    expect(press(0, 0, 'ArrowUp')).toEqual({row: 0, column: 0});
    expect(press(499, 21, 'ArrowRight')).toEqual({row: 499, column: 21});
    expect(press(7, 0, 'ArrowLeft')).toEqual({row: 7, column: 0});
  });

  it('goes to the ends of the row, and with Ctrl of the grid', () => {
    expect(press(7, 9, 'Home')).toEqual({row: 7, column: 0});
    expect(press(7, 9, 'End')).toEqual({row: 7, column: 21});
    expect(press(7, 9, 'Home', true)).toEqual({row: 0, column: 0});
    expect(press(7, 9, 'End', true)).toEqual({row: 499, column: 21});
  });

  it('pages without leaving the grid and leaves other keys alone', () => {
    expect(press(3, 2, 'PageUp')).toEqual({row: 0, column: 2});
    expect(press(495, 2, 'PageDown')).toEqual({row: 499, column: 2});
    expect(press(3, 2, 'a')).toBeNull();
    expect(press(3, 2, 'Enter')).toBeNull();
  });
});

describe('the window of rows', () => {
  // three of 64 px, then seven of 44 px
  const rows: Rows = {count: 10, tall: 3, tall_px: 64, usual_px: 44};

  it('knows where each row lies', () => {
    expect([0, 2, 3, 4, 10].map((index) => topOf(rows, index))).toEqual([0, 128, 192, 236, 500]);
    expect(totalHeight(rows)).toBe(500);
    expect([heightOf(rows, 2), heightOf(rows, 3)]).toEqual([64, 44]);
  });

  it('finds the row under a point', () => {
    expect([0, 63, 64, 191, 192, 235, 236, 499, 9999, -5].map((y) => rowAt(rows, y))).toEqual([0, 0, 1, 2, 3, 3, 4, 9, 9, 0]);
  });

  it('draws what is seen and some beyond, in blocks', () => {
    const many: Rows = {count: 500, tall: 0, tall_px: 64, usual_px: 40};
    expect(rowsWithin(many, 0, 400, 10)).toEqual({first: 0, end: 30});
    // rows 50 to 60 are seen: ten more on both sides, in whole tens
    expect(rowsWithin(many, 2000, 2400, 10)).toEqual({first: 40, end: 80});
    expect(rowsWithin(many, 19_600, 20_000, 10)).toEqual({first: 480, end: 500});
    expect(rowsWithin({...many, count: 0}, 0, 400, 10)).toEqual({first: 0, end: 0});
  });
});

describe('what the grid shows', () => {
  it('finds people by every word of name, group and reason, in the order given', () => {
    const people = [row('Ada', {why: 'Linear: force limit', needs_help: true}), row('Bela'), row('Cleo', {groups: ['Fellows']})];
    expect(matching(people, ' force ADA ').map((one) => one.person_id)).toEqual(['Ada']);
    expect(matching(people, 'residents').map((one) => one.person_id)).toEqual(['Ada', 'Bela']);
    expect(matching(people, '').length).toBe(3);
    expect(helpCount(people)).toBe(1);
    expect(helpCount(people.slice(1))).toBe(0);
    expect(helpCount(people.slice(0, 1))).toBe(1);
  });

  it('says in words what a cell stands for', () => {
    expect(cellSentence({status: 'practised', sentence: '1 of 2 passes in a row', trials: 1}))
      .toBe('Practised. 1 of 2 passes in a row. 1\u00a0trial.');
    expect(cellSentence({status: 'lapsed', sentence: '', trials: 4})).toBe('Lapsed, retention failed. 4\u00a0trials.');
    expect(cellSentence(null)).toMatch(/^Not part of/);
  });

  it('says who a person is in one line', () => {
    const now = new Date(2026, 10, 23, 12);
    expect(personFacts(row('A'), now)).toBe('level novice · 3\u00a0trials');
    expect(personFacts(row('A', {last_trial_utc: new Date(2026, 10, 23, 9, 5).toISOString()}), now))
      .toBe('level novice · 3\u00a0trials · last Today, 09:05');
  });

  it('uses whole words where they have room and never squeezes a column', () => {
    expect(shapeOf(1280, 2)).toMatchObject({compact: false, cell: 240});
    expect(shapeOf(1232, 5)).toMatchObject({compact: false});
    expect(shapeOf(1392, 20)).toMatchObject({compact: true, cell: 72});
    expect(shapeOf(2512, 20)).toMatchObject({compact: true, cell: 107});
    expect(shapeOf(700, 20).person).toBe(184);
  });
});
