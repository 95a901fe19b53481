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
  [/^POST \/api\/invitation\/look$/, 'InvitationGreeting'],
  [/^POST \/api\/invitation$/, 'Session'],
  [/^GET \/api\/live\/mine$/, 'LiveMine'],
  [/^GET \/api\/live$/, 'LiveList'],
  [/^POST \/api\/practice$/, 'BegunTrial'],
  [/^GET \/api\/practice\/[^/]+\/result$/, 'PracticeResult'],
  [/^GET \/api\/metrics$/, 'Metrics'],
  [/^(GET|PUT) \/api\/me\/settings$/, 'Settings'],
  [/^GET \/api\/trials\/[^/]+$/, 'Debrief'],
  [/^POST \/api\/trials\/[^/]+\/void$/, 'Debrief'],
  [/^POST \/api\/trials\/[^/]+\/comments$/, 'Comment'],
  [/^GET \/api\/people$/, 'People'],
  [/^POST \/api\/people$/, 'Invitation'],
  [/^POST \/api\/people\/import\/preview$/, 'ImportPreview'],
  [/^POST \/api\/people\/import$/, 'ImportResult'],
  [/^(GET|PUT) \/api\/people\/[^/]+$/, 'PersonDetail'],
  [/^POST \/api\/people\/[^/]+\/invitation$/, 'Invitation'],
  [/^GET \/api\/people\/[^/]+\/progress$/, 'ProgressReport'],
  [/^GET \/api\/groups$/, 'Groups'],
  [/^GET \/api\/cohort$/, 'Cohort'],
  [/^GET \/api\/curricula$/, 'Curricula'],
  [/^POST \/api\/curricula$/, 'CurriculumText'],
  [/^POST \/api\/curricula\/check$/, 'CurriculumCheck'],
  [/^PUT \/api\/curricula\/default$/, 'Curricula'],
  [/^GET \/api\/curricula\/[^/]+\/versions\/[^/]+$/, 'CurriculumText'],
  [/^PUT \/api\/curricula\/[^/]+\/draft$/, 'CurriculumText'],
  [/^POST \/api\/curricula\/[^/]+\/publish$/, 'CurriculumText'],
  [/^POST \/api\/curricula\/[^/]+\/retire$/, 'Curricula'],
  [/^GET \/api\/curricula\/[^/]+\/diff$/, 'CurriculumDiff'],
  [/^POST \/api\/dry-runs$/, 'DryRun'],
  [/^GET \/api\/dry-runs\/[^/]+$/, 'DryRun'],
  [/^GET \/api\/catalogue$/, 'Catalogue'],
  [/^GET \/api\/instruments$/, 'Instruments'],
  [/^GET \/api\/system$/, 'System'],
  [/^POST \/api\/system\/backups$/, 'BackupRow'],
  [/^GET \/api\/audit$/, 'AuditLog'],
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
