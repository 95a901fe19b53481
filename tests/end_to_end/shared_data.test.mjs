// The reference data beside a checkout, where there is any: the copies kept with the code must be
// the same. Skipped, by name, on a bare clone.
import assert from 'node:assert/strict';
import {existsSync, readFileSync} from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {repository} from './support/places.mjs';

const shared = path.resolve(repository, '..', 'shared');
const skip = existsSync(shared) ? false : 'no reference data beside this checkout';
const copies = [
  ['oracles/motion.json', 'tests/fixtures/oracles/motion.json'],
  ['oracles/statistics_linear.json', 'tests/fixtures/oracles/statistics_linear.json'],
  ['paper/trials.csv', 'tests/fixtures/paper/trials.csv'],
  ['paper/trials.csv', 'app/demo/published_trials.csv'],
];

for (const [original, copy] of copies) {
  test(`${copy} is the reference data's ${original}`, {skip}, () => {
    assert.ok(readFileSync(path.join(repository, copy)).equals(readFileSync(path.join(shared, original))));
  });
}
