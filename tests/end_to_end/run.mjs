// Runs the end-to-end tests one file after the other: node tests/end_to_end/run.mjs [FILE...]
// CATHEDRA_BIN: the program (build/release/cathedra). Pictures go to build/screenshots.
import {spawnSync} from 'node:child_process';
import {existsSync, readdirSync} from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {chromiumPath, program, requireFromWeb, webRoot} from './support/places.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));

function missing() {
  try {
    requireFromWeb.resolve('playwright-core');
  } catch {
    return 'the packages of app/web; run "npm ci" there';
  }
  if (!existsSync(program)) return `the program ${program}; build it, or name it in CATHEDRA_BIN`;
  if (!existsSync(path.join(webRoot, 'index.html'))) return `${webRoot}; run "npm run build" in app/web`;
  if (!existsSync(chromiumPath)) return `${chromiumPath}; install Debian's chromium`;
  return null;
}

const lack = missing();
if (lack !== null) {
  console.error(`The end-to-end tests need ${lack}.`);
  process.exit(2);
}
const named = process.argv.slice(2).map((file) => path.resolve(file));
const files = named.length > 0
  ? named
  : [here, path.join(here, 'cli')].flatMap((folder) =>
      readdirSync(folder).filter((name) => name.endsWith('.test.mjs')).sort().map((name) => path.join(folder, name)));
const {status} = spawnSync(process.execPath, ['--test', '--test-concurrency=1', ...files], {stdio: 'inherit'});
process.exit(status ?? 1);
