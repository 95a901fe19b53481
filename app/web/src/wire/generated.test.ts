import {execFileSync} from 'node:child_process';
import {expect, it} from 'vitest';

it('the generated wire files are what wire.schema.yaml says', () => {
  const said = () => execFileSync(process.execPath, ['../wire/generate.mjs', '--check'], {encoding: 'utf8', stdio: 'pipe'});
  expect(said).not.toThrow();
}, 30_000);
