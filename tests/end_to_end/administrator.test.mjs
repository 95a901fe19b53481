// An administrator's evening: invites a person, who comes in through the link; imports thirty from a
// table with three broken rows; disables one.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {after, before, test} from 'node:test';
import {inspect, launch, Visitor} from './support/browser.mjs';
import {newDataFolder, Program, removeDataFolder} from './support/program.mjs';

const password = 'a sentence of my own';

let browser;
let program;
let folder;
let administrator;

before(async () => {
  folder = newDataFolder();
  program = await Program.start('demo', folder, {more: ['--example-trials', '0']});
  browser = await launch();
  administrator = await Visitor.enter(browser, program.url);
  await administrator.signIn('administrator');
}, {timeout: 300_000});

after(async () => {
  await administrator?.leave();
  await browser?.close();
  await program?.stop();
  removeDataFolder(folder);
});

async function openPeople() {
  await administrator.page.goto(`${program.url}/people`);
  await administrator.page.getByRole('heading', {name: 'People', level: 1}).waitFor();
}

async function signInAs(name, page) {
  await page.goto(program.url);
  await page.getByLabel('Name', {exact: true}).fill(name);
  await page.getByLabel('Password', {exact: true}).fill(password);
  await page.getByRole('button', {name: 'Sign in', exact: true}).click();
}

test('invites a person, who sets a password through the link and signs in', {timeout: 120_000}, async () => {
  const {page} = administrator;
  await openPeople();
  await page.getByRole('button', {name: 'Invite a person'}).click();
  await page.getByLabel('Full name').fill('Resident Zero');
  await page.getByRole('combobox', {name: 'Groups'}).fill('2026');
  await page.keyboard.press('Enter');
  await inspect(page, 'invite');
  await page.getByRole('button', {name: 'Make the link'}).click();
  const link = await page.getByLabel('One-time link').inputValue();
  assert.match(link, /\/join\?token=\S{20,}$/);
  await inspect(page, 'invite-link');
  await page.getByRole('button', {name: 'Done'}).click();
  await page.getByRole('link', {name: 'Resident Zero'}).waitFor();

  const resident = await Visitor.enter(browser, program.url);
  await resident.page.goto(link);
  await resident.page.getByRole('heading', {name: 'Welcome, Resident Zero'}).waitFor();
  await inspect(resident.page, 'join');
  await resident.page.getByLabel('Password', {exact: true}).fill(password);
  await resident.page.getByLabel('Password again').fill(`${password}!`);
  await resident.page.getByRole('button', {name: 'Set the password and sign in'}).click();
  await resident.page.getByText('The two passwords differ.').waitFor();
  await resident.page.getByLabel('Password again').fill(password);
  await resident.page.getByRole('button', {name: 'Set the password and sign in'}).click();
  await resident.page.getByRole('heading', {name: 'My training'}).waitFor();

  // the link is used up
  resident.expect(403, '/api/invitation/look');
  await resident.page.goto(link);
  await resident.page.getByRole('heading', {name: 'This link does not work'}).waitFor();
  await inspect(resident.page, 'join-used');

  // the password holds in another browser
  const elsewhere = await Visitor.enter(browser, program.url);
  await signInAs('resident.zero', elsewhere.page);
  await elsewhere.page.getByRole('heading', {name: 'My training'}).waitFor();
  await resident.assertClean();
  await elsewhere.assertClean();
  await resident.leave();
  await elsewhere.leave();
  await administrator.assertClean();
});

// thirty people; lines 8, 13 and 22 are broken each in its own way
function table() {
  const lines = ['name,display_name,email,role,level,cases,groups'];
  for (let number = 1; number <= 30; ++number) lines.push(`res${number},Resident ${number},,trainee,novice,0,2026|Night`);
  lines[7] = 'res7,Resident 7,,captain,novice,0,2026';
  lines[12] = ',Resident 12,,trainee,novice,0,2026';
  lines[21] = 'res21,Resident 21,,trainee,guru,0,2026';
  return lines.join('\n');
}

test('imports thirty people from CSV and leaves out the three broken rows, each named', {timeout: 120_000}, async () => {
  const {page} = administrator;
  await openPeople();
  await page.getByRole('link', {name: 'Import from CSV'}).click();
  await page.getByRole('heading', {name: 'Import people'}).waitFor();
  await inspect(page, 'import');
  await page.getByLabel('CSV file').setInputFiles({name: 'residents.csv', mimeType: 'text/csv', buffer: Buffer.from(table())});
  await page.getByRole('heading', {name: 'Row by row'}).waitFor();
  const broken = page.getByRole('region', {name: 'Rows of the file'}).getByRole('row').filter({hasText: 'Left out'});
  const told = await broken.allInnerTexts();
  assert.deepEqual(told.map((text) => /\d+/.exec(text)[0]), ['8', '13', '22']);
  assert.match(told[0], /captain/);
  assert.match(told[1], /name is missing/);
  assert.match(told[2], /guru/);
  await inspect(page, 'import-preview');

  await page.getByRole('button', {name: 'Import the 27 right rows, leave out 3'}).click();
  await page.getByText('27 added, 0 changed, 0 unchanged, 3 left out').waitFor();
  await inspect(page, 'import-done');
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', {name: /^Download 27/}).click()]);
  const saved = readFileSync(await download.path(), 'utf8').trim().split('\r\n');
  assert.equal(saved.length, 28);
  assert.match(saved[1], /^res1,Resident 1,http\S+\/join\?token=/);

  await page.getByRole('link', {name: 'To the people'}).click();
  await page.getByLabel('Group', {exact: true}).selectOption('Night');
  assert.equal(await page.getByRole('row').count(), 28);

  // the same table again changes nothing
  await page.goto(`${program.url}/people/import`);
  await page.getByLabel('Or paste the table').fill(table());
  await page.getByRole('button', {name: 'Look at what would happen'}).click();
  await page.getByText('No row can be imported.').waitFor();
  assert.ok(await page.getByRole('button', {name: 'Import', exact: true}).isDisabled());
  await administrator.assertClean();
});

test('disables a person, who is signed out and cannot come back', {timeout: 120_000}, async () => {
  const {page} = administrator;
  const resident = await Visitor.enter(browser, program.url);
  await signInAs('resident.zero', resident.page);
  await resident.page.getByRole('heading', {name: 'My training'}).waitFor();

  await page.goto(`${program.url}/people?find=zero`);
  await page.getByRole('link', {name: 'Resident Zero'}).click();
  await page.getByRole('heading', {name: 'Account'}).waitFor();
  await inspect(page, 'person-administrator');
  await page.getByRole('button', {name: 'Disable'}).click();
  await inspect(page, 'person-disable');
  await page.getByRole('dialog').getByRole('button', {name: 'Disable'}).click();
  await page.getByRole('button', {name: 'Enable'}).waitFor();

  resident.expect(401, '*');
  await resident.page.goto(program.url);
  await resident.page.getByRole('heading', {name: 'Sign in'}).waitFor();
  await signInAs('resident.zero', resident.page);
  await resident.page.getByRole('alert').getByText(/\S/).waitFor();
  assert.equal(await resident.page.getByRole('navigation', {name: 'Main'}).count(), 0);
  await resident.assertClean();
  await resident.leave();
  await administrator.assertClean();
});
