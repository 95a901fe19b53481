// Starts the real program on a data folder of its own and stops it again.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {program, webRoot} from './places.mjs';

const start_limit_ms = 180_000;

export function newDataFolder() {
  return mkdtempSync(path.join(tmpdir(), 'cathedra-e2e-'));
}

export function removeDataFolder(folder) {
  rmSync(folder, {recursive: true, force: true});
}

export class Program {
  /** Fills a demo with trials of its example group, without serving it. */
  static async load(folder, exampleTrials) {
    const child = spawn(program, ['demo', '--data', folder, '--load-only', '--example-trials', String(exampleTrials)],
      {stdio: ['ignore', 'ignore', 'inherit']});
    const code = await new Promise((resolve, reject) => {
      child.once('exit', resolve);
      child.once('error', reject);
    });
    if (code !== 0) throw new Error(`loading the demo ended with ${code}`);
  }

  /** command: "demo" or "serve"; resolves when the program says that it is ready. */
  static async start(command, folder, {port = 0, more = []} = {}) {
    const started = new Program();
    started.output = '';
    started.child = spawn(program, [command, '--data', folder, '--port', String(port), '--web-root', webRoot, ...more],
      {stdio: ['ignore', 'pipe', 'pipe']});
    started.exited = new Promise((resolve) => started.child.once('exit', (code, signal) => resolve({code, signal})));
    for (const stream of [started.child.stdout, started.child.stderr]) {
      stream.on('data', (text) => { started.output += text; });
    }
    const [, url] = await started.says(/Cathedra is ready at (http:\/\/\S+)/, start_limit_ms);
    started.url = url;
    started.port = Number(new URL(url).port);
    return started;
  }

  /** Waits until the output matches. */
  async says(pattern, limit_ms = 30_000) {
    let over = null;
    this.exited.then((end) => { over = end; });
    this.child.once('error', (error) => { over = error; });
    const end = Date.now() + limit_ms;
    while (Date.now() < end) {
      const found = pattern.exec(this.output);
      if (found) return found;
      if (over) throw new Error(`the program ended (${JSON.stringify(over)}) before it said ${pattern}:\n${this.output}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`the program did not say ${pattern} within ${limit_ms} ms:\n${this.output}`);
  }

  /** Ends it as Ctrl-C does; the exit code must be 0. */
  async stop() {
    this.child.kill('SIGINT');
    const {code, signal} = await this.exited;
    if (code !== 0) throw new Error(`the program ended with ${code ?? signal}:\n${this.output}`);
  }

  /** Ends it as a power cut does. */
  async kill() {
    this.child.kill('SIGKILL');
    await this.exited;
  }
}
