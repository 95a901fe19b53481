// See operators.sh.
import {spawnSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';

const [program, seeds] = process.argv.slice(2);
const folder = mkdtempSync(path.join(tmpdir(), 'cathedra-operators-'));

function perform(exercise, operator, seed) {
  const {status, stdout, stderr} = spawnSync(program, ['exercise', 'run', exercise, '--operator', operator,
    '--seed', String(seed), '--database', `sqlite:${path.join(folder, 't.db')}`, '--json'], {encoding: 'utf8'});
  if (status !== 0) throw new Error(`${exercise}, ${operator}, seed ${seed} ended with ${status}: ${stderr}${stdout}`);
  return JSON.parse(stdout);
}

// "rougher": SPARC of the strokes where the handle is fed, superfluous reversals where it is turned
const rougher = {
  linear: (novice, expert) => novice.sparc_stroke < expert.sparc_stroke,
  rotational: (novice, expert) => novice.reversals > expert.reversals,
};

let failures = 0;
const hashes = new Set();
for (const exercise of Object.keys(rougher)) {
  for (let seed = 1; seed <= Number(seeds); ++seed) {
    const expert = perform(exercise, 'expert', seed);
    const novice = perform(exercise, 'novice', seed);
    hashes.add(expert.state_hash);
    const [e, n] = [expert.metrics, novice.metrics];
    const lacks = [];
    if (!(e.force_p95_n > 0.05)) lacks.push('no contact to measure');
    if (!(novice.time_s > expert.time_s)) lacks.push('not slower');
    if (!rougher[exercise](n, e)) lacks.push('not rougher');
    if (!(n.contact_impulse_n_s > e.contact_impulse_n_s)) lacks.push('no larger impulse');
    failures += lacks.length;
    const side = (r) => `${r.time_s.toFixed(1)} s, p95 ${r.metrics.force_p95_n.toFixed(3)} N, impulse ` +
      `${r.metrics.contact_impulse_n_s.toFixed(2)} N s, ${exercise === 'linear'
        ? `SPARC ${r.metrics.sparc_stroke.toFixed(2)}` : `${r.metrics.reversals} reversals`}`;
    console.log(`${exercise} seed ${seed}: expert ${side(expert)} | novice ${side(novice)} | ${lacks.join(', ') || 'good'}`);
  }
}
if (hashes.size !== 2 * Number(seeds)) {
  console.log('two seeds gave the same state');
  ++failures;
}
rmSync(folder, {recursive: true, force: true});
console.log(failures === 0 ? 'All seeds as they should be.' : `${failures} failures.`);
process.exit(failures === 0 ? 0 : 1);
