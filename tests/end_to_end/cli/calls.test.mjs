// Every command explains itself, answers in JSON, and ends with 0, 1 or 2 as it says.
import assert from 'node:assert/strict';
import {existsSync, lstatSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync} from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {repository} from '../support/places.mjs';
import {run, temporaryFolder} from './command.mjs';

const folder = temporaryFolder();
const at = (name) => path.join(folder, name);

const groups = {
  exercise: ['list', 'run'], trial: ['list', 'show', 'verify', 'replay'], report: ['compare'],
  curriculum: ['check', 'publish', 'list', 'show', 'copy', 'diff'],
  user: ['add', 'list', 'disable', 'enable', 'reset'], instrument: ['list', 'show'],
  anatomy: ['list', 'show'], validate: ['list', 'run'],
};
const commands = [['serve'], ['demo'], ['doctor'],
  ...Object.entries(groups).flatMap(([name, subs]) => [[name], ...subs.map((sub) => [name, sub])])];

test('every command has a help page with an example', () => {
  for (const command of commands) {
    const {code, out} = run(...command, '--help');
    assert.equal(code, 0, command.join(' '));
    assert.match(out, new RegExp(`Example: cathedra ${command[0]}`), command.join(' '));
  }
  assert.equal(run('--help').code, 0);
  assert.match(run('--version').out, /^cathedra \d+\.\d+\.\d+\n$/);
});

test('--json prints one document', () => {
  const lists = [['exercise', 'list'], ['curriculum', 'list', '--database', `sqlite:${at('none.db')}`],
    ['instrument', 'list'], ['anatomy', 'list'], ['validate', 'list']];
  for (const command of lists) {
    const {code, json} = run(...command, '--json');
    assert.equal(code, 0, command.join(' '));
    assert.ok(Array.isArray(json) && json.length > 0, command.join(' '));
  }
  assert.deepEqual(run('exercise', 'list', '--json').json.map((row) => row.exercise), ['linear', 'rotational']);
  assert.equal(run('instrument', 'show', 'catheter-5f-angled', '--json').code, 0);
  assert.equal(run('anatomy', 'show', 'straight-phantom', '--json').json.closed, true);
  assert.match(run('curriculum', 'copy', 'vascular-basics', '--as', 'ours', '--json').json.yaml, /id: ours/);
  const doctor = run('doctor', '--database', `sqlite:${at('none.db')}`, '--json').json;
  assert.ok(doctor.findings.some((finding) => finding.what === 'catalogue' && finding.good));
});

test('a wrong call ends with 2 and says what is wrong', () => {
  const calls = [[], ['steer'], ['trial'], ['exercise', 'run'], ['exercise', 'run', 'linear', '--operator', 'wizard'],
    ['exercise', 'run', 'linear', '--seed', 'x'], ['exercise', 'run', 'linear', '--trials', '0'],
    ['report', 'compare', '--exercise', 'linear', '--dataset', 'all'], ['report', 'compare'],
    ['trial', 'list', '--database', 'mysql:x'], ['doctor', '--no-such-option']];
  for (const call of calls) {
    const {code, err} = run(...call);
    assert.equal(code, 2, call.join(' '));
    assert.ok(err.length > 10, call.join(' '));
  }
});

test('an unknown exercise is refused with the known ones, and makes no database', () => {
  const file = at('unknown.db');
  const {code, err} = run('exercise', 'run', 'liner', '--database', `sqlite:${file}`);
  assert.equal(code, 2);
  assert.match(err, /"liner".*linear, rotational/s);
  assert.equal(run('report', 'compare', '--exercise', 'liner', '--database', `sqlite:${file}`).code, 2);
  assert.equal(existsSync(file), false);
});

test('a database that is not there is named and not made', () => {
  const file = at('missing.db');
  const calls = [['trial', 'list'], ['trial', 'show', 'x'], ['trial', 'verify', 'x'], ['trial', 'replay', 'x'],
    ['report', 'compare', '--exercise', 'linear', '--dataset', 'live']];
  for (const call of calls) {
    const {code, err} = run(...call, '--database', `sqlite:${file}`);
    assert.equal(code, 1, call.join(' '));
    assert.match(err, /there is no database/, call.join(' '));
  }
  assert.match(run('trial', 'list', '--database', `sqlite:${file}`, '--json').json.error, /no database/);
  assert.equal(existsSync(file), false);
});

test('a file that is no database is refused and left as it is', () => {
  const file = at('letter.txt');
  writeFileSync(file, 'Dear reader, this is no database, however long one looks at it.\n'.repeat(40));
  const before = readFileSync(file);
  const {code, err} = run('trial', 'list', '--database', `sqlite:${file}`);
  assert.equal(code, 1);
  assert.ok(err.length > 10);
  assert.deepEqual(readFileSync(file), before);
});

test('every problem of a broken curriculum is found in one pass, with its line', () => {
  const file = path.join(repository, 'tests/fixtures/curricula/broken.yaml');
  const {code, out} = run('curriculum', 'check', file);
  assert.equal(code, 1);
  const found = out.trim().split('\n').filter((line) => line.startsWith(file));
  assert.ok(found.length >= 10, out);
  for (const line of found) assert.match(line, /:\d+:\d+: (error|warning): ./);
  assert.equal(run('curriculum', 'check', file, '--json').json.problems.length, found.length);
});

test('malformed YAML and an absent file are problems, not crashes', () => {
  const file = at('bad.yaml');
  writeFileSync(file, 'schema: cathedra-curriculum/1\nid: [unclosed\n');
  const {code, out} = run('curriculum', 'check', file);
  assert.equal(code, 1);
  assert.match(out, /bad\.yaml:\d+:\d+: error: /);
  assert.equal(run('curriculum', 'check', at('absent.yaml')).code, 1);
  const diff = run('curriculum', 'diff', file, file, '--json');
  assert.equal(diff.code, 1);
  assert.match(diff.json.error, /has problems/);
});

test('a validation case refuses parameters that it does not have or cannot take', () => {
  for (const setting of ['load', 'load=', 'load=much', 'load=1x', 'nosuch=1', 'load=-1e9', 'load=nan', 'elements=0']) {
    const {code, err} = run('validate', 'run', 'cantilever', '--set', setting);
    assert.equal(code, 2, setting);
    assert.ok(err.length > 10, setting);
  }
  assert.equal(run('validate', 'run', 'no-such-case').code, 2);
});

test('what cannot be written says so and leaves nothing half-written', () => {
  const compare = ['report', 'compare', '--exercise', 'linear', '--dataset', 'paper', '--database', `sqlite:${at('paper.db')}`];
  mkdirSync(at('out'));
  mkdirSync(at('out/folder'));
  symlinkSync('/dev/full', at('out/full'));  // a link, so that no failure of this test costs a device
  for (const target of [at('out/no/such/report.html'), at('out/folder'), at('out/full')]) {
    const {code, err} = run(...compare, '-o', target);
    assert.equal(code, 1, target);
    assert.match(err, /could not write/, target);
  }
  assert.ok(lstatSync(at('out/folder')).isDirectory());
  assert.ok(lstatSync(at('out/full')).isSymbolicLink());
  assert.deepEqual(readdirSync(at('out')).sort(), ['folder', 'full']);
  const database = run(...compare.slice(0, -1), 'sqlite:/proc/cathedra.db');
  assert.equal(database.code, 1);
});
