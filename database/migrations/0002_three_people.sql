-- What administrators, instructors and trainees need around the trials: invitations, drafts of
-- curricula and who trains by which, comments, and everybody's own settings.

ALTER TABLE identity ADD COLUMN last_sign_in_utc TEXT;

-- One-time links by which a person sets the own password. Only a hash of the token is stored; a
-- new link ends the ones before.
CREATE TABLE invitation (
  token_hash TEXT NOT NULL PRIMARY KEY CHECK (token_hash <> ''),
  person_id TEXT NOT NULL REFERENCES person (id),
  created_utc TEXT NOT NULL,
  created_by TEXT NOT NULL,
  expires_utc TEXT NOT NULL,
  used_utc TEXT,
  withdrawn_utc TEXT
) STRICT;
CREATE INDEX invitation_by_person ON invitation (person_id, created_utc);

-- One draft per curriculum, as it was last saved, right or wrong. from_version: what it was copied
-- from ("vascular-basics@1.0.0"), or empty.
CREATE TABLE curriculum_draft (
  curriculum_id TEXT NOT NULL PRIMARY KEY CHECK (curriculum_id <> ''),
  yaml TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  from_version TEXT NOT NULL,
  saved_utc TEXT NOT NULL,
  saved_by TEXT NOT NULL
) STRICT;

-- Which curriculum a person trains by, where that is not the default of the site.
CREATE TABLE person_curriculum (
  person_id TEXT NOT NULL PRIMARY KEY REFERENCES person (id),
  curriculum_id TEXT NOT NULL CHECK (curriculum_id <> ''),
  assigned_utc TEXT NOT NULL,
  assigned_by TEXT NOT NULL
) STRICT;
CREATE INDEX person_curriculum_by_curriculum ON person_curriculum (curriculum_id);

CREATE TABLE site_setting (
  name TEXT NOT NULL PRIMARY KEY,
  value TEXT NOT NULL
) STRICT;

-- value: JSON, as the browser sends it.
CREATE TABLE person_setting (
  person_id TEXT NOT NULL PRIMARY KEY REFERENCES person (id),
  value TEXT NOT NULL,
  saved_utc TEXT NOT NULL
) STRICT;

-- What an instructor wrote about a trial. t_s is null for the trial as a whole. A comment that was
-- taken back keeps its row without its text.
CREATE TABLE trial_comment (
  id TEXT NOT NULL PRIMARY KEY,
  trial_id TEXT NOT NULL REFERENCES trial (id),
  author_id TEXT NOT NULL REFERENCES person (id),
  written_utc TEXT NOT NULL,
  t_s REAL,
  text TEXT NOT NULL,
  withdrawn_utc TEXT
) STRICT;
CREATE INDEX trial_comment_by_trial ON trial_comment (trial_id, written_utc);

-- How many trials were made under a version of a curriculum.
CREATE INDEX trial_by_exercise_version ON trial (exercise_version_id);
