// See store.sh.
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {killOnce, randomNumbers, Site} from './killing.mjs';

const [program, kills, seed] = process.argv.slice(2);
const folder = mkdtempSync(path.join(tmpdir(), 'cathedra-store-'));
const site = new Site(program, folder);
const random = randomNumbers(Number(seed));
console.log(`seed ${seed}`);
let failures = 0;
for (let k = 0; k < Number(kills); ++k) {
  const kind = k % 2 === 0 ? 'exercise run' : 'demo';
  const delay = 100 + Math.floor(7000 * random());
  const {complaints, finished, running} = await killOnce(site, kind, 1000 + k, delay);
  failures += complaints.length;
  const left = running.map(([, seconds]) => `${seconds} s recovered`).join(', ') || 'none running';
  console.log(`kill ${k + 1}, ${kind} after ${delay} ms: ${finished} finished, ${left}: ${complaints.join('; ') || 'good'}`);
}
// the finished ones too are what they claim to be; the last few stand for all
for (const row of site.finished().filter((line) => line.includes('|completed|')).slice(-5)) {
  const proof = site.verify(row.split('|')[0]);
  if (proof.confirmed) continue;
  ++failures;
  console.log(proof.says);
}
rmSync(folder, {recursive: true, force: true});
console.log(failures === 0 ? 'Nothing was lost.' : `${failures} failures.`);
process.exit(failures === 0 ? 0 : 1);
