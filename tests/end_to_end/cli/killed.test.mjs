// The program is killed while it writes trials; tests/soak/store.sh does it a hundred times.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {killOnce, randomNumbers, Site} from '../../soak/killing.mjs';
import {program} from '../support/places.mjs';
import {temporaryFolder} from './command.mjs';

const seed = 20;

test('a killed program loses nothing that was finished and keeps the trace of what ran', async () => {
  const site = new Site(program, temporaryFolder());
  const random = randomNumbers(seed);
  let recovered = 0;
  for (const kind of ['exercise run', 'demo', 'exercise run']) {
    const {complaints, running} = await killOnce(site, kind, seed, 2500 + Math.floor(3000 * random()));
    assert.deepEqual(complaints, []);
    recovered += running.length;
  }
  assert.ok(recovered > 0, 'no kill hit a running trial');
});
