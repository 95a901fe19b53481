// A trainee performs the linear task by keyboard and reads the verdict; the instructor finds it.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {launch, small, Visitor} from './support/browser.mjs';
import {goOn, steerUntil} from './support/hand.mjs';
import {newDataFolder, Program, removeDataFolder} from './support/program.mjs';

let browser;
let program;
let folder;
let trialId;

before(async () => {
  folder = newDataFolder();
  program = await Program.start('demo', folder, {more: ['--example-trials', '0']});
  browser = await launch();
});

after(async () => {
  await browser?.close();
  await program?.stop();
  removeDataFolder(folder);
});

test('a trainee performs the linear task by keyboard and sees the verdict', {timeout: 600_000}, async () => {
  const trainee = await Visitor.enter(browser, program.url);
  const {page} = trainee;
  await trainee.signIn('trainee');
  await page.getByRole('heading', {name: 'My training'}).waitFor();
  await page.getByRole('link', {name: /^Linear/}).first().click();
  await page.setViewportSize(small);
  await page.getByRole('button', {name: 'Start'}).click();
  await page.waitForURL(/\/console\//);
  trialId = decodeURIComponent(new URL(page.url()).pathname.split('/').pop());

  const dialog = page.getByRole('dialog');
  await dialog.waitFor({timeout: 60_000});
  await page.getByRole('button', {name: 'Start'}).waitFor({timeout: 60_000});
  await goOn(page);

  const {verdict} = await steerUntil(page, (task) => task.verdict !== '', 420_000);
  assert.match(verdict, /^(Passed|Not passed)$/);
  assert.ok(page.url().endsWith(`/trials/${encodeURIComponent(trialId)}`));
  const criteria = page.getByRole('region', {name: 'Criteria'});
  assert.match(await criteria.innerText(), /Met|Not met/);
  assert.match(await criteria.innerText(), /\d\s*s/u);
  await page.getByText('Completed').first().waitFor();

  await page.getByRole('link', {name: 'My progress'}).click();
  await page.getByRole('heading', {name: 'My progress'}).waitFor();
  await page.getByRole('link', {name: 'Debrief of trial 1'}).waitFor();
  await trainee.assertClean();
  await trainee.leave();
});

test('the instructor sees that trial on the curve', {timeout: 120_000}, async () => {
  const instructor = await Visitor.enter(browser, program.url);
  const {page} = instructor;
  await instructor.signIn('instructor');
  await page.getByRole('heading', {name: 'People'}).waitFor();
  await page.getByRole('link', {name: 'Demo trainee'}).click();
  await page.getByRole('heading', {name: 'Demo trainee'}).waitFor();

  const linear = page.getByRole('region', {name: /^Linear/}).first();
  const curve = linear.getByRole('figure').first();
  await curve.getByRole('img').waitFor();
  await curve.getByRole('button', {name: /^Table/}).click();
  assert.equal(await curve.locator('tbody tr').count(), 1);
  await linear.getByRole('link', {name: 'Debrief of trial 1'}).click();
  await page.getByRole('region', {name: 'Verdict'}).waitFor();
  assert.ok(page.url().endsWith(`/trials/${encodeURIComponent(trialId)}`));
  await instructor.assertClean();
  await instructor.leave();
});
