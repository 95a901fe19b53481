// The text of a curriculum as a tree that knows where everything stands. The text is the truth; the
// tree is read from it and never written back.
import {
  type Document, isAlias, isCollection, isMap, isScalar, isSeq, type Node, type Pair, parseDocument, type Scalar, type YAMLMap,
} from 'yaml';

export type Key = string | number;
export type Path = readonly Key[];
export type Value = string | number | boolean | null | Value[] | {[key: string]: Value};

/** Why the text cannot be read as a whole. */
export interface Stop {
  readonly line: number;  // 1-based
  readonly sentence: string;
}

export interface Source {
  readonly text: string;
  readonly doc: Document;
  readonly value: Value;
  /** null: the form can show and change it. */
  readonly stop: Stop | null;
}

const words: Readonly<Record<string, string>> = {
  TAB_AS_INDENT: 'a tab cannot indent: use spaces',
  DUPLICATE_KEY: 'this key stands here twice: take one of the two out',
  MULTIPLE_DOCS: 'a second document begins here: take the line "---" out',
  MISSING_CHAR: 'a quotation mark or bracket is not closed',
  BAD_INDENT: 'this line is not indented as the lines above ask for',
};

export function readSource(text: string): Source {
  const doc = parseDocument(text, {keepSourceTokens: true, logLevel: 'silent'});
  const stop = stopOf(doc, text);
  return {text, doc, value: stop ? null : (doc.toJS({maxAliasCount: 0}) as Value), stop};
}

function stopOf(doc: Document, text: string): Stop | null {
  const error = doc.errors[0] as {code: string; message: string; linePos?: [{line: number}, ...unknown[]]} | undefined;
  if (error) {
    const detail = words[error.code] ?? (error.message.split('\n', 1)[0] ?? '').replace(/ at line \d+, column \d+:?$/, '');
    return {line: error.linePos?.[0].line ?? 1, sentence: detail.charAt(0).toLowerCase() + detail.slice(1)};
  }
  if (!isMap(doc.contents)) return {line: 1, sentence: 'a curriculum is a list of "key: value" lines'};
  // not part of the format; what they stand for cannot be shown beside them
  const alias = firstAlias(doc.contents);
  return alias === null ? null
    : {line: lineNumber(text, alias), sentence: 'an alias (*name) is not part of the format: write out what it stands for'};
}

function firstAlias(node: unknown): number | null {
  if (isAlias(node)) return node.range?.[0] ?? 0;
  const children: unknown[] = isMap(node) ? node.items.map((pair) => pair.value) : isSeq(node) ? node.items : [];
  for (const child of children) {
    const found = firstAlias(child);
    if (found !== null) return found;
  }
  return null;
}

/** A step down in the value of a source; undefined when there is nothing. */
export function valueIn(value: Value | undefined, path: Path): Value | undefined {
  let at: Value | undefined = value;
  for (const key of path) {
    if (typeof at !== 'object' || at === null) return undefined;
    at = Array.isArray(at) ? at[Number(key)] : Object.hasOwn(at, key) ? at[String(key)] : undefined;
  }
  return at;
}

export function pairOf(map: YAMLMap, key: Key): Pair | undefined {
  return map.items.find((pair) => isScalar(pair.key) && String(pair.key.value) === String(key));
}

export function nodeAt(source: Source, path: Path): Node | null {
  let node: unknown = source.doc.contents;
  for (const key of path) {
    if (isMap(node)) node = pairOf(node, key)?.value;
    else if (isSeq(node)) node = node.items[Number(key)];
    else return null;
  }
  return isScalar(node) || isCollection(node) ? (node as Node) : null;
}

export function rangeOf(node: Node): [number, number] {
  return [node.range?.[0] ?? 0, node.range?.[1] ?? 0];
}

export function keyRange(pair: Pair): [number, number] {
  return rangeOf(pair.key as Scalar);
}

/** Where the last visible character of a node ends: without the line ends and comments after it. */
export function contentEnd(text: string, node: Node | null, fallback: number): number {
  if (node === null) return fallback;
  if (isCollection(node) && !node.flow) {
    const last = node.items.at(-1);
    if (isMap(node) && last !== undefined) return pairEnd(text, last as Pair);
    if (last !== undefined) return contentEnd(text, last as Node, rangeOf(node)[1]);
  }
  const [from, to] = rangeOf(node);
  return from === to ? from : from + text.slice(from, to).trimEnd().length;
}

/** The end of a pair, of `key:` when it has no value. */
export function pairEnd(text: string, pair: Pair): number {
  const colon = text.indexOf(':', keyRange(pair)[1]) + 1;
  const value = pair.value as Node | null;
  return value === null ? colon : Math.max(colon, trimBack(text, colon, contentEnd(text, value, colon)));
}

function trimBack(text: string, from: number, to: number): number {
  return to <= from ? from : from + text.slice(from, to).trimEnd().length;
}

export function lineStart(text: string, offset: number): number {
  return text.lastIndexOf('\n', offset - 1) + 1;
}

export function lineEnd(text: string, offset: number): number {
  const end = text.indexOf('\n', offset);
  if (end < 0) return text.length;
  return text[end - 1] === '\r' ? end - 1 : end;
}

/** 1-based. */
export function lineNumber(text: string, offset: number): number {
  let line = 1;
  for (let at = text.indexOf('\n'); at >= 0 && at < offset; at = text.indexOf('\n', at + 1)) ++line;
  return line;
}

/** The deepest place of the tree that stands at this offset: of a key, what it names. */
export function pathAt(source: Source, offset: number): Path {
  const path: Key[] = [];
  let node: unknown = source.doc.contents;
  for (;;) {
    if (isMap(node)) {
      const pair: Pair | undefined = node.items.find((one) => covers(source.text, keyRange(one)[0], pairEnd(source.text, one), offset));
      if (!pair) return path;
      path.push(String((pair.key as Scalar).value));
      node = pair.value;
    } else if (isSeq(node)) {
      const index = node.items.findIndex((item) => {
        const [from, to] = rangeOf(item as Node);
        return covers(source.text, from, Math.max(to, contentEnd(source.text, item as Node, to)), offset);
      });
      if (index < 0) return path;
      path.push(index);
      node = node.items[index];
    } else {
      return path;
    }
  }
}

function covers(text: string, from: number, to: number, offset: number): boolean {
  return offset >= from && (offset < to || (offset === to && (to === text.length || /[\s,\]}]/.test(text[to] ?? ''))));
}

/** Where in the text a place of the tree stands: its value, or the nearest place above that exists. */
export function placeOf(source: Source, path: Path): number {
  for (let depth = path.length; depth > 0; --depth) {
    const node = nodeAt(source, path.slice(0, depth));
    if (node?.range) return node.range[0];
    const parent = nodeAt(source, path.slice(0, depth - 1));
    const pair = isMap(parent) ? pairOf(parent, path[depth - 1] ?? '') : undefined;
    if (pair) return keyRange(pair)[0];
  }
  return 0;
}
