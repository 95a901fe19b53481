// Where things lie, and what the browser application has installed for its own development.
import {createRequire} from 'node:module';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

export const repository = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..', '..', '..');
export const webRoot = path.join(repository, 'app', 'web', 'dist');
export const program = path.resolve(repository, process.env.CATHEDRA_BIN ?? 'build/release/cathedra');
export const pictures = path.resolve(repository, process.env.CATHEDRA_SCREENSHOTS ?? 'build/screenshots');
export const chromiumPath = process.env.CHROMIUM ?? '/usr/bin/chromium';

/** require() as app/web sees it: the tests bring no packages of their own. */
export const requireFromWeb = createRequire(path.join(repository, 'app', 'web', 'package.json'));
