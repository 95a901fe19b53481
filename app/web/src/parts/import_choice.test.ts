import {expect, it} from 'vitest';
import type {ImportPreview, ImportRow} from '../wire/types';
import {importChoice, orderRows} from './import_choice';

const row = (line: number, action: ImportRow['action']): ImportRow => ({line, name: `n${line}`, display_name: `N ${line}`, action, sentence: ''});

const preview = (more: Partial<ImportPreview>): ImportPreview => ({
  rows: [row(2, 'add')], add: 0, change: 0, unchanged: 0, broken: 0, problems: [], sha256: 'x', ...more,
});

it('says how many rows the button takes and how many it leaves out', () => {
  expect(importChoice(preview({add: 24, change: 3, broken: 3}))).toMatchObject({
    action: 'Import the 27 right rows, leave out 3', possible: true, skipBroken: true});
  expect(importChoice(preview({add: 1}))).toMatchObject({action: 'Import 1\u00a0row', possible: true, skipBroken: false});
});

it('says why nothing can be imported', () => {
  expect(importChoice(preview({add: 2, problems: ['No column "name".']})).possible).toBe(false);
  expect(importChoice(preview({broken: 3})).sentence).toMatch(/No row can be imported/);
  expect(importChoice(preview({unchanged: 3})).sentence).toMatch(/already/);
  expect(importChoice(preview({rows: []})).sentence).toMatch(/no row/);
});

it('shows the broken rows first and keeps the order of the file', () => {
  const rows = [row(2, 'unchanged'), row(3, 'add'), row(4, 'broken'), row(5, 'change'), row(6, 'add'), row(7, 'broken')];
  expect(orderRows(rows).map(({line}) => line)).toEqual([4, 7, 3, 6, 5, 2]);
});
