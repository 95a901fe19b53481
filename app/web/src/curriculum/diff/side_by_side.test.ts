import {expect, it} from 'vitest';
import {sideBySide} from './DiffLines';

const line = (kind: 'same' | 'added' | 'removed' | 'gap', text: string) => ({kind, text, before: 1, after: 1});

it('puts what is new beside what it replaces', () => {
  const rows = sideBySide([line('same', 'a'), line('removed', 'b'), line('removed', 'c'), line('added', 'B'), line('same', 'd'), line('added', 'e')]);
  expect(rows.map(({left, right}) => [left?.text ?? null, right?.text ?? null])).toEqual([['a', 'a'], ['b', 'B'], ['c', null], ['d', 'd'], [null, 'e']]);
});
