// Every view is opened as the role it is for, photographed at two sizes and checked with axe.
import {after, afterEach, before, test} from 'node:test';
import {inspect, launch, small, Visitor} from './support/browser.mjs';
import {goOn, steerUntil} from './support/hand.mjs';
import {newDataFolder, Program, removeDataFolder} from './support/program.mjs';

let browser;
let program;
let folder;
let visitor;

before(async () => {
  folder = newDataFolder();
  // a few trials of the example group, so that curves and comparisons have something to show
  await Program.load(folder, 1);
  program = await Program.start('demo', folder, {more: ['--example-trials', '0']});
  browser = await launch();
}, {timeout: 600_000});

afterEach(async () => {
  await visitor?.leave();
  visitor = undefined;
});

after(async () => {
  await browser?.close();
  await program?.stop();
  removeDataFolder(folder);
});

async function show(page, path, heading, name) {
  await page.goto(program.url + path);
  await page.getByRole('heading', {name: heading, level: 1}).waitFor();
  await inspect(page, name);
}

test('sign-in', async () => {
  visitor = await Visitor.enter(browser, program.url);
  await show(visitor.page, '/', 'Sign in', 'sign-in');
  await visitor.assertClean();
});

test('the pages of a trainee', {timeout: 300_000}, async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await visitor.signIn('trainee');
  await show(page, '/training', 'My training', 'training-first');
  await show(page, '/exercises/linear', /^Linear/, 'briefing-linear');
  await show(page, '/exercises/rotational', /^Rotational/, 'briefing-rotational');
  await show(page, '/progress', 'My progress', 'progress-first');
  await show(page, '/controls', 'Controls', 'controls');
  await show(page, '/help', 'Help', 'help-trainee');

  await page.goto(`${program.url}/exercises/linear`);
  await page.getByRole('button', {name: 'Start'}).click();
  await page.locator('[data-testid="overlay"][data-kind="start"]').waitFor({timeout: 60_000});
  await inspect(page, 'console-start');
  await page.setViewportSize(small);
  await goOn(page);
  await steerUntil(page, (task) => task.value > 180, 120_000);
  await inspect(page, 'console');
  await page.keyboard.press('Escape');
  await page.getByRole('dialog').getByRole('button', {name: 'End trial'}).click();
  await page.waitForURL(/\/trials\//, {timeout: 60_000});
  await page.getByRole('region', {name: 'Verdict'}).waitFor();
  await inspect(page, 'debrief-ended-early');
  await show(page, '/training', 'My training', 'training');
  await show(page, '/progress', 'My progress', 'progress');
  await visitor.assertClean();
});

test('the pages of an instructor', {timeout: 300_000}, async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await visitor.signIn('instructor');
  await show(page, '/people', 'People', 'people');
  await page.getByText(/^Simulated operators/).click();
  await page.getByRole('button', {name: /^Curves/}).first().click();
  await page.getByRole('figure').first().waitFor();
  await inspect(page, 'people-curves');
  await page.getByRole('link', {name: /Sim expert A/}).click();
  await page.getByRole('heading', {name: /Sim expert A/, level: 1}).waitFor();
  await inspect(page, 'person');
  await page.getByRole('link', {name: /^Debrief/}).first().click();
  await page.getByRole('region', {name: 'Verdict'}).waitFor();
  await inspect(page, 'debrief');
  await show(page, '/compare', 'Novices against experts', 'compare');
  for (const dataset of ['paper', 'simulated']) {
    await page.goto(`${program.url}/compare?exercise=linear&dataset=${dataset}`);
    await page.getByRole('figure').first().waitFor();
    await inspect(page, `compare-linear-${dataset}`);
  }
  await show(page, '/help', 'Help', 'help-instructor');
  await visitor.assertClean();
});

test('the pages of an administrator', async () => {
  visitor = await Visitor.enter(browser, program.url);
  const {page} = visitor;
  await visitor.signIn('administrator');
  await show(page, '/people', 'People', 'people-administrator');
  await page.getByText(/^Published data/).click();
  await page.getByRole('link', {name: /No\. ?1/}).first().waitFor();
  await inspect(page, 'people-published');
  await show(page, '/people?find=nobody-is-called-so', 'People', 'people-nobody');
  await page.getByRole('button', {name: 'Show everybody'}).click();
  await page.getByRole('link', {name: 'Demo trainee'}).click();
  await page.getByRole('heading', {name: 'Account'}).waitFor();
  await inspect(page, 'person-administrator');
  await show(page, '/people/import', 'Import people', 'import-people');
  await show(page, '/compare', 'Novices against experts', 'compare-administrator');
  await visitor.assertClean();
});
