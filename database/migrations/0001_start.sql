-- The first schema. Never edited once released: what comes later is a new numbered file.
--
-- Plain SQL on purpose, so that another store is a matter of translating a few words: the types
-- are TEXT, INTEGER (within 32 bits), REAL and BLOB, the only table options are STRICT and
-- WITHOUT ROWID. Keys are UUIDv7 as text, times are UTC as ISO 8601 text with milliseconds and Z,
-- truth values are 0 or 1. Numbers have their unit in the name.

CREATE TABLE schema_migration (
  version INTEGER NOT NULL PRIMARY KEY,
  name TEXT NOT NULL,
  applied_utc TEXT NOT NULL
) STRICT;

-- ---- people ---------------------------------------------------------------------------------

-- What training data points at. Holds nothing that tells who it is.
CREATE TABLE person (
  id TEXT NOT NULL PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('live', 'simulated', 'published')),
  created_utc TEXT NOT NULL
) STRICT;

-- Who it is. Apart from person, so that it can be erased and the trials stay. salt goes into the
-- audit's hashes of a person: once it is erased with the row, they tell nothing any more.
CREATE TABLE identity (
  person_id TEXT NOT NULL PRIMARY KEY REFERENCES person (id),
  name TEXT NOT NULL CHECK (name <> ''),
  display_name TEXT NOT NULL,
  email TEXT,
  password_phc TEXT NOT NULL,
  role TEXT NOT NULL CHECK (role IN ('trainee', 'instructor', 'administrator', 'researcher')),
  disabled INTEGER NOT NULL CHECK (disabled IN (0, 1)),
  salt TEXT NOT NULL
) STRICT;
CREATE UNIQUE INDEX identity_by_name ON identity (lower(name));

CREATE TABLE person_group (
  id TEXT NOT NULL PRIMARY KEY,
  name TEXT NOT NULL UNIQUE CHECK (name <> ''),
  created_utc TEXT NOT NULL
) STRICT;

-- to_utc is null while it lasts.
CREATE TABLE membership (
  id TEXT NOT NULL PRIMARY KEY,
  person_id TEXT NOT NULL REFERENCES person (id),
  group_id TEXT NOT NULL REFERENCES person_group (id),
  from_utc TEXT NOT NULL,
  to_utc TEXT
) STRICT;
CREATE UNIQUE INDEX membership_now ON membership (person_id, group_id) WHERE to_utc IS NULL;
CREATE INDEX membership_by_group ON membership (group_id);

-- Dated, so that today's novice is not relabelled later. ordinal: the order of declaring.
CREATE TABLE experience (
  person_id TEXT NOT NULL REFERENCES person (id),
  ordinal INTEGER NOT NULL,
  level TEXT NOT NULL CHECK (level IN ('novice', 'intermediate', 'expert')),
  cases INTEGER NOT NULL CHECK (cases >= 0),
  declared_utc TEXT NOT NULL,
  declared_by TEXT NOT NULL,
  PRIMARY KEY (person_id, ordinal)
) STRICT;
CREATE INDEX experience_by_date ON experience (person_id, declared_utc, ordinal, level);

CREATE TABLE setup_token (
  token_hash TEXT NOT NULL PRIMARY KEY CHECK (token_hash <> ''),
  created_utc TEXT NOT NULL,
  expires_utc TEXT NOT NULL,
  used_utc TEXT
) STRICT;

CREATE TABLE web_session (
  token_hash TEXT NOT NULL PRIMARY KEY CHECK (token_hash <> ''),
  person_id TEXT NOT NULL REFERENCES person (id),
  csrf_token TEXT NOT NULL,
  created_utc TEXT NOT NULL,
  last_seen_utc TEXT NOT NULL
) STRICT;
CREATE INDEX web_session_by_person ON web_session (person_id);

-- ---- curricula ------------------------------------------------------------------------------

-- publication: 1, 2, ... in the order the versions of one curriculum were published; 0 for drafts.
CREATE TABLE curriculum_version (
  id TEXT NOT NULL PRIMARY KEY,
  curriculum_id TEXT NOT NULL CHECK (curriculum_id <> ''),
  version TEXT NOT NULL CHECK (version <> ''),
  sha256 TEXT NOT NULL,
  yaml TEXT NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('draft', 'published', 'retired')),
  publication INTEGER NOT NULL,
  published_utc TEXT,
  UNIQUE (curriculum_id, version)
) STRICT;

CREATE TABLE exercise_version (
  id TEXT NOT NULL PRIMARY KEY,
  curriculum_version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  position INTEGER NOT NULL,
  exercise_id TEXT NOT NULL CHECK (exercise_id <> ''),
  version INTEGER NOT NULL,
  yaml TEXT NOT NULL,
  UNIQUE (curriculum_version_id, exercise_id)
) STRICT;
CREATE INDEX exercise_version_by_exercise ON exercise_version (exercise_id);

-- value is in the unit of its metric. dataset: where it was derived from, or empty.
CREATE TABLE benchmark (
  curriculum_version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  position INTEGER NOT NULL,
  benchmark_id TEXT NOT NULL,
  metric TEXT NOT NULL,
  rule TEXT NOT NULL,
  provisional INTEGER NOT NULL CHECK (provisional IN (0, 1)),
  value REAL NOT NULL,
  dataset TEXT NOT NULL,
  PRIMARY KEY (curriculum_version_id, benchmark_id)
) STRICT;

CREATE TABLE enrolment (
  id TEXT NOT NULL PRIMARY KEY,
  person_id TEXT NOT NULL REFERENCES person (id),
  curriculum_id TEXT NOT NULL,
  curriculum_version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  enrolled_utc TEXT NOT NULL,
  UNIQUE (person_id, curriculum_id),
  UNIQUE (id, person_id)
) STRICT;

-- ---- trials ---------------------------------------------------------------------------------

-- ended_utc and end_reason are null while it runs. outcome repeats the latest score's, so that
-- lists of many trials need no join. seed: unsigned 64 bits in decimal. Voiding keeps end_reason.
CREATE TABLE trial (
  id TEXT NOT NULL PRIMARY KEY,
  person_id TEXT NOT NULL REFERENCES person (id),
  enrolment_id TEXT,
  exercise_id TEXT NOT NULL CHECK (exercise_id <> ''),
  exercise_version_id TEXT REFERENCES exercise_version (id),
  ordinal INTEGER NOT NULL,
  source TEXT NOT NULL,
  dataset TEXT NOT NULL,
  apparatus TEXT NOT NULL,
  device TEXT NOT NULL,
  seed TEXT NOT NULL,
  build TEXT NOT NULL,
  isa TEXT NOT NULL,
  anatomy_sha256 TEXT NOT NULL,
  instruments_sha256 TEXT NOT NULL,
  input_sha256 TEXT NOT NULL,
  state_hash TEXT NOT NULL,
  started_utc TEXT NOT NULL,
  ended_utc TEXT,
  end_reason TEXT,
  end_time_s REAL NOT NULL,
  paused_s REAL NOT NULL,
  slowed_s REAL NOT NULL,
  interrupted INTEGER NOT NULL CHECK (interrupted IN (0, 1)),
  outcome TEXT,
  voided_utc TEXT,
  voided_by TEXT,
  void_reason TEXT,
  FOREIGN KEY (enrolment_id, person_id) REFERENCES enrolment (id, person_id),
  CHECK ((ended_utc IS NULL) = (end_reason IS NULL)),
  CHECK ((voided_utc IS NULL) = (void_reason IS NULL))
) STRICT;
CREATE UNIQUE INDEX trial_by_person ON trial (person_id, exercise_id, ordinal);
-- Carries what the counts on the list of people need, so that they read no trial row.
CREATE INDEX trial_counts
  ON trial (person_id, exercise_id, ended_utc, outcome, voided_utc, interrupted, started_utc);
CREATE INDEX trial_by_exercise ON trial (exercise_id, dataset);
CREATE INDEX trial_by_enrolment ON trial (enrolment_id);
CREATE INDEX trial_running ON trial (id) WHERE ended_utc IS NULL;

-- Steps as they went. target, tolerance and residual: mm for translate, rad for rotate;
-- hold has its target in s. ended_s is null for a step that was not done.
CREATE TABLE trial_step (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  position INTEGER NOT NULL,
  step_id TEXT NOT NULL,
  kind TEXT NOT NULL,
  target REAL NOT NULL,
  tolerance REAL NOT NULL,
  started_s REAL NOT NULL,
  ended_s REAL,
  residual REAL NOT NULL,
  PRIMARY KEY (trial_id, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE trace_chunk (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  kind TEXT NOT NULL CHECK (kind IN ('inputs', 'observed', 'hashes')),
  seq INTEGER NOT NULL CHECK (seq >= 0),
  codec TEXT NOT NULL,
  bytes BLOB NOT NULL,
  written_utc TEXT NOT NULL,
  PRIMARY KEY (trial_id, kind, seq)
) STRICT;

-- value is null where the event has a value that is not a number.
CREATE TABLE event (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  seq INTEGER NOT NULL,
  t_s REAL NOT NULL,
  code TEXT NOT NULL,
  severity TEXT NOT NULL,
  detail TEXT NOT NULL,
  value REAL,
  PRIMARY KEY (trial_id, seq)
) STRICT, WITHOUT ROWID;

-- value is in the unit of its metric.
CREATE TABLE metric_value (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  position INTEGER NOT NULL,
  metric TEXT NOT NULL,
  version INTEGER NOT NULL,
  value REAL NOT NULL,
  PRIMARY KEY (trial_id, position)
) STRICT, WITHOUT ROWID;
CREATE UNIQUE INDEX metric_value_by_metric ON metric_value (trial_id, metric, version);

-- Many per trial: a trial judged again by a later rule keeps its earlier scores.
CREATE TABLE score (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  ordinal INTEGER NOT NULL,
  rule_version TEXT NOT NULL,
  outcome TEXT NOT NULL,
  sentence TEXT NOT NULL,
  scored_utc TEXT NOT NULL,
  PRIMARY KEY (trial_id, ordinal)
) STRICT, WITHOUT ROWID;

-- bound and value are in the unit of the metric, or counts. value is null where the trial has none.
CREATE TABLE criterion (
  trial_id TEXT NOT NULL,
  score_ordinal INTEGER NOT NULL,
  position INTEGER NOT NULL,
  subject TEXT NOT NULL,
  comparison TEXT NOT NULL,
  bound REAL NOT NULL,
  value REAL,
  met INTEGER NOT NULL CHECK (met IN (0, 1)),
  benchmark TEXT NOT NULL,
  provisional INTEGER NOT NULL CHECK (provisional IN (0, 1)),
  PRIMARY KEY (trial_id, score_ordinal, position),
  FOREIGN KEY (trial_id, score_ordinal) REFERENCES score (trial_id, ordinal)
) STRICT, WITHOUT ROWID;

-- ---- audit ----------------------------------------------------------------------------------

-- hash is the SHA-256 of the row's other columns; prev_hash is the hash of the row before.
CREATE TABLE audit (
  seq INTEGER NOT NULL PRIMARY KEY,
  utc TEXT NOT NULL,
  actor TEXT NOT NULL,
  action TEXT NOT NULL,
  object TEXT NOT NULL,
  before_hash TEXT NOT NULL,
  after_hash TEXT NOT NULL,
  prev_hash TEXT NOT NULL,
  hash TEXT NOT NULL
) STRICT;

-- One row: where the chain ends, so that a shortened chain is noticed.
CREATE TABLE audit_head (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  seq INTEGER NOT NULL,
  hash TEXT NOT NULL
) STRICT;
INSERT INTO audit_head (one, seq, hash) VALUES (1, 0, '');

-- ---- messages to other systems --------------------------------------------------------------

CREATE TABLE outbox (
  id TEXT NOT NULL PRIMARY KEY,
  created_utc TEXT NOT NULL,
  kind TEXT NOT NULL,
  payload TEXT NOT NULL,
  sent_utc TEXT
) STRICT;
