// The paper's numbers, a simulated trial and its proof, from the shell.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {run, sql, temporaryFolder} from './command.mjs';

const folder = temporaryFolder();
const file = path.join(folder, 't.db');
const database = ['--database', `sqlite:${file}`];

test('the published comparison comes out as in the paper, in every format', () => {
  const compare = ['report', 'compare', '--exercise', 'linear', '--dataset', 'paper', ...database];
  const {json} = run(...compare, '--json');
  // from shared/oracles: participants' means, exact rank test, Hedges g with its noncentral interval
  assert.equal(json.expert.mean_s.toFixed(2), '237.33');
  assert.equal(json.novice.mean_s.toFixed(1), '390.8');
  assert.equal(json.mann_whitney_u, 0);
  assert.ok(Math.abs(json.p - 0.1) < 1e-12);
  assert.equal(json.hedges_g.toFixed(2), '-6.22');
  assert.equal(json.hedges_g_low.toFixed(2), '-10.55');
  assert.equal(json.hedges_g_high.toFixed(2), '-1.93');
  for (const format of ['html', 'csv']) {
    const out = path.join(folder, `linear.${format}`);
    assert.equal(run(...compare, '--format', format, '-o', out).code, 0);
    const text = readFileSync(out, 'utf8').replaceAll('\u2212', '-');
    for (const number of ['237.33', '390.8', '6.2', '10.5', '1.9']) {
      assert.ok(text.includes(number), `${format} lacks ${number}`);
    }
  }
  assert.equal(sql(file, "SELECT count(*) FROM trial WHERE dataset = 'paper'"), '120');
});

const perform = (...more) => run('exercise', 'run', 'linear', ...more, ...database, '--json').json;

test('an expert is quicker, smoother and gentler than a novice; each is repeatable', () => {
  const expert = perform('--operator', 'expert', '--seed', '7');
  const novice = perform('--operator', 'novice', '--seed', '7');
  assert.equal(expert.source, 'simulated-operator');
  assert.ok(expert.metrics.force_p95_n > 0.05);
  assert.ok(novice.time_s > expert.time_s);
  assert.ok(novice.metrics.sparc_stroke < expert.metrics.sparc_stroke);
  assert.ok(novice.metrics.contact_impulse_n_s > expert.metrics.contact_impulse_n_s);
  assert.equal(perform('--operator', 'expert', '--seed', '7').state_hash, expert.state_hash);
  assert.notEqual(perform('--operator', 'expert', '--seed', '8').state_hash, expert.state_hash);
});

test('a stored trial is confirmed until one byte of its inputs is changed', () => {
  const id = perform('--operator', 'expert', '--seed', '9').trial_id;
  assert.equal(run('trial', 'verify', id, ...database).code, 0);
  // the last byte of the fourth second's inputs, another bit set
  const hex = sql(file, `SELECT hex(bytes) FROM trace_chunk WHERE trial_id='${id}' AND kind='inputs' AND seq=3`);
  const last = (Number.parseInt(hex.slice(-2), 16) ^ 1).toString(16).padStart(2, '0');
  sql(file, `UPDATE trace_chunk SET bytes = x'${hex.slice(0, -2)}${last}' WHERE trial_id='${id}' AND kind='inputs' AND seq=3`);
  const changed = run('trial', 'verify', id, ...database, '--json');
  assert.equal(changed.code, 1);
  assert.equal(changed.json.confirmed, false);
  assert.equal(changed.json.chunk, 'inputs 3');
  assert.equal(changed.json.first_second_that_differs, 3);
  assert.match(run('trial', 'verify', id, ...database).out, /inputs 3.*first second that differs is 3/s);
  assert.equal(run('trial', 'verify', 'unknown', ...database).code, 1);
});

// One part of the judged record each, forged behind the program's back.
const forgeries = {
  'the metric time_s': (id) => `UPDATE metric_value SET value = 1.0 WHERE trial_id='${id}' AND metric='time_s'`,
  'the reason of the end': (id) => `UPDATE trial SET end_reason='timeout' WHERE id='${id}'`,
  'the final state': (id) => `UPDATE trial SET state_hash='' WHERE id='${id}'`,
  'the steps': (id) => `UPDATE trial_step SET ended_s = ended_s + 1 WHERE trial_id='${id}'`,
  'the events': (id) => `DELETE FROM event WHERE trial_id='${id}'`,
  'the verdict': () => 'UPDATE criterion SET met = 1 - met',
};

for (const [part, forge] of Object.entries(forgeries)) {
  test(`a forged record is not confirmed: ${part}`, () => {
    const id = perform('--operator', 'expert', '--seed', '11').trial_id;
    sql(file, forge(id));
    const answer = run('trial', 'verify', id, ...database, '--json');
    assert.equal(answer.code, 1);
    assert.equal(answer.json.differs, part);
  });
}
