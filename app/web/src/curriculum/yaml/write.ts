// New YAML in the style of the built-in curricula: short things on one line, long lists one item a line.
import type {Value} from './source';

const widest = 100;
const foldAt = 92;

// what other readers of YAML take for something else than a word
const reserved = new Set(['true', 'false', 'null', 'yes', 'no', 'on', 'off', 'y', 'n']);
const bareWord = /^[A-Za-z][A-Za-z0-9_-]*$/;
const bareVersion = /^\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?$/;
const bareSentence = /^[\p{L}][\p{L}\p{N} _.()/-]*$/u;

export type Quotes = 'bare' | 'single' | 'double';

/** The value as a scalar on one line; a string without quotes only where that is safe. */
export function writeScalar(value: string | number | boolean | null, quotes?: Quotes): string {
  if (value === null) return 'null';
  if (typeof value === 'number') return writeNumber(value);
  if (typeof value === 'boolean') return String(value);
  if (quotes === 'single' && /^[ -~\u00a0-\ud7ff]*$/.test(value)) return `'${value.replaceAll("'", "''")}'`;
  if (quotes === 'double') return JSON.stringify(value);
  const bare = quotes === 'bare' ? bareSentence : bareWord;
  const safe = (bare.test(value) && !value.endsWith(' ') && !reserved.has(value.toLowerCase())) || bareVersion.test(value);
  return safe ? value : JSON.stringify(value);
}

/** 350 -> "350", 1e-7 -> "0.0000001": no exponent, which not every reader takes for a number. */
export function writeNumber(value: number): string {
  const text = String(value);
  return text.includes('e') ? value.toFixed(12).replace(/\.?0+$/, '') : text;
}

export function writeFlow(value: Value): string {
  if (Array.isArray(value)) return `[${value.map(writeFlow).join(', ')}]`;
  if (typeof value === 'object' && value !== null) {
    return `{${Object.entries(value).map(([key, one]) => `${writeScalar(key)}: ${writeFlow(one)}`).join(', ')}}`;
  }
  return writeScalar(value);
}

/** What follows `key:` in a block: " 3", or a line end and a block `indent` + 2 deep. */
export function writeAfterKey(value: Value, indent: number, keyLength: number): string {
  const pad = ' '.repeat(indent + 2);
  if (typeof value === 'string' && value.length > 60) return ` ${writeLong(value, indent + 2)}`;
  const flow = writeFlow(value);
  if (typeof value !== 'object' || value === null || (isFlat(value) && indent + keyLength + 2 + flow.length <= widest)) return ` ${flow}`;
  if (Array.isArray(value)) return value.map((item) => `\n${pad}- ${writeItem(item, indent + 4)}`).join('');
  return `\n${pad}${writeBlock(value, indent + 2)}`;
}

/** What follows `- ` of a block list whose items' text begins `indent` deep. */
export function writeItem(value: Value, indent: number): string {
  const flow = writeFlow(value);
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return flow;
  return isFlat(value) && indent + flow.length <= widest ? flow : writeBlock(value, indent);
}

// the first key without its indentation, because something stands before it on its line
function writeBlock(map: {[key: string]: Value}, indent: number): string {
  return Object.entries(map).map(([key, value]) => {
    const name = writeScalar(key);
    return `${name}:${writeAfterKey(value, indent, name.length)}`;
  }).join(`\n${' '.repeat(indent)}`);
}

// lists of maps read better one to a line
function isFlat(value: Value): boolean {
  if (typeof value !== 'object' || value === null) return true;
  if (Array.isArray(value)) return value.every((item) => typeof item !== 'object' || item === null);
  return Object.values(value).every(isFlat);
}

/** A long text as a folded block where that gives the same text back, else in quotes on one line. */
export function writeLong(value: string, indent: number): string {
  const folded = writeFolded(value, indent);
  return folded ?? JSON.stringify(value);
}

function writeFolded(value: string, indent: number): string | null {
  const text = value.endsWith('\n') ? value.slice(0, -1) : value;
  if (text === '' || /^\s|\s$|[^\S \n]|[ ]{2}|\n | \n|[\u0000-\u0009\u007f\u0085\ufeff]/u.test(text)) return null;
  const pad = ' '.repeat(indent);
  const width = Math.max(40, foldAt - indent);
  // n line ends of the text are n empty lines of the block
  const body = text.split(/(\n+)/).map((part) =>
    part.startsWith('\n') ? `${part}\n` : wrap(part, width).map((line) => pad + line).join('\n')).join('');
  return `${value.endsWith('\n') ? '>' : '>-'}\n${body}`;
}

function wrap(paragraph: string, width: number): string[] {
  const lines: string[] = [];
  let line = '';
  for (const word of paragraph.split(' ')) {
    if (line !== '' && line.length + 1 + word.length > width) {
      lines.push(line);
      line = word;
    } else {
      line = line === '' ? word : `${line} ${word}`;
    }
  }
  return [...lines, line];
}
