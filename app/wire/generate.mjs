// Writes what C++ and TypeScript know about the wire from wire.schema.yaml:
//   app/web/src/wire/types.ts     the JSON messages as TypeScript types
//   app/web/src/wire/frame.ts     the decoder of a binary frame
//   app/wire/frame_layout.h       the byte layout of a binary frame for C++
// `node app/wire/generate.mjs` writes the files, `--check` only says whether they are current (exit 1).
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {fileURLToPath, pathToFileURL} from 'node:url';
import path from 'node:path';

const wireDir = path.dirname(fileURLToPath(import.meta.url));
const webDir = path.join(wireDir, '..', 'web');
const requireFromWeb = createRequire(path.join(webDir, 'package.json'));
const importFromWeb = (name) => import(pathToFileURL(requireFromWeb.resolve(name)).href);

const scalars = {
  u16: {size: 2, read: 'getUint16'},
  u32: {size: 4, read: 'getUint32'},
  f32: {size: 4, read: 'getFloat32'},
  f64: {size: 8, read: 'getFloat64'},
};
const note = 'Written by app/wire/generate.mjs from wire.schema.yaml. Change the schema, not this file.';

const upperCamel = (name) => name.split('_').map((word) => word[0].toUpperCase() + word.slice(1)).join('');

// fields packed one after the other, without gaps
function layOut(fields) {
  let offset = 0;
  const placed = fields.map(({name, type}) => {
    const scalar = scalars[type];
    if (!scalar) throw new Error(`wire.schema.yaml: "${name}" has the unknown type "${type}"`);
    const field = {name, type, offset, ...scalar};
    offset += scalar.size;
    return field;
  });
  return {fields: placed, size: offset};
}

async function typesFile(schema) {
  const {compile} = await importFromWeb('json-schema-to-typescript');
  const {'x-frame': _frame, ...jsonSchema} = schema;
  const text = await compile(jsonSchema, 'Wire', {
    bannerComment: `// ${note}`,
    unreachableDefinitions: true,
    additionalProperties: false,
    style: {singleQuote: true, printWidth: 110},
  });
  // drop the comment that only says which definition a type came from, and the root, which is empty
  return text.replace(/\/\*\*\n \* This interface was referenced by[^]*?\*\/\n/g, '')
    .replace(/export interface Wire \{\}\n/, '');
}

function cppFile(frame, parts, endReasons) {
  const out = [
    '#pragma once',
    '',
    '// The byte layout of one binary frame of the live channel: little endian, packed, the header',
    '// first, then limit_count limits, then node_count nodes from the access to the tip.',
    `// ${note}`,
    '',
    '#include <cstddef>',
    '#include <cstdint>',
    '',
    'namespace app::wire {',
    '',
    `inline constexpr std::uint32_t kFrameMagic = 0x${frame.magic.toString(16)}u;`,
    `inline constexpr std::uint16_t kFrameVersion = ${frame.version};`,
    '',
    '// bits of the field flags',
    ...Object.entries(frame.flags).map(
      ([name, bit]) => `inline constexpr std::uint16_t kFlag${upperCamel(name)} = ${bit};`),
    '',
    '// values of the field end_reason',
    ...endReasons.map((name, index) => `inline constexpr std::uint16_t kEndReason${upperCamel(name)} = ${index};`),
  ];
  for (const [name, part] of Object.entries(parts)) {
    out.push('', `// ${name}: byte offsets from its start`, `namespace frame_${name} {`);
    for (const field of part.fields) {
      out.push(`inline constexpr std::size_t k${upperCamel(field.name)}At = ${field.offset};`);
    }
    out.push(`inline constexpr std::size_t kSize = ${part.size};`, `}  // namespace frame_${name}`);
  }
  out.push(
    '',
    'constexpr std::size_t frame_size(std::size_t limit_count, std::size_t node_count) {',
    '  return frame_header::kSize + limit_count * frame_limit::kSize + node_count * frame_node::kSize;',
    '}',
    '',
    '}  // namespace app::wire',
    '');
  return out.join('\n');
}

function decoderFile(frame, parts, endReasons) {
  const skipped = new Set(['magic', 'version', 'reserved']);
  const headerFields = parts.header.fields.filter((field) => !skipped.has(field.name));
  const at = Object.fromEntries(parts.header.fields.map((field) => [field.name, field.offset]));
  const nodeStride = parts.node.size / 4;
  const read = (field, base) => `view.${field.read}(${base}${field.offset}, true)`;
  const flags = Object.entries(frame.flags);
  if (parts.node.fields.some((field) => field.type !== 'f32')) throw new Error('a node holds f32 only');
  return `// ${note}
// Decodes one binary frame of the live channel. Little endian, packed: header, limits, nodes.
import type {EndReason} from './types';

export const frameMagic = 0x${frame.magic.toString(16)};
export const frameVersion = ${frame.version};
export const frameHeaderSize = ${parts.header.size};
export const frameLimitSize = ${parts.limit.size};
export const frameNodeSize = ${parts.node.size};
export const flagBits = {${flags.map(([name, bit]) => `${name}: ${bit}`).join(', ')}} as const;
export const endReasons: readonly EndReason[] = [${endReasons.map((name) => `'${name}'`).join(', ')}];

/** Position of each value of a node in \`nodes\`: node i starts at i * nodeStride. */
export const nodeStride = ${nodeStride};
export const nodeFields = {${parts.node.fields.map((field, index) => `${field.name}: ${index}`).join(', ')}} as const;

export interface FrameLimit {
${parts.limit.fields.map((field) => `  ${field.name}: ${field.name === 'breached' ? 'boolean' : 'number'};`).join('\n')}
}

export interface Frame {
${flags.map(([name]) => `  ${name}: boolean;`).join('\n')}
${headerFields.filter((field) => field.name !== 'flags' && field.name !== 'end_reason')
    .map((field) => `  ${field.name}: number;`).join('\n')}
  /** Why the trial ended; null while it runs. */
  end_reason: EndReason | null;
  limits: FrameLimit[];
  /** node_count times ${parts.node.fields.map((field) => field.name).join(', ')}, from the access to the tip. */
  nodes: Float32Array;
}

export class FrameError extends Error {}

/** Throws FrameError when the bytes are not one whole frame of this version. */
export function decodeFrame(bytes: ArrayBuffer): Frame {
  if (bytes.byteLength < frameHeaderSize) throw new FrameError(\`A frame of \${bytes.byteLength} bytes is too short.\`);
  const view = new DataView(bytes);
  if (view.getUint32(${at.magic}, true) !== frameMagic) throw new FrameError('These bytes are not a frame.');
  const version = view.getUint16(${at.version}, true);
  if (version !== frameVersion) {
    throw new FrameError(\`The server sends frames of version \${version}; this page reads version \${frameVersion}. Reload the page.\`);
  }
  const flags = view.getUint16(${at.flags}, true);
  const limitCount = view.getUint16(${at.limit_count}, true);
  const nodeCount = view.getUint16(${at.node_count}, true);
  const size = frameHeaderSize + limitCount * frameLimitSize + nodeCount * frameNodeSize;
  if (bytes.byteLength !== size) {
    throw new FrameError(\`A frame of \${bytes.byteLength} bytes should have \${size}.\`);
  }
  const ended = (flags & flagBits.ended) !== 0;
  const reason = endReasons[view.getUint16(${at.end_reason}, true)];
  if (ended && reason === undefined) throw new FrameError('The frame names an end reason that this page does not know.');
  return {
${flags.map(([name]) => `    ${name}: (flags & flagBits.${name}) !== 0,`).join('\n')}
${headerFields.filter((field) => field.name !== 'flags' && field.name !== 'end_reason')
    .map((field) => `    ${field.name}: ${read(field, '')},`).join('\n')}
    end_reason: ended && reason !== undefined ? reason : null,
    limits: readLimits(view, limitCount),
    nodes: readNodes(view, frameHeaderSize + limitCount * frameLimitSize, nodeCount),
  };
}

function readLimits(view: DataView, count: number): FrameLimit[] {
  const limits: FrameLimit[] = [];
  for (let index = 0; index < count; ++index) {
    const start = frameHeaderSize + index * frameLimitSize;
    limits.push({${parts.limit.fields.map((field) => {
    const value = `view.${field.read}(start + ${field.offset}, true)`;
    return `${field.name}: ${field.name === 'breached' ? `${value} !== 0` : value}`;
  }).join(', ')}});
  }
  return limits;
}

function readNodes(view: DataView, start: number, count: number): Float32Array {
  const nodes = new Float32Array(count * nodeStride);
  for (let index = 0; index < nodes.length; ++index) nodes[index] = view.getFloat32(start + index * 4, true);
  return nodes;
}
`;
}

const {parse} = await importFromWeb('yaml');
const schema = parse(readFileSync(path.join(wireDir, 'wire.schema.yaml'), 'utf8'));
const frame = schema['x-frame'];
const parts = {header: layOut(frame.header), limit: layOut(frame.limit), node: layOut(frame.node)};
const endReasons = schema.definitions.EndReason.enum;

const files = {
  [path.join(webDir, 'src/wire/types.ts')]: await typesFile(schema),
  [path.join(webDir, 'src/wire/frame.ts')]: decoderFile(frame, parts, endReasons),
  [path.join(wireDir, 'frame_layout.h')]: cppFile(frame, parts, endReasons),
};

let stale = 0;
for (const [file, text] of Object.entries(files)) {
  const shown = path.relative(path.join(wireDir, '..', '..'), file);
  if (!process.argv.includes('--check')) {
    writeFileSync(file, text);
    console.log(`wrote ${shown}`);
    continue;
  }
  let current = '';
  try {
    current = readFileSync(file, 'utf8');
  } catch {
    // a missing file is a stale one
  }
  if (current !== text) {
    console.error(`${shown} is not what wire.schema.yaml says: run node app/wire/generate.mjs`);
    ++stale;
  }
}
process.exitCode = stale > 0 ? 1 : 0;
