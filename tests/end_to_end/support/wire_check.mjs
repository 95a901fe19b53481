// Checks what passes between page and server against app/wire/wire.schema.yaml.
import {readFileSync} from 'node:fs';
import path from 'node:path';
import {repository, requireFromWeb} from './places.mjs';

const Ajv = requireFromWeb('ajv').default;
const {parse} = requireFromWeb('yaml');

const schema = parse(readFileSync(path.join(repository, 'app/wire/wire.schema.yaml'), 'utf8'));
delete schema['x-frame'];
const ajv = new Ajv({allErrors: true, strict: false});
ajv.addSchema(schema, 'wire');

const routes = [
  [/^GET \/api\/site$/, 'Site'],
  [/^(GET|POST) \/api\/session$/, 'Session'],
  [/^POST \/api\/setup$/, 'Session'],
  [/^GET \/api\/training$/, 'Training'],
  [/^GET \/api\/exercises\/[^/]+$/, 'Briefing'],
  [/^POST \/api\/trials$/, 'BegunTrial'],
  [/^GET \/api\/live\/mine$/, 'LiveMine'],
  [/^GET \/api\/trials\/[^/]+$/, 'Debrief'],
  [/^GET \/api\/people$/, 'People'],
  [/^GET \/api\/people\/[^/]+\/progress$/, 'ProgressReport'],
  [/^GET \/api\/compare$/, 'CompareOptions'],
  [/^GET \/api\/compare\/[^/]+$/, 'Comparison'],
];

/** The complaints about a value that should be the named definition; empty when there are none. */
export function complaints(definition, value) {
  const validate = ajv.getSchema(`wire#/definitions/${definition}`);
  if (validate(value)) return [];
  return validate.errors.slice(0, 5).map((error) => `${definition}${error.instancePath}: ${error.message}`);
}

/** Which definition an answer must follow. */
export function definitionOf(method, pathname, status) {
  if (status >= 400) return 'Problem';
  const found = routes.find(([pattern]) => pattern.test(`${method} ${pathname}`));
  return found ? found[1] : null;
}
