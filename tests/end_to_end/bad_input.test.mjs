// What goes wrong in real life: a wrong password, a second tab, a pulled cable, a killed server.
import assert from 'node:assert/strict';
import {after, afterEach, before, test} from 'node:test';
import {launch, small, Visitor} from './support/browser.mjs';
import {goOn, readTask, steerUntil} from './support/hand.mjs';
import {LooseCable} from './support/loose_cable.mjs';
import {newDataFolder, Program, removeDataFolder} from './support/program.mjs';

let browser;
let program;
let folder;
let visitor;
const outage_ms = 6000;
const demo = {more: ['--example-trials', '0']};

before(async () => {
  folder = newDataFolder();
  program = await Program.start('demo', folder, demo);
  browser = await launch();
});

afterEach(async () => {
  await visitor?.leave();
  visitor = undefined;
});

after(async () => {
  await browser?.close();
  await program?.stop();
  removeDataFolder(folder);
});

async function openConsole(page) {
  // a small picture: drawing it by software must not hold up the hand
  await page.setViewportSize(small);
  await page.getByRole('button', {name: 'Start'}).click();
  await page.waitForURL(/\/console\//);
  await overlay(page, 'start');
}

async function overlay(page, kind) {
  await page.locator(`[data-testid="overlay"][data-kind="${kind}"]`).waitFor({timeout: 60_000});
}

async function endTrial(page) {
  await page.keyboard.press('Escape');
  await overlay(page, 'confirm_end');
  await page.getByRole('dialog').getByRole('button', {name: 'End trial'}).click();
  await page.waitForURL(/\/trials\//, {timeout: 60_000});
  await page.getByRole('region', {name: 'Verdict'}).waitFor();
}

test('a wrong password is refused in one sentence that does not say which part was wrong', async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await page.goto(program.url);
  await page.getByLabel('Name').fill('trainee');
  await page.getByLabel('Password').first().fill('not-the-password');
  await page.getByRole('button', {name: 'Sign in', exact: true}).click();
  const refusal = page.getByRole('alert');
  await refusal.filter({hasText: 'The name or the password is wrong.'}).waitFor();
  await page.getByLabel('Name').fill('nobody-of-this-name');
  await page.getByLabel('Password').first().fill('not-the-password');
  await page.getByRole('button', {name: 'Sign in', exact: true}).click();
  await refusal.filter({hasText: 'The name or the password is wrong.'}).waitFor();
  await visitor.assertClean();
});

test('an unknown exercise, trial and page say so and offer a way on', async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await visitor.signIn('trainee');
  visitor.expect(404, '/api/exercises/no-such-exercise');
  await page.goto(`${program.url}/exercises/no-such-exercise`);
  await page.getByRole('alert').filter({hasText: 'not in your curriculum'}).waitFor();
  visitor.expect(404, '/api/trials/no-such-trial');
  visitor.expect(400, '/api/trials/no-such-trial');
  await page.goto(`${program.url}/trials/no-such-trial`);
  await page.getByRole('alert').waitFor();
  await page.goto(`${program.url}/no-such-page`);
  await page.getByText('No such page').waitFor();
  await page.goto(`${program.url}/console/no-such-trial`);
  await page.getByText('This trial is not running').waitFor();
  visitor.expect(403, '/api/people');
  await page.goto(`${program.url}/people`);
  await page.getByRole('alert').waitFor();
  await visitor.assertClean();
});

test('a second tab looks on but cannot steer', {timeout: 240_000}, async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await visitor.signIn('trainee');
  await openConsole(page);
  const second = await visitor.newTab();
  await second.goto(page.url());
  await overlay(second, 'second_tab');
  await page.bringToFront();
  await goOn(page);
  await steerUntil(page, (task) => task.value > 5, 60_000);
  await second.close();
  await endTrial(page);
  assert.match(await page.getByRole('region', {name: 'Verdict'}).innerText(), /Not counted/);
  await visitor.assertClean();
});

test('a lost connection pauses the trial and coming back resumes it', {timeout: 240_000}, async () => {
  const cable = await LooseCable.plug(program.port);
  try {
    visitor = await Visitor.enter(browser, cable.url);
    const {page} = visitor;
    await visitor.signIn('trainee');
    await openConsole(page);
    await goOn(page);
    await steerUntil(page, (task) => task.value > 10, 60_000);

    visitor.expect(0, '*');
    await page.keyboard.down('ArrowUp');
    cable.pullOut();
    await overlay(page, 'lost');
    const held = (await readTask(page)).value;
    const lost_ms = Date.now();
    await page.waitForTimeout(outage_ms);
    cable.putBack();
    await overlay(page, 'restored');
    await page.keyboard.up('ArrowUp');
    // a busy machine shows the picture late, so the last value seen may be old; but a hand that
    // went on feeding would have gone the whole way, at 30 mm/s
    const moved = (await readTask(page)).value - held;
    const unpaused = 30 * (Date.now() - lost_ms) / 1000;
    assert.ok(moved < unpaused / 2, `the wire moved ${moved} mm while nobody was connected`);

    await goOn(page);
    await steerUntil(page, (task) => task.value > held + 5, 60_000);
    await endTrial(page);
    assert.match(await page.locator('footer').innerText(), /paused for/);
    await visitor.assertClean();
  } finally {
    await cable.close();
  }
});

test('after a killed server the trial is marked aborted, and its record is there', {timeout: 240_000}, async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await visitor.signIn('trainee');
  await openConsole(page);
  await goOn(page);
  await steerUntil(page, (task) => task.value > 40, 60_000);
  // the record is written each second
  await page.waitForTimeout(1500);

  visitor.expect(0, '*');
  await program.kill();
  await overlay(page, 'lost');
  program = await Program.start('demo', folder, {...demo, port: program.port});
  await overlay(page, 'gone');
  await page.getByRole('button', {name: 'See the debrief'}).click();
  const verdict = page.getByRole('region', {name: 'Verdict'});
  await verdict.waitFor();
  assert.match(await verdict.innerText(), /Not counted/);
  await page.getByText('Ended early').first().waitFor();
  await visitor.assertClean();
});

test('a new site is set up once, by the link that the server prints', {timeout: 120_000}, async () => {
  const data = newDataFolder();
  const site = await Program.start('serve', data);
  try {
    const [link] = await site.says(/http:\/\/\S+\/setup\S+/);
    visitor = await Visitor.enter(browser, site.url);
    const {page} = visitor;
    await page.goto(site.url);
    await page.getByText('Open the set-up link').waitFor();
    await page.goto(link);
    const fill = async (password, again) => {
      await page.getByLabel('Name').fill('first-admin');
      await page.getByLabel('Password', {exact: true}).fill(password);
      await page.getByLabel('Password again', {exact: true}).fill(again);
      await page.getByRole('button', {name: 'Create the administrator'}).click();
    };
    await fill('correct horse battery', 'correct horse batter');
    await page.getByRole('alert').filter({hasText: 'differ'}).waitFor();
    await fill('correct horse battery', 'correct horse battery');
    await page.getByRole('heading', {name: 'People'}).waitFor();
    await visitor.signOut();
    await page.goto(link);
    await page.getByText('This site is set up already.').waitFor();
    await visitor.assertClean();
  } finally {
    await site.stop();
    removeDataFolder(data);
  }
});
