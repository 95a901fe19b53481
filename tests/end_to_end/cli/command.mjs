// Runs the program's commands as a person at a shell does.
import {spawnSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {after} from 'node:test';
import {program, repository} from '../support/places.mjs';

/** A folder that goes away when the tests of the file are over. */
export function temporaryFolder() {
  const folder = mkdtempSync(path.join(tmpdir(), 'cathedra-cli-'));
  after(() => rmSync(folder, {recursive: true, force: true}));
  return folder;
}

export function run(...args) {
  const {status, stdout, stderr} = spawnSync(program, args, {encoding: 'utf8', cwd: repository});
  return {code: status, out: stdout, err: stderr, get json() { return JSON.parse(stdout); }};
}

/** SQL by Debian's own tool, behind the program's back. */
export function sql(file, statement) {
  const {status, stdout, stderr} = spawnSync('sqlite3', [file, statement], {encoding: 'utf8'});
  if (status !== 0) throw new Error(`sqlite3: ${stderr}`);
  return stdout.trim();
}
