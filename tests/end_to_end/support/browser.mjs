// Chromium, and pages that watch themselves: a console error, a page error, an answer or a message
// that breaks the wire schema is kept, and `assertClean` fails with all of them.
import assert from 'node:assert/strict';
import {mkdirSync, readFileSync} from 'node:fs';
import path from 'node:path';
import {chromiumPath, pictures, requireFromWeb} from './places.mjs';
import {complaints, definitionOf} from './wire_check.mjs';

const {chromium} = requireFromWeb('playwright-core');
const axe = readFileSync(requireFromWeb.resolve('axe-core/axe.min.js'), 'utf8');

export const desk = {width: 1440, height: 900};
export const small = {width: 1280, height: 720};

export function launch() {
  // software GL: the console's picture needs WebGL and the machine may have no graphics card
  const args = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
  return chromium.launch({executablePath: chromiumPath, args});
}

export class Visitor {
  /** One person's browser: cookies of its own. */
  static async enter(browser, url) {
    const visitor = new Visitor();
    visitor.url = url;
    visitor.faults = [];
    visitor.expected = [{status: 401, path: '/api/session'}];
    visitor.pending = new Set();
    visitor.context = await browser.newContext({viewport: desk, reducedMotion: 'reduce'});
    visitor.page = await visitor.newTab();
    return visitor;
  }

  async newTab() {
    const page = await this.context.newPage();
    page.on('pageerror', (error) => this.faults.push(`page error: ${error.message}`));
    page.on('console', (message) => this.#heard(message));
    page.on('response', (response) => {
      const check = this.#checkAnswer(response).catch(() => {}).finally(() => this.pending.delete(check));
      this.pending.add(check);
    });
    page.on('websocket', (socket) => {
      socket.on('framesent', ({payload}) => this.#checkText('ClientMessage', payload));
      socket.on('framereceived', ({payload}) => this.#checkText('ServerNotice', payload));
    });
    return page;
  }

  /** From here on this refusal belongs to the test. status 0: the connection fails. */
  expect(status, pathname) {
    this.expected.push({status, path: pathname});
  }

  #heard(message) {
    if (message.type() !== 'error') return;
    const text = message.text();
    const at = message.location().url;
    const status = Number(/status of (\d+)/.exec(text)?.[1] ?? 0);
    const network = status > 0 || /ERR_|WebSocket connection/.test(text);
    const pathname = at === '' ? '' : new URL(at).pathname;
    if (network && this.expected.some((one) => one.status === status && (one.path === pathname || one.path === '*'))) return;
    this.faults.push(`console: ${text} (${at})`);
  }

  async #checkAnswer(response) {
    const {pathname} = new URL(response.url());
    if (!pathname.startsWith('/api/') || response.status() === 204) return;
    if (!(response.headers()['content-type'] ?? '').startsWith('application/json')) return;
    const method = response.request().method();
    const definition = definitionOf(method, pathname, response.status());
    if (definition === null) {
      this.faults.push(`${method} ${pathname} is not in wire.schema.yaml`);
      return;
    }
    const value = await response.json();
    for (const complaint of complaints(definition, value)) this.faults.push(`${method} ${pathname}: ${complaint}`);
  }

  #checkText(definition, payload) {
    if (typeof payload !== 'string') return;
    for (const complaint of complaints(definition, JSON.parse(payload))) this.faults.push(`live channel: ${complaint}`);
  }

  async assertClean() {
    await Promise.all(this.pending);
    assert.deepEqual(this.faults, []);
  }

  async leave() {
    await this.context.close();
  }

  /** Signs in through the page, with the demo account of this role. */
  async signIn(role) {
    const {page} = this;
    await page.goto(this.url);
    await page.getByRole('region', {name: 'Demo accounts'}).getByRole('button').filter({hasText: role}).click();
    await page.getByRole('button', {name: 'Sign in', exact: true}).click();
    await page.getByRole('navigation', {name: 'Main'}).waitFor();
  }

  async signOut() {
    await this.page.getByRole('button', {name: 'Sign out'}).click();
    await this.page.getByRole('heading', {name: 'Sign in'}).waitFor();
  }
}

/** What axe says about the page as it stands, one line per finding. */
export async function accessibilityFindings(page) {
  // through the debugger, because the page's own content policy rightly refuses foreign scripts
  const session = await page.context().newCDPSession(page);
  await session.send('Runtime.evaluate', {expression: axe});
  const expression = `axe.run().then((result) => JSON.stringify(result.violations.map((violation) =>
    violation.id + ' (' + violation.impact + '): ' + violation.nodes.map((node) => node.html.slice(0, 160)).join(' | '))))`;
  const {result} = await session.send('Runtime.evaluate', {expression, awaitPromise: true});
  await session.detach();
  return JSON.parse(result.value);
}

/** Takes the picture of a view at both sizes; checks it with axe and for sideways scrolling. */
export async function inspect(page, name) {
  mkdirSync(pictures, {recursive: true});
  for (const size of [small, desk]) {
    await page.setViewportSize(size);
    await page.waitForTimeout(150);
    await page.screenshot({path: path.join(pictures, `${name}-${size.width}x${size.height}.png`), fullPage: true});
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= size.width, `${name} is ${wide} px wide in a window of ${size.width} px`);
  }
  assert.deepEqual(await accessibilityFindings(page), [], `axe on ${name}`);
}
