// Changes of single places in the text of a curriculum. Comments, order and layout of everything
// else stay as they are. Each function returns what to replace where, in the coordinates of the text
// it was given, after reading the outcome back: a change that would not say what was asked for is
// refused with the line to change by hand.
import {isMap, isScalar, isSeq, type Node, type Pair, type Scalar, type YAMLMap, type YAMLSeq} from 'yaml';
import {
  contentEnd, type Key, keyRange, lineEnd, lineNumber, lineStart, nodeAt, pairEnd, pairOf, type Path, placeOf, rangeOf,
  readSource, type Source, type Value, valueIn,
} from './source';
import {type Quotes, writeAfterKey, writeFlow, writeItem, writeLong, writeScalar} from './write';

export interface Change {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

export class EditRefused extends Error {}

export function applyChanges(text: string, changes: readonly Change[]): string {
  let result = text;
  for (const change of [...changes].sort((a, b) => b.from - a.from || b.to - a.to)) {
    result = result.slice(0, change.from) + change.insert + result.slice(change.to);
  }
  return result;
}

/** Writes the value there, with the maps above it where they are missing; undefined takes it out. */
export function setValue(source: Source, path: Path, value: Value | undefined, order: readonly string[] = []): Change[] {
  return checked(source, path, () => {
    if (value === undefined) return removed(source, path);
    return nodeAt(source, path) === null ? added(source, path, value, order) : replaced(source, path, value);
  }, (whole) => setIn(whole, path, value));
}

/** The same key under another name and with another value, where it stands: value: 90 -> benchmark: linear_time. */
export function replacePair(source: Source, map: Path, key: string, newKey: string, value: Value): Change[] {
  return checked(source, map, () => {
    const node = nodeAt(source, map);
    const pair = isMap(node) ? pairOf(node, key) : undefined;
    if (!isMap(node) || !pair) throw new EditRefused();
    const [from] = keyRange(pair);
    const name = writeScalar(newKey);
    const text = inFlow(source, map) || node.flow === true
      ? `${name}: ${writeFlow(value)}` : name + ':' + writeAfterKey(value, column(source.text, from), name.length);
    return [{from, to: pairEnd(source.text, pair), insert: text}];
  }, (whole) => {
    const old = valueIn(whole, map) as {[key: string]: Value};
    return setIn(whole, map, {...Object.fromEntries(Object.entries(old).filter(([one]) => one !== key)), [newKey]: value});
  });
}

/** Only the name of a key. */
export function renameKey(source: Source, map: Path, key: string, newKey: string): Change[] {
  return checked(source, map, () => {
    const node = nodeAt(source, map);
    const pair = isMap(node) ? pairOf(node, key) : undefined;
    if (!pair) throw new EditRefused();
    const [from, to] = keyRange(pair);
    return [{from, to, insert: writeScalar(newKey)}];
  }, (whole) => {
    const old = valueIn(whole, map) as {[key: string]: Value};
    return setIn(whole, map, Object.fromEntries(Object.entries(old).map(([one, value]) => [one === key ? newKey : one, value])));
  });
}

/** A new item before `index`; a list that is not there yet is begun. */
export function insertItem(source: Source, list: Path, index: number, value: Value, order: readonly string[] = []): Change[] {
  const node = nodeAt(source, list);
  const items = isSeq(node) ? node.items.length : 0;
  if (items === 0) return setValue(source, list, [value], order);
  return checked(source, list, () => insertedText(source, list, index, (indent) => (indent === null ? writeFlow(value) : writeItem(value, indent))),
    (whole) => changeList(whole, list, (all) => all.splice(index, 0, value)));
}

/** Takes an item out; with the last one goes the list itself, or an empty one stays. */
export function removeItem(source: Source, list: Path, index: number, whenEmpty: 'drop' | 'keep' = 'drop'): Change[] {
  const node = nodeAt(source, list);
  if (!isSeq(node)) throw refusal(source, list);
  if (node.items.length === 1) return setValue(source, list, whenEmpty === 'drop' ? undefined : []);
  return checked(source, list, () => {
    if (node.flow) return [cutPart(source.text, flowParts(source.text, node), index)];
    const slots = slotsOf(source.text, node);
    const slot = slots[index];
    const next = slots[index + 1];
    if (!slot) throw new EditRefused();
    // the empty lines that keep items apart go with it
    return [next ? {from: slot.from, to: next.from, insert: ''} : {from: slots[index - 1]?.to ?? slot.from, to: slot.to, insert: ''}];
  }, (whole) => changeList(whole, list, (all) => all.splice(index, 1)));
}

/** Moves an item to `to`; the comment lines right above an item travel with it. */
export function moveItem(source: Source, list: Path, from: number, to: number): Change[] {
  return checked(source, list, () => {
    const node = nodeAt(source, list);
    if (!isSeq(node)) throw new EditRefused();
    const slots = node.flow ? flowParts(source.text, node) : slotsOf(source.text, node);
    const texts = slots.map((slot) => source.text.slice(slot.from, slot.to));
    texts.splice(to, 0, ...texts.splice(from, 1));
    return slots.flatMap((slot, index) => {
      const insert = texts[index] ?? '';
      return insert === source.text.slice(slot.from, slot.to) ? [] : [{from: slot.from, to: slot.to, insert}];
    });
  }, (whole) => changeList(whole, list, (all) => all.splice(to, 0, ...all.splice(from, 1))));
}

/** A copy right after the item, in its words and layout, with other values at `patches` (below the item). */
export function duplicateItem(source: Source, list: Path, index: number, patches: readonly {path: Path; value: Value}[]): Change[] {
  return checked(source, list, () => {
    const node = nodeAt(source, list);
    if (!isSeq(node)) throw new EditRefused();
    const slot = (node.flow ? flowParts(source.text, node) : slotsOf(source.text, node, false))[index];
    if (!slot) throw new EditRefused();
    const inside = patches.flatMap(({path, value}) => setValue(source, [...list, index, ...path], value));
    const moved = inside.map((change) => ({...change, from: change.from - slot.from, to: change.to - slot.from}));
    const copy = applyChanges(source.text.slice(slot.from, slot.to), moved);
    if (node.flow) return [{from: slot.to, to: slot.to, insert: separator(source.text, flowParts(source.text, node)) + copy}];
    return [{from: slot.to, to: slot.to, insert: gapOf(source.text, slotsOf(source.text, node)) + copy}];
  }, (whole) => changeList(whole, list, (all) => {
    let copy = structuredClone(all[index] ?? null);
    for (const {path, value} of patches) copy = setIn(copy, path, value);
    all.splice(index + 1, 0, copy);
  }));
}

/** Makes a list of words say exactly these: words that stay keep their place and comments. */
export function setWords(source: Source, list: Path, words: readonly string[], order: readonly string[] = []): Change[] {
  const old = (valueIn(source.value, list) ?? []) as string[];
  if (!Array.isArray(old)) return setValue(source, list, [...words], order);
  let at = source;
  const step = (changes: Change[]) => { at = readSource(applyChanges(at.text, changes)); };
  old.filter((word) => !words.includes(word)).forEach((word) => {
    const now = valueIn(at.value, list) as string[];
    step(removeItem(at, list, now.indexOf(word), 'keep'));
  });
  words.filter((word) => !old.includes(word)).forEach((word) => {
    const now = valueIn(at.value, list);
    step(insertItem(at, list, Array.isArray(now) ? now.length : 0, word, order));
  });
  return differenceOf(source.text, at.text);
}

/** The one stretch in which two texts differ. */
export function differenceOf(before: string, after: string): Change[] {
  if (before === after) return [];
  const least = Math.min(before.length, after.length);
  let head = 0;
  while (head < least && before[head] === after[head]) ++head;
  let tail = 0;
  while (tail < least - head && before[before.length - 1 - tail] === after[after.length - 1 - tail]) ++tail;
  return [{from: head, to: before.length - tail, insert: after.slice(head, after.length - tail)}];
}

// ---- how it is done ----

function checked(source: Source, path: Path, make: () => Change[], expect: (whole: Value) => Value): Change[] {
  if (source.stop) throw refusal(source, path);
  let changes: Change[];
  try {
    changes = make();
  } catch (problem) {
    throw problem instanceof EditRefused ? refusal(source, path) : problem;
  }
  const outcome = readSource(applyChanges(source.text, changes));
  if (outcome.stop || !same(outcome.value, expect(structuredClone(source.value)))) throw refusal(source, path);
  return changes;
}

function refusal(source: Source, path: Path): EditRefused {
  const line = lineNumber(source.text, placeOf(source, path));
  return new EditRefused(`Change this in the text: line ${line} is written in a way that the form cannot change.`);
}

function replaced(source: Source, path: Path, value: Value): Change[] {
  const node = nodeAt(source, path);
  if (!node) throw new EditRefused();
  const {text} = source;
  const flow = inFlow(source, path.slice(0, -1));
  const [from] = rangeOf(node);
  const to = contentEnd(text, node, rangeOf(node)[1]);
  const isEmpty = isScalar(node) && from === to;
  if (isScalar(node) && from !== to && (typeof value !== 'object' || value === null)) {
    if (node.value === value) return [];
    return [{from, to, insert: scalarLike(text, node, value, flow)}];
  }
  const parent = nodeAt(source, path.slice(0, -1));
  if (!isMap(parent)) {
    const indent = flow ? 0 : column(text, from === to ? dashBefore(text, from) + 2 : from);
    const insert = flow ? writeFlow(value) : writeItem(value, indent);
    return [{from, to, insert: from === to ? padded(text, from, insert) : insert}];
  }
  const pair = pairOf(parent, path.at(-1) ?? '');
  if (!pair) throw new EditRefused();
  const [keyFrom, keyTo] = keyRange(pair);
  const colon = text.indexOf(':', keyTo) + 1;
  const name = keyTo - keyFrom;
  // a value that is not there stands behind the comment of its line
  const old = isEmpty ? colon : Math.max(colon, to);
  if (flow) return [{from: colon, to: isEmpty ? skipSpaces(text, colon) : old, insert: ` ${writeFlow(value)}`}];
  const insert = writeAfterKey(value, column(text, keyFrom), name);
  // on its own line a value may be followed by a comment, which stays where one line replaces another
  const blockBefore = text.slice(colon, old).includes('\n');
  if (!insert.startsWith('\n') && !blockBefore) return [{from: colon, to: old, insert}];
  const end = lineEnd(text, colon);
  const comment = /^\s*#/.test(text.slice(colon, end)) ? text.slice(colon, end) : '';
  return [{from: colon, to: isEmpty ? colon + comment.length : old, insert: insert.startsWith('\n') ? comment + insert : insert + comment}];
}

function scalarLike(text: string, node: Scalar, value: string | number | boolean | null, flow: boolean): string {
  const quotes: Quotes | undefined = node.type === 'QUOTE_DOUBLE' ? 'double' : node.type === 'QUOTE_SINGLE' ? 'single' : 'bare';
  if (typeof value !== 'string') return writeScalar(value);
  if (node.type === 'BLOCK_FOLDED' || node.type === 'BLOCK_LITERAL') {
    const [from, to] = rangeOf(node);
    const second = text.slice(from, to).split('\n').slice(1).find((line) => line.trim() !== '') ?? '';
    const indent = second.length - second.trimStart().length;
    return writeLong(value, indent > 0 ? indent : column(text, lineStart(text, from)) + 2);
  }
  return flow && quotes === 'bare' && /[,[\]{}]/.test(value) ? writeScalar(value, 'double') : writeScalar(value, quotes);
}

function added(source: Source, path: Path, value: Value, order: readonly string[]): Change[] {
  let depth = path.length - 1;
  while (depth > 0 && nodeAt(source, path.slice(0, depth)) === null) --depth;
  const above = path.slice(0, depth);
  const key = path[depth] ?? '';
  const parts = path.slice(depth + 1);
  const below = parts.reduceRight<Value>((inner, one) => (typeof one === 'number' ? [inner] : {[one]: inner}), value);
  const parent = nodeAt(source, above);
  // `key:` without a value has a node of no length: it becomes the map
  if (isScalar(parent) && parent.value === null && typeof key === 'string') return replaced(source, above, {[key]: below});
  if (!isMap(parent) || typeof key !== 'string') throw new EditRefused();
  if (pairOf(parent, key)) throw new EditRefused();
  return [insertedPair(source, above, parent, key, below, depth === path.length - 1 || order.includes(key) ? order : [])];
}

function insertedPair(source: Source, path: Path, map: YAMLMap, key: string, value: Value, order: readonly string[]): Change {
  const {text} = source;
  const name = writeScalar(key);
  const place = order.indexOf(key);
  const isBefore = (pair: Pair) => order.indexOf(String((pair.key as Scalar).value)) < place;
  const before = place < 0 ? map.items.length : map.items.findLastIndex((pair) => isBefore(pair as Pair)) + 1;
  if (map.flow) {
    const parts = flowParts(text, map);
    const insert = `${name}: ${writeFlow(value)}`;
    return flowInsert(text, rangeOf(map)[0], parts, before, insert);
  }
  const anchor = map.items[Math.max(0, before - 1)] as Pair | undefined;
  const first = map.items[0] as Pair | undefined;
  if (!anchor || !first) throw new EditRefused();
  const indent = column(text, keyRange(first)[0]);
  const at = lineEnd(text, pairEnd(text, anchor));
  const gap = path.length === 0 ? gapOf(text, map.items.map((pair) => ({from: keyRange(pair as Pair)[0], to: pairEnd(text, pair as Pair)}))) : '\n';
  return {from: at, to: at, insert: `${gap}${' '.repeat(indent)}${name}:${writeAfterKey(value, indent, name.length)}`};
}

function removed(source: Source, path: Path): Change[] {
  const key = path.at(-1);
  const parent = nodeAt(source, path.slice(0, -1));
  if (isSeq(parent)) return removeItem(source, path.slice(0, -1), Number(key));
  if (!isMap(parent) || key === undefined) return [];
  const index = parent.items.findIndex((pair) => String((pair.key as Scalar).value) === String(key));
  if (index < 0) return [];
  const {text} = source;
  if (parent.flow) return [cutPart(text, flowParts(text, parent), index)];
  if (parent.items.length === 1) return replaced(source, path.slice(0, -1), {});
  const pair = parent.items[index] as Pair;
  const next = parent.items[index + 1] as Pair | undefined;
  const [from] = keyRange(pair);
  const start = lineStart(text, from);
  if (text.slice(start, from).trim() === '') {
    const end = lineEnd(text, pairEnd(text, pair));
    if (start === 0) return [{from: 0, to: end + 1, insert: ''}];
    // of the empty lines on both sides one is enough
    const above = lineStart(text, start - 1);
    const alone = above > 0 && text.slice(above, start - 1).trim() === '' && text.slice(end + 1, lineEnd(text, end + 1)).trim() === '';
    return [{from: (alone ? above : start) - 1, to: end, insert: ''}];
  }
  // the first key of a list item shares its line with the dash: the next one takes its place
  if (!next) throw new EditRefused();
  return [{from, to: keyRange(next)[0], insert: ''}];
}

interface Slot {
  readonly from: number;
  readonly to: number;
}

// The lines of each item of a block list; with the comment lines right above all but the first.
function slotsOf(text: string, list: YAMLSeq, withComments = true): Slot[] {
  const token = list.srcToken;
  if (token?.type !== 'block-seq') throw new EditRefused();
  const dashes = token.items.flatMap((item) => item.start.filter((one) => one.type === 'seq-item-ind').map((one) => one.offset));
  if (dashes.length !== list.items.length) throw new EditRefused();
  return list.items.map((item, index) => {
    const dash = dashes[index] ?? 0;
    const pad = text.slice(lineStart(text, dash), dash);
    if (pad.trim() !== '') throw new EditRefused();
    let from = lineStart(text, dash);
    while (withComments && index > 0 && from > 0) {
      const above = lineStart(text, from - 1);
      if (!text.startsWith(`${pad}#`, above)) break;
      from = above;
    }
    return {from, to: lineEnd(text, Math.max(dash + 1, contentEnd(text, item as Node, dash + 1)))};
  });
}

function flowParts(text: string, node: YAMLMap | YAMLSeq): Slot[] {
  if (isMap(node)) return (node as YAMLMap).items.map((pair) => ({from: keyRange(pair as Pair)[0], to: flowPairEnd(text, pair as Pair)}));
  return (node as YAMLSeq).items.map((item) => {
    const [from, to] = rangeOf(item as Node);
    return {from, to};
  });
}

function flowPairEnd(text: string, pair: Pair): number {
  const [, keyTo] = keyRange(pair);
  const value = pair.value as Node | null;
  return value === null ? keyTo : pairEnd(text, pair);
}

function insertedText(source: Source, path: Path, index: number, write: (indent: number | null) => string): Change[] {
  const node = nodeAt(source, path);
  if (!isSeq(node)) throw new EditRefused();
  const {text} = source;
  if (node.flow) return [flowInsert(text, rangeOf(node)[0], flowParts(text, node), index, write(null))];
  const slots = slotsOf(text, node);
  const dash = column(text, dashBefore(text, rangeOf(node.items[0] as Node)[0]));
  const item = `${' '.repeat(dash)}- ${write(dash + 2)}`;
  const gap = gapOf(text, slots);
  const slot = slots[index];
  if (slot) return [{from: slot.from, to: slot.from, insert: item + gap}];
  const end = slots.at(-1)?.to ?? 0;
  return [{from: end, to: end, insert: gap + item}];
}

// What stands between the items already: a line end, or an empty line as well.
function gapOf(text: string, slots: readonly Slot[]): string {
  const last = slots.at(-1);
  const before = slots.at(-2);
  const gap = last && before ? text.slice(before.to, last.from) : '\n';
  return /^\n\s*\n/.test(gap) ? '\n\n' : '\n';
}

function separator(text: string, parts: readonly Slot[]): string {
  const last = parts.at(-1);
  const before = parts.at(-2);
  const between = last && before ? text.slice(before.to, last.from) : ', ';
  return /^,\s+$/.test(between) ? between : ', ';
}

function flowInsert(text: string, start: number, parts: readonly Slot[], index: number, insert: string): Change {
  const before = parts[index - 1];
  const after = parts[index];
  const between = separator(text, parts);
  if (before) return {from: before.to, to: before.to, insert: between + insert};
  if (after) return {from: after.from, to: after.from, insert: insert + between};
  return {from: start + 1, to: start + 1, insert};
}

// Takes one part out of a flow collection, with its comma.
function cutPart(text: string, parts: readonly Slot[], index: number): Change {
  const part = parts[index];
  if (!part) throw new EditRefused();
  const next = parts[index + 1];
  const before = parts[index - 1];
  if (before && /^\s*,\s*$/.test(text.slice(before.to, part.from))) return {from: before.to, to: part.to, insert: ''};
  if (next) return {from: part.from, to: next.from, insert: ''};
  if (before) throw new EditRefused();  // a comment between them
  return {from: part.from, to: part.to, insert: ''};
}

function inFlow(source: Source, path: Path): boolean {
  for (let depth = 0; depth <= path.length; ++depth) {
    const node = nodeAt(source, path.slice(0, depth));
    if ((isMap(node) || isSeq(node)) && node.flow) return true;
  }
  return false;
}

function skipSpaces(text: string, offset: number): number {
  let at = offset;
  while (text[at] === ' ') ++at;
  return text[at] === ',' || text[at] === '}' ? at : offset;
}

function dashBefore(text: string, offset: number): number {
  return text.lastIndexOf('-', offset - 1);
}

function padded(text: string, offset: number, insert: string): string {
  return /\s/.test(text[offset - 1] ?? ' ') ? insert : ` ${insert}`;
}

function column(text: string, offset: number): number {
  return offset - lineStart(text, offset);
}

function setIn(whole: Value, path: Path, value: Value | undefined): Value {
  const [key, ...rest] = path;
  if (key === undefined) return value ?? null;
  const base: Value = whole ?? (typeof key === 'number' ? [] : {});
  const inner = rest.length === 0 ? value : setIn(valueIn(base, [key]) ?? null, rest, value);
  if (Array.isArray(base)) {
    if (inner === undefined) return base.filter((_, index) => index !== key);
    const copy = [...base];
    copy[Number(key)] = inner;
    return copy;
  }
  const copy: {[key: string]: Value} = {...(base as {[key: string]: Value})};
  if (inner === undefined) Reflect.deleteProperty(copy, String(key));
  else copy[String(key)] = inner;
  return copy;
}

function changeList(whole: Value, path: Path, change: (list: Value[]) => void): Value {
  const list = [...((valueIn(whole, path) ?? []) as Value[])];
  change(list);
  return setIn(whole, path, list);
}

/** Whether two values say the same; the order of keys does not matter, that of lists does. */
export function same(a: Value | undefined, b: Value | undefined): boolean {
  if (a === b) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (Array.isArray(a) || Array.isArray(b)) {
    return Array.isArray(a) && Array.isArray(b) && a.length === b.length && a.every((item, index) => same(item, b[index]));
  }
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((key: Key) => key in b && same(a[String(key)], b[String(key)]));
}
