// An instructor's word on a trial: comments on it, takes one back, voids it with a reason; the trainee
// who made the trial reads what was written and may write nothing.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {inspect, launch, small, Visitor} from './support/browser.mjs';
import {goOn, steerUntil} from './support/hand.mjs';
import {newDataFolder, Program, removeDataFolder} from './support/program.mjs';

const onWhole = 'Calm hands; keep the pace of the first feed.';
const onMoment = 'Here you pushed\nagainst the wall.';
const mistaken = 'This was meant for somebody else.';
const reason = 'The fire alarm went off in the middle of it.';

let browser;
let program;
let folder;
let trialPath;
let trainee;
let instructor;

before(async () => {
  folder = newDataFolder();
  program = await Program.start('demo', folder, {more: ['--example-trials', '0']});
  browser = await launch();
  trainee = await Visitor.enter(browser, program.url);
  instructor = await Visitor.enter(browser, program.url);
}, {timeout: 300_000});

after(async () => {
  await browser?.close();
  await program?.stop();
  removeDataFolder(folder);
});

const comments = (page) => page.getByRole('region', {name: 'Comments'});
const banner = (page) => page.getByRole('region', {name: 'Voided'});

async function write(page, text, at = '') {
  const before = await comments(page).getByRole('listitem').count();
  await comments(page).getByLabel('Comment', {exact: true}).fill(text);
  await comments(page).getByLabel('At, minutes:seconds').fill(at);
  await comments(page).getByRole('button', {name: 'Write comment'}).click();
  await comments(page).getByRole('listitem').nth(before).waitFor();
}

test('a trainee finishes a trial that nobody has judged yet', {timeout: 600_000}, async () => {
  const {page} = trainee;
  await trainee.signIn('trainee');
  await page.goto(`${program.url}/exercises/linear`);
  await page.setViewportSize(small);
  await page.getByRole('button', {name: 'Start'}).click();
  await page.locator('[data-testid="overlay"][data-kind="start"]').waitFor({timeout: 60_000});
  await goOn(page);
  await steerUntil(page, (task) => task.verdict !== '', 420_000);
  trialPath = new URL(page.url()).pathname;
  assert.match(trialPath, /^\/trials\/./);
  assert.equal(await comments(page).count(), 0);
  assert.equal(await banner(page).count(), 0);
});

test('the instructor comments on the whole and on a moment, and takes one back', {timeout: 180_000}, async () => {
  const {page} = instructor;
  await instructor.signIn('instructor');
  await page.goto(program.url + trialPath);
  await comments(page).getByText('No comment yet').waitFor();

  // nothing, a time that is none, and one long after the end: refused beside the field, nothing is sent
  await comments(page).getByRole('button', {name: 'Write comment'}).click();
  await comments(page).getByText('Write something before you send it.').waitFor();
  await comments(page).getByLabel('Comment', {exact: true}).fill('x');
  await comments(page).getByLabel('At, minutes:seconds').fill('1:75');
  await comments(page).getByText(/Write the time as minutes and seconds/).waitFor();
  await comments(page).getByLabel('At, minutes:seconds').fill('600:00');
  await comments(page).getByText(/The trial was over by then/).waitFor();
  assert.equal(await comments(page).getByRole('listitem').count(), 0);

  await write(page, onMoment, '0:03');
  await write(page, mistaken);
  await write(page, onWhole);
  await comments(page).getByRole('button', {name: `Take back: ${mistaken}`}).click();
  await comments(page).getByText(mistaken).waitFor({state: 'detached'});
  // the whole trial first, then by time
  const [whole, moment] = await comments(page).getByRole('listitem').allInnerTexts();
  assert.match(whole, /The whole trial[^]*Calm hands/);
  assert.match(moment, /At 0:03[^]*against the wall/);
  await inspect(page, 'debrief-comments-instructor');
});

test('the instructor voids the trial with a reason', {timeout: 180_000}, async () => {
  const {page} = instructor;
  await page.getByRole('button', {name: 'Void this trial…'}).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('Reason').fill('too short');
  await dialog.getByRole('button', {name: 'Void the trial'}).click();
  await dialog.getByText(/at least 10 characters/).waitFor();
  await inspect(page, 'debrief-void-dialog');
  await dialog.getByLabel('Reason').fill(reason);
  await dialog.getByRole('button', {name: 'Void the trial'}).click();
  await banner(page).getByText(reason).waitFor();
  await page.getByRole('region', {name: 'Verdict'}).getByRole('heading', {name: 'Voided'}).waitFor();
  assert.equal(await page.getByRole('button', {name: 'Void this trial…'}).count(), 0);
  await inspect(page, 'debrief-voided-instructor');
  await instructor.assertClean();
});

test('the trainee reads the comments and the reason, and may change neither', {timeout: 120_000}, async () => {
  const {page} = trainee;
  await page.goto(program.url + trialPath);
  await banner(page).getByText(reason).waitFor();
  assert.match(await banner(page).innerText(), /Voided by Demo instructor, Today/);
  assert.match(await comments(page).innerText(), /Calm hands[^]*Here you pushed\s*against the wall/);
  assert.ok(!(await comments(page).innerText()).includes(mistaken));
  assert.equal(await comments(page).getByRole('button').count(), 0);
  assert.equal(await comments(page).getByRole('textbox').count(), 0);
  assert.equal(await page.getByRole('button', {name: /^Void/}).count(), 0);
  await inspect(page, 'debrief-voided-trainee');

  await page.goto(`${program.url}/progress`);
  await page.getByRole('row').filter({has: page.getByRole('link', {name: 'Debrief of trial 1'})}).getByText('Voided').waitFor();
  await trainee.assertClean();
});
