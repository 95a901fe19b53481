// Kills the program while it writes trials, and looks at what is left.
import {spawn, spawnSync} from 'node:child_process';
import {mkdirSync, writeFileSync} from 'node:fs';
import path from 'node:path';

/** Numbers from 0 to below 1 that a seed fixes: a counter through the last mixing step of MurmurHash3. */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let z = state;
    z = Math.imul(z ^ (z >>> 16), 0x85ebca6b);
    z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
    return ((z ^ (z >>> 16)) >>> 0) / 2 ** 32;
  };
}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** A site in a folder of its own that is killed again and again. */
export class Site {
  constructor(program, folder) {
    this.program = program;
    this.folder = folder;
    this.file = path.join(folder, 'cathedra.db');
    this.web = path.join(folder, 'web');
    mkdirSync(this.web, {recursive: true});
    writeFileSync(path.join(this.web, 'index.html'), '<!doctype html>');
  }

  sql(statement) {
    const {status, stdout, stderr} = spawnSync('sqlite3', ['-cmd', '.timeout 5000', this.file, statement], {encoding: 'utf8'});
    if (status !== 0) throw new Error(`sqlite3: ${stderr}`);
    return stdout.trim();
  }

  start(args) {
    const child = spawn(this.program, args, {stdio: ['ignore', 'pipe', 'pipe']});
    child.said = '';
    child.stdout.on('data', (text) => { child.said += text; });
    child.stderr.on('data', (text) => { child.said += text; });
    child.over = new Promise((resolve) => child.once('exit', (code, signal) => resolve(signal ?? code)));
    return child;
  }

  /** Starts a program that makes trials and kills it `delay_ms` after it was started. */
  async kill(kind, seed, delay_ms) {
    const child = this.start(kind === 'demo'
      ? ['demo', '--data', this.folder, '--port', '0', '--web-root', this.web, '--example-trials', '100']
      : ['exercise', 'run', 'linear', '--operator', 'expert', '--seed', String(seed), '--trials', '100',
        '--database', `sqlite:${this.file}`]);
    await pause(delay_ms);
    child.kill('SIGKILL');
    const end = await child.over;
    if (end !== 'SIGKILL') throw new Error(`${kind} ended by itself with ${end}: ${child.said}`);
  }

  /** Starts the server as after a power cut and stops it properly. */
  async startAgain() {
    const server = this.start(['serve', '--data', this.folder, '--port', '0', '--web-root', this.web]);
    const until = Date.now() + 120_000;
    while (!server.said.includes('Stop with Ctrl-C')) {
      if (server.exitCode !== null || Date.now() > until) throw new Error(`the server did not start: ${server.said}`);
      await pause(20);
    }
    server.kill('SIGINT');
    const end = await server.over;
    if (end !== 0) throw new Error(`the server ended with ${end}: ${server.said}`);
  }

  /** Every finished trial in one line each, with the size and content of its trace. */
  finished() {
    const rows = this.sql(`SELECT t.id || '|' || end_reason || '|' || state_hash || '|' || input_sha256 || '|' ||
      (SELECT count(*) || ' ' || total(length(bytes)) FROM trace_chunk c WHERE c.trial_id = t.id) || '|' ||
      (SELECT count(*) || ' ' || total(value) FROM metric_value m WHERE m.trial_id = t.id)
      FROM trial t WHERE ended_utc IS NOT NULL AND source = 'simulated-operator' ORDER BY t.id`);
    return rows === '' ? [] : rows.split('\n');
  }

  /** Seconds of trace of each running trial. */
  running() {
    const rows = this.sql(`SELECT t.id || '|' || (SELECT count(*) FROM trace_chunk c WHERE c.trial_id = t.id AND kind = 'hashes')
      FROM trial t WHERE ended_utc IS NULL`);
    return rows === '' ? [] : rows.split('\n').map((row) => row.split('|'));
  }

  verify(id) {
    const {status, stdout, stderr} = spawnSync(this.program, ['trial', 'verify', id, '--database', `sqlite:${this.file}`], {encoding: 'utf8'});
    return {confirmed: status === 0, says: stdout + stderr};
  }
}

/** One kill and everything that must hold after it; the complaints, empty when there are none. */
export async function killOnce(site, kind, seed, delay_ms) {
  await site.kill(kind, seed, delay_ms);
  const complaints = [];
  const hasSchema = site.sql("SELECT count(*) FROM sqlite_master WHERE name = 'trial'") === '1';
  const before = hasSchema ? site.finished() : [];
  const running = hasSchema ? site.running() : [];
  await site.startAgain();
  const after = new Set(site.finished());
  for (const row of before) if (!after.has(row)) complaints.push(`a finished trial was changed: ${row}`);
  if (site.running().length > 0) complaints.push('a trial is still running');
  if (site.sql('PRAGMA integrity_check') !== 'ok') complaints.push('the file is not whole');
  if (site.sql('PRAGMA foreign_key_check') !== '') complaints.push('a reference leads nowhere');
  for (const [id, seconds] of running) {
    const row = site.sql(`SELECT end_reason || ' ' || interrupted FROM trial WHERE id = '${id}'`);
    if (row !== 'aborted 1') complaints.push(`${id} is ${row} instead of aborted`);
    const kept = site.sql(`SELECT count(*) FROM trace_chunk WHERE trial_id = '${id}' AND kind = 'hashes'`);
    if (kept !== seconds) complaints.push(`${id} had ${seconds} s of trace and has ${kept}`);
    if (Number(kept) === 0) continue;  // killed within its first second: nothing to replay
    const proof = site.verify(id);
    if (!proof.confirmed) complaints.push(`${id}: ${proof.says}`);
  }
  return {complaints, finished: before.length, running};
}
