import {readFileSync} from 'node:fs';
import {describe, expect, it} from 'vitest';
import {applyChanges, duplicateItem, EditRefused, insertItem, moveItem, removeItem, renameKey, replacePair, same, setValue, setWords} from './edit';
import {lineNumber, pathAt, type Path, placeOf, readSource, type Value, valueIn} from './source';

const library = readFileSync(new URL('../../../../../curricula/library/vascular-basics.yaml', import.meta.url), 'utf8');

const edit = (text: string, change: (source: ReturnType<typeof readSource>) => {from: number; to: number; insert: string}[]) =>
  applyChanges(text, change(readSource(text)));

// the lines of `after` that are not lines of `before` at the same place, counted from both ends
function changedLines(before: string, after: string): {gone: string[]; come: string[]} {
  const a = before.split('\n');
  const b = after.split('\n');
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) ++head;
  let tail = 0;
  while (tail < Math.min(a.length, b.length) - head && a[a.length - 1 - tail] === b[b.length - 1 - tail]) ++tail;
  return {gone: a.slice(head, a.length - tail), come: b.slice(head, b.length - tail)};
}

describe('one value', () => {
  it('changes a number where it stands and nothing else', () => {
    const after = edit(library, (source) => setValue(source, ['exercises', 0, 'steps', 0, 'to_mm'], 340));
    expect(changedLines(library, after)).toEqual({
      gone: ['      - {id: feed-1,  do: translate, to_mm: 350, tolerance_mm: 2, hold_s: 1}'],
      come: ['      - {id: feed-1,  do: translate, to_mm: 340, tolerance_mm: 2, hold_s: 1}'],
    });
  });

  it('keeps quotes and leaves words without them', () => {
    expect(edit('title: {en: "A"}\nid: a\n', (source) => setValue(source, ['title', 'en'], 'B "b"'))).toBe('title: {en: "B \\"b\\""}\nid: a\n');
    expect(edit("a: 'x'\n", (source) => setValue(source, ['a'], "it's"))).toBe("a: 'it''s'\n");
    expect(edit('a: x # why\n', (source) => setValue(source, ['a'], 'two words'))).toBe('a: two words # why\n');
  });

  it.each(['no', '12', '1.5', ': ', '- a', 'a: b', 'a #b', '', 'null', '~', '{', '"', "'", '\\', 'ä', 'x\ny', '@', '*a', '&a', '!t', '%', '?', 'a,b', '0x1', '.5', '1e3', 'é: ö'])(
    'writes %j so that it is read back as the same word', (word) => {
      for (const text of ['a: x\nb: 1\n', 'a: "x"\nb: 1\n', "a: 'x'\nb: 1\n", 'a: >-\n  x\n  y\nb: 1\n', '{a: x, b: 1}\n', 'a:\nb: 1\n']) {
        expect(readSource(edit(text, (source) => setValue(source, ['a'], word))).value).toEqual({a: word, b: 1});
      }
    });

  it('keeps a folded text folded', () => {
    const path = ['exercises', 0, 'goal', 'en'];
    const words = 'Feed it slowly. '.repeat(14).trim();
    const after = edit(library, (source) => setValue(source, path, words));
    expect(valueIn(readSource(after).value, path)).toBe(words);
    expect(after).toContain('      en: >-\n        Feed it slowly.');
    expect(after.split('\n').every((line) => line.length <= 100)).toBe(true);
    const two = edit(library, (source) => setValue(source, path, 'One.\n\nTwo.\nThree.'));
    expect(valueIn(readSource(two).value, path)).toBe('One.\n\nTwo.\nThree.');
  });

  it('adds a key where the format has it and takes it out again', () => {
    const order = ['anatomy', 'instruments', 'start_mm', 'seed'];
    const after = edit(library, (source) => setValue(source, ['exercises', 0, 'scene', 'start_mm'], 20, order));
    expect(after).toContain('{anatomy: s-bend-phantom, instruments: [guidewire-035-straight], start_mm: 20, seed: 17}');
    expect(edit(after, (source) => setValue(source, ['exercises', 0, 'scene', 'start_mm'], undefined))).toBe(library);
  });

  it('adds to a block and takes out of it', () => {
    const text = 'a:\n  - x: 1  # one\n    z: 3\n\nb: 2\n';
    const after = edit(text, (source) => setValue(source, ['a', 0, 'w'], 2, ['x', 'w', 'z']));
    expect(after).toBe('a:\n  - x: 1  # one\n    w: 2\n    z: 3\n\nb: 2\n');
    expect(edit(after, (source) => setValue(source, ['a', 0, 'w'], undefined))).toBe(text);
    expect(edit(text, (source) => setValue(source, ['a', 0, 'x'], undefined))).toBe('a:\n  - z: 3\n\nb: 2\n');
  });

  it('makes the maps above that are missing, and fills a key without a value', () => {
    expect(readSource(edit('a: 1\n', (source) => setValue(source, ['b', 'c', 'd'], 2))).value).toEqual({a: 1, b: {c: {d: 2}}});
    expect(edit('a:\nb: 2\n', (source) => setValue(source, ['a'], 3))).toBe('a: 3\nb: 2\n');
    expect(edit('a:  # later\nb: 2\n', (source) => setValue(source, ['a', 'x'], 3))).toContain('# later');
    expect(edit('x: {a: , b: 2}\n', (source) => setValue(source, ['x', 'a'], 3))).toBe('x: {a: 3, b: 2}\n');
  });

  it('replaces a pair where it stands', () => {
    const after = edit(library, (source) => replacePair(source, ['exercises', 0, 'pass', 'all', 0], 'benchmark', 'value', 80));
    expect(after).toContain('- {metric: time_s, op: "<=", value: 80}');
  });

  it('renames a key', () => {
    expect(edit(library, (source) => renameKey(source, ['benchmarks'], 'linear_time', 'quick'))).toContain('\n  quick:\n    metric: time_s');
  });
});

describe('a list', () => {
  const steps = ['exercises', 0, 'steps'];
  const step = {id: 'stay', do: 'hold', seconds: 3};

  it('takes a new item in the style of the file', () => {
    const after = edit(library, (source) => insertItem(source, steps, 1, step));
    expect(changedLines(library, after)).toEqual({gone: [], come: ['      - {id: stay, do: hold, seconds: 3}']});
    expect(edit(after, (source) => removeItem(source, steps, 1))).toBe(library);
  });

  it('begins a list that is not there, and ends it with its last item', () => {
    expect(edit('a: 1\n', (source) => insertItem(source, ['limits'], 0, {metric: 'time_s'}))).toBe('a: 1\nlimits:\n  - {metric: time_s}\n');
    expect(edit('a: 1\nl:\n  - x\nb: 2\n', (source) => removeItem(source, ['l'], 0))).toBe('a: 1\nb: 2\n');
    expect(edit('a: 1\nl:\n  - x\nb: 2\n', (source) => removeItem(source, ['l'], 0, 'keep'))).toBe('a: 1\nl: []\nb: 2\n');
    expect(edit('l: []\n', (source) => insertItem(source, ['l'], 0, {a: [{b: 1}]}))).toBe('l:\n  - a:\n      - {b: 1}\n');
  });

  it('moves items with the comments right above them', () => {
    const text = 'l:\n  - a\n  # of b\n  - b # beside b\n\n  - c\n';
    expect(edit(text, (source) => moveItem(source, ['l'], 1, 2))).toBe('l:\n  - a\n  - c\n\n  # of b\n  - b # beside b\n');
    expect(edit('l: [a, b,  c]\n', (source) => moveItem(source, ['l'], 0, 2))).toBe('l: [b, c,  a]\n');
  });

  it('moves a whole exercise and back', () => {
    const after = edit(library, (source) => moveItem(source, ['exercises'], 0, 1));
    expect(after).not.toBe(library);
    expect(edit(after, (source) => moveItem(source, ['exercises'], 0, 1))).toBe(library);
  });

  it('duplicates an exercise with its comments and layout', () => {
    const after = edit(library, (source) => duplicateItem(source, ['exercises'], 0, [{path: ['id'], value: 'linear-2'}]));
    const {gone, come} = changedLines(library, after);
    expect(gone).toEqual([]);
    expect(come.join('\n')).toContain('steps:                                  # marks on the handle');
    expect(valueIn(readSource(after).value, ['exercises', 1, 'id'])).toBe('linear-2');
  });

  it('adds and removes single words of a list', () => {
    const record = ['exercises', 0, 'record'];
    const old = valueIn(readSource(library).value, record) as string[];
    const after = edit(library, (source) => setWords(source, record, [...old.filter((word) => word !== 'settle_s'), 'reversals']));
    expect(after).not.toContain('settle_s\n      - idle_s\n      - speed_mean');
    expect(after).toContain('      - wall_hits\n      - reversals\n    pass:');
    const flow = edit('during: [force, progress]  # shown\n', (source) => setWords(source, ['during'], ['progress', 'time']));
    expect(flow).toBe('during: [progress, time]  # shown\n');
  });

  it('refuses what it cannot write and says where', () => {
    const anchored = readSource('a: &x {b: 1}\nc: *x\n');
    expect(anchored.stop?.line).toBe(2);
    expect(() => setValue(anchored, ['a', 'b'], 2)).toThrow(EditRefused);
    expect(() => setValue(readSource('a: 1\nb: x\n'), ['b', 'c'], 2)).toThrow(/line 2/);
  });
});

describe('places', () => {
  it('finds the path of every scalar where it stands', () => {
    const source = readSource(library);
    for (const path of scalarPaths(source.value)) expect(pathAt(source, placeOf(source, path))).toEqual(path);
  });

  it('says which line stops it', () => {
    expect(readSource('a: 1\nb: {c: 1\nd: 2\n').stop?.line).toBe(3);
    expect(readSource('- a\n').stop?.line).toBe(1);
    expect(readSource('a: 1\na: 2\n').stop).toEqual({line: 2, sentence: 'this key stands here twice: take one of the two out'});
  });
});

function scalarPaths(value: Value, at: Path = []): Path[] {
  if (Array.isArray(value)) return value.flatMap((item, index) => scalarPaths(item, [...at, index]));
  if (typeof value === 'object' && value !== null) return Object.entries(value).flatMap(([key, item]) => scalarPaths(item, [...at, key]));
  return [at];
}

function listPaths(value: Value, at: Path = []): Path[] {
  if (Array.isArray(value)) return [at, ...value.flatMap((item, index) => listPaths(item, [...at, index]))];
  if (typeof value === 'object' && value !== null) return Object.entries(value).flatMap(([key, item]) => listPaths(item, [...at, key]));
  return [];
}

// a small generator with a seed, so that a failure comes again
function generator(seed: number): (below: number) => number {
  let state = seed;
  return (below) => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return Math.floor((state / 2147483648) * below);
  };
}

const comments = (text: string) => text.split('\n').flatMap((line) => /(^|\s)(#.*)$/.exec(line)?.[2] ?? []);

describe('random edits', () => {
  it('set one value: it is read back, and no other line changes', {timeout: 60_000}, () => {
    const random = generator(17);
    let text = library;
    const samples: Value[] = [0, -3.25, 1e-7, 350, true, 'steady', 'two words', 'a: b', 'Größe "x"', ''];
    for (let round = 0; round < 120; ++round) {
      const source = readSource(text);
      const paths = scalarPaths(source.value);
      const path = paths[random(paths.length)] ?? [];
      const value = samples[random(samples.length)] ?? 0;
      const after = applyChanges(text, setValue(source, path, value));
      expect(valueIn(readSource(after).value, path)).toEqual(value);
      const {gone, come} = changedLines(text, after);
      const isBlockText = /[>|][+-]?$/.test(text.split('\n')[lineNumber(text, placeOf(source, path)) - 1] ?? '');
      if (!isBlockText) expect(Math.max(gone.length, come.length)).toBeLessThanOrEqual(1);
      expect(comments(after)).toEqual(comments(text));
      text = after;
    }
  });

  it('insert, move, duplicate and remove items: comments stay and undoing gives the text back', {timeout: 60_000}, () => {
    const random = generator(35);
    for (let round = 0; round < 40; ++round) {
      const source = readSource(library);
      const lists = listPaths(source.value);
      const list = lists[random(lists.length)] ?? [];
      const items = valueIn(source.value, list) as Value[];
      const index = random(items.length);
      const item: Value = typeof items[0] === 'object' ? {id: 'new-one', deep: [{a: 1, b: 'two'}]} : 'new_one';
      const more = edit(library, (one) => insertItem(one, list, index, item));
      expect(valueIn(readSource(more).value, [...list, index])).toEqual(item);
      expect(comments(more)).toEqual(comments(library));
      expect(changedLines(library, more).gone.length).toBeLessThanOrEqual(1);
      expect(edit(more, (one) => removeItem(one, list, index))).toBe(library);
      const to = random(items.length);
      const moved = edit(library, (one) => moveItem(one, list, index, to));
      expect(comments(moved).sort()).toEqual(comments(library).sort());
      expect(edit(moved, (one) => moveItem(one, list, to, index))).toBe(library);
      const twice = edit(library, (one) => duplicateItem(one, list, index, []));
      const copies = valueIn(readSource(twice).value, list) as Value[];
      expect(same(copies[index], copies[index + 1])).toBe(true);
    }
  });

  it('add and take out keys of any map', {timeout: 60_000}, () => {
    const random = generator(5);
    const source = readSource(library);
    const maps = [...new Set(scalarPaths(source.value).map((path) => JSON.stringify(path.slice(0, -1))))]
      .map((path) => JSON.parse(path) as Path).filter((path) => !Array.isArray(valueIn(source.value, path)));
    for (let round = 0; round < 40; ++round) {
      const map = maps[random(maps.length)] ?? [];
      const order = random(2) === 0 ? [] : ['id', 'new_key', 'version', 'metric', 'do'];
      const value: Value = [7, {en: 'A text'}, ['a', 'b'], [{x: 1}]][random(4)] ?? 0;
      const after = edit(library, (one) => setValue(one, [...map, 'new_key'], value, order));
      expect(valueIn(readSource(after).value, [...map, 'new_key'])).toEqual(value);
      expect(comments(after)).toEqual(comments(library));
      expect(edit(after, (one) => setValue(one, [...map, 'new_key'], undefined))).toBe(library);
    }
  });
});
