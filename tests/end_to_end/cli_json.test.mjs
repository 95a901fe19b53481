// What each command prints with --json is what docs/json says.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {after, before, test} from 'node:test';
import {program, repository, requireFromWeb} from './support/places.mjs';

const Ajv = requireFromWeb('ajv').default;
const schemas = path.join(repository, 'docs', 'json');
const ajv = new Ajv({allErrors: true, strict: false});
const folder = mkdtempSync(path.join(tmpdir(), 'cathedra-json-'));
const database = `sqlite:${path.join(folder, 't.db')}`;
let trial = '';

/** Runs a command with --json, checks its exit code and its document, and returns the document. */
function ask(schema, words, exitCode = 0) {
  const {status, stdout, stderr} = spawnSync(program, [...words, '--json'], {encoding: 'utf8', cwd: folder});
  assert.equal(status, exitCode, `cathedra ${words.join(' ')}: ${stdout}${stderr}`);
  const document = JSON.parse(stdout);
  const validate = ajv.compile(JSON.parse(readFileSync(path.join(schemas, `${schema}.schema.json`), 'utf8')));
  assert.ok(validate(document), `${schema}: ${ajv.errorsText(validate.errors)}`);
  return document;
}
const stored = (...words) => [...words, '--database', database];

before(() => {
  trial = ask('exercise-run', stored('exercise', 'run', 'linear', '--seed', '7')).trial_id;
});
after(() => rmSync(folder, {recursive: true, force: true}));

test('every schema is a valid draft-07 schema and stands in the table', () => {
  const table = readFileSync(path.join(schemas, 'README.md'), 'utf8');
  for (const name of readdirSync(schemas).filter((file) => file.endsWith('.schema.json'))) {
    const schema = JSON.parse(readFileSync(path.join(schemas, name), 'utf8'));
    assert.equal(schema.$schema, 'http://json-schema.org/draft-07/schema#', name);
    assert.ok(ajv.validateSchema(schema), `${name}: ${ajv.errorsText()}`);
    assert.ok(table.includes(`(${name})`), `${name} is missing in README.md`);
  }
});

test('several trials of an operator are a list', () => {
  const trials = ask('exercise-run', stored('exercise', 'run', 'linear', '--operator', 'expert', '--seed', '2', '--trials', '2'));
  assert.equal(trials.length, 2);
});

test('trials: list, show, verify, replay', () => {
  const all = ask('trial-list', stored('trial', 'list'));
  assert.ok(all.some((one) => one.trial_id === trial));
  assert.equal(ask('trial-show', stored('trial', 'show', trial)).trial_id, trial);
  assert.equal(ask('trial-verify', stored('trial', 'verify', trial)).confirmed, true);
  assert.ok(ask('trial-replay', stored('trial', 'replay', trial)).samples > 0);
});

test('the comparison of the published data', () => {
  const report = ask('report-compare',
    stored('report', 'compare', '--exercise', 'linear', '--dataset', 'paper', '-o', path.join(folder, 'r.html')));
  assert.equal(report.mann_whitney_u, 0);
});

test('a curriculum with problems and one without', () => {
  const broken = path.join(folder, 'broken.yaml');
  writeFileSync(broken, 'curriculum: [\n');
  assert.ok(ask('curriculum-check', ['curriculum', 'check', broken], 1).problems.length > 0);
  const library = path.join(repository, 'curricula', 'library');
  const good = path.join(library, readdirSync(library).find((name) => name.endsWith('.yaml')));
  assert.deepEqual(ask('curriculum-check', ['curriculum', 'check', good]).ok, true);
});

test('lists from the catalogue and the database', () => {
  for (const [schema, words] of [
    ['exercise-list', ['exercise', 'list']],
    ['curriculum-list', stored('curriculum', 'list')],
    ['user-list', stored('user', 'list')],
    ['instrument-list', ['instrument', 'list']],
    ['anatomy-list', ['anatomy', 'list']],
    ['validate-list', ['validate', 'list']],
  ]) {
    assert.ok(ask(schema, words).length > 0, schema);
  }
});

test('one instrument, one anatomy, one validation case', () => {
  const {instrument} = ask('instrument-list', ['instrument', 'list']).at(-1);
  ask('instrument-show', ['instrument', 'show', instrument]);
  assert.equal(ask('anatomy-show', ['anatomy', 'show', 'straight-phantom']).closed, true);
  assert.equal(ask('validate-run', ['validate', 'run', 'cantilever']).passed, true);
});

test('the doctor, whatever it finds', () => {
  const {status} = spawnSync(program, stored('doctor'), {cwd: folder});
  ask('doctor', stored('doctor'), status);
});

test('a command that fails says why in one document', () => {
  ask('error', stored('exercise', 'run', 'no-such-exercise'), 2);
  ask('error', ['trial', 'list', '--database', 'sqlite:/nowhere/at/all.db'], 1);
});
