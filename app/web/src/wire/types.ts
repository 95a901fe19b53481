// Written by app/wire/generate.mjs from wire.schema.yaml. Change the schema, not this file.

export type Role = 'trainee' | 'instructor' | 'administrator' | 'researcher';
export type Level = 'novice' | 'intermediate' | 'expert';
export type Outcome = 'passed' | 'not_passed' | 'invalid';
export type EndReason = 'completed' | 'timeout' | 'limit' | 'aborted' | 'diverged';
export type Source = 'live' | 'imported' | 'simulated-operator' | 'published-data';
export type Status =
  'locked' | 'available' | 'in_progress' | 'practised' | 'proficient' | 'lapsed' | 'waived' | 'exhausted';
export type Direction = 'lower' | 'higher';
export type Consequence = 'mark' | 'fail' | 'critical_error' | 'stop';
export type StepKind = 'translate' | 'rotate' | 'hold';
export type ClientMessage = HandleMessage | ControlMessage | PingMessage;
export type ServerNotice =
  | {
      type: 'error' | 'second_tab';
      message: string;
    }
  | {
      type: 'pong';
      sent_ms: number;
    }
  | {
      type: 'filed' | 'practice_ended';
      trial_id: string;
    };

export interface Problem {
  /**
   * one sentence that says what to do
   */
  error: string;
  code?: string;
}
export interface SignIn {
  name: string;
  password: string;
}
export interface Setup {
  token: string;
  name: string;
  password: string;
}
export interface Site {
  demo: boolean;
  version: string;
  needs_setup: boolean;
  demo_accounts: DemoAccount[];
}
export interface DemoAccount {
  name: string;
  password: string;
  role: Role;
}
export interface Session {
  person_id: string;
  name: string;
  display_name: string;
  role: Role;
  /**
   * sent back as X-CSRF-Token with every change
   */
  csrf: string;
  demo: boolean;
}
export interface Target {
  metric: string;
  op: string;
  value: number;
  unit: string;
  provisional: boolean;
  reason: string;
}
export interface StepInfo {
  id: string;
  kind: StepKind;
  /**
   * Feed to 350 mm
   */
  title: string;
  /**
   * mm, deg or s as unit says, cumulative
   */
  target: number;
  tolerance: number;
  hold_s: number;
  unit: 'mm' | 'deg' | 's';
  /**
   * 1-based round of a repeat, 0 outside
   */
  round: number;
  rounds: number;
}
export interface LimitInfo {
  metric: string;
  title: string;
  op: string;
  value: number;
  unit: string;
  on_breach: Consequence;
}
export interface InstrumentInfo {
  id: string;
  title: string;
  kind: 'guidewire' | 'catheter';
  outer_diameter_mm: number;
  length_mm: number;
}
export interface Briefing {
  exercise_id: string;
  version: number;
  title: string;
  goal: string;
  status: Status;
  status_sentence: string;
  can_start: boolean;
  steps: StepInfo[];
  limits: LimitInfo[];
  instrument: InstrumentInfo;
  anatomy_id: string;
  anatomy_title: string;
  time_limit_s: number;
  targets: Target[];
  pass_sentence: string;
  /**
   * metric ids
   */
  record: string[];
}
export interface Chart {
  id: string;
  title: string;
  /**
   * what the chart shows in words
   */
  summary: string;
  /**
   * one <svg> element made by reports/
   */
  svg: string;
  table: Table;
}
export interface Table {
  columns: string[];
  rows: string[][];
}
export interface ExerciseCard {
  exercise_id: string;
  title: string;
  status: Status;
  /**
   * 1 of 2 passes in a row
   */
  sentence: string;
}
export interface PlanBlock {
  id: string;
  title: string;
  any_order: boolean;
  /**
   * title of the block before; empty when none
   */
  after: string;
  exercises: ExerciseCard[];
}
export interface TrialRow {
  trial_id: string;
  exercise_id: string;
  ordinal: number;
  started_utc: string;
  end_reason: EndReason | null;
  source: Source;
  device: string;
  outcome: Outcome | null;
  time_s: number | null;
  target_s: number | null;
  force_max_n: number | null;
  critical_errors: number;
  voided: boolean;
  interrupted: boolean;
}
export interface Training {
  curriculum_title: string;
  curriculum_version: string;
  proficient_count: number;
  exercise_count: number;
  /**
   * 0 when there is no limit
   */
  max_trials_per_day: number;
  trials_today: number;
  blocks: PlanBlock[];
  next: NextExercise | null;
}
export interface NextExercise {
  briefing: Briefing;
  /**
   * last three trials, target, what is missing, in words
   */
  headline: string;
  /**
   * number of the next trial
   */
  ordinal: number;
  last_trials: TrialRow[];
  chart: Chart | null;
}
export interface BeginTrial {
  exercise_id: string;
  device: string;
}
export interface BegunTrial {
  trial_id: string;
  /**
   * 0 for practice
   */
  ordinal: number;
  briefing: Briefing;
  /**
   * nothing is recorded
   */
  practice: boolean;
}
export interface LiveMine {
  trial: BegunTrial | null;
}
export interface CriterionResult {
  subject: string;
  title: string;
  op: string;
  needed: number;
  value: number | null;
  unit: string;
  met: boolean;
  provisional: boolean;
  note: string;
}
export interface MetricResult {
  id: string;
  version: number;
  title: string;
  value: number;
  unit: string;
  direction: Direction;
  definition: string;
}
export interface EventRow {
  time_s: number;
  code: string;
  severity: 'info' | 'mark' | 'fail' | 'critical';
  text: string;
}
export interface Debrief {
  trial: TrialRow;
  person_name: string;
  exercise_title: string;
  exercise_version: number;
  rule_sentence: string;
  verdict_sentence: string;
  criteria: CriterionResult[];
  metrics: MetricResult[];
  events: EventRow[];
  /**
   * time per step; contact force over time
   */
  charts: Chart[];
  progress_sentence: string;
  status: Status;
  build: string;
  state_hash: string;
  paused_s: number;
  slowed_s: number;
  void: null | {
    voided_utc: string;
    voided_by: string;
    reason: string;
  };
  /**
   * by time of the trial, the whole first
   */
  comments: Comment[];
  /**
   * the caller may void it and comment on it
   */
  may_judge: boolean;
}
export interface Comment {
  id: string;
  author: string;
  /**
   * may be taken back by the caller
   */
  own: boolean;
  written_utc: string;
  /**
   * of the trial; null: of the whole
   */
  time_s: number | null;
  text: string;
}
export interface ExerciseProgress {
  exercise_id: string;
  title: string;
  status: Status;
  headline: string;
  /**
   * time and highest force over trials
   */
  charts: Chart[];
  /**
   * one small drawing per recorded metric
   */
  small_multiples: Chart[];
  /**
   * last, previous and best of each recorded metric
   */
  standings: Standing[];
  trials: TrialRow[];
}
export interface Standing {
  metric: string;
  title: string;
  unit: string;
  direction: Direction;
  last: number | null;
  previous: number | null;
  best: number | null;
  change_to_previous_percent: number | null;
  change_to_first_percent: number | null;
}
export interface ProgressReport {
  person: PersonRow;
  exercises: ExerciseProgress[];
}
export interface PersonRow {
  person_id: string;
  display_name: string;
  name: string;
  role: Role;
  kind: 'live' | 'simulated' | 'published';
  level: Level | null;
  groups: string[];
  disabled: boolean;
  trials: number;
  last_trial_utc: string | null;
  statuses: ExerciseCard[];
}
export interface People {
  people: PersonRow[];
}
export interface CompareOptions {
  choices: CompareChoice[];
}
export interface CompareChoice {
  exercise_id: string;
  exercise_title: string;
  /**
   * paper, live or simulated: never pooled
   */
  dataset: string;
  dataset_title: string;
  people: number;
  trials: number;
}
export interface Comparison {
  exercise_id: string;
  exercise_title: string;
  dataset: string;
  dataset_title: string;
  apparatus: string;
  /**
   * false when a group has too few people to compare; headline says so
   */
  enough: boolean;
  headline: string;
  /**
   * experts, novices, participant means, effect, p floor
   */
  charts: Chart[];
  groups: GroupSummary[];
  effect: null | {
    hedges_g: number;
    low: number;
    high: number;
    sentence: string;
  };
  test: null | {
    u: number;
    p: number;
    p_floor: number;
    sentence: string;
  };
  learning: Table1;
  nesting_sentence: string;
  warnings: string[];
}
export interface GroupSummary {
  level: Level;
  people: number;
  trials: number;
  mean_s: number;
  /**
   * over participant means
   */
  sd_s: number | null;
  /**
   * first to last trial
   */
  improvement_percent: number | null;
}
/**
 * per person: first, last, improvement, power law
 */
export interface Table1 {
  columns: string[];
  rows: string[][];
}
export interface PersonDetail {
  person: PersonRow;
  /**
   * empty when none
   */
  email: string;
  /**
   * assigned to this person; null: the default of the site
   */
  curriculum_id: string | null;
  /**
   * of the one the person trains by
   */
  curriculum_title: string;
  /**
   * newest first
   */
  experience: ExperienceRow[];
  memberships: MembershipRow[];
  /**
   * of the link that was made last and not used
   */
  invitation_expires_utc: string | null;
  /**
   * has a password and is not disabled
   */
  can_sign_in: boolean;
  /**
   * null: never
   */
  last_sign_in_utc?: string | null;
  created_utc: string;
}
export interface ExperienceRow {
  level: Level;
  cases: number;
  declared_utc: string;
  /**
   * display name
   */
  declared_by: string;
}
export interface MembershipRow {
  group: string;
  from_utc: string;
  to_utc: string | null;
}
export interface InvitePerson {
  name: string;
  display_name: string;
  email: string;
  role: Role;
  level: Level | null;
  cases: number;
  groups: string[];
  curriculum_id: string | null;
}
export interface Invitation {
  person_id: string;
  name: string;
  display_name: string;
  /**
   * path on this site: /join?token=...
   */
  link: string;
  expires_utc: string;
}
export interface ChangePerson {
  display_name?: string;
  email?: string;
  role?: Role;
  disabled?: boolean;
  /**
   * all of them; joins and leaves are dated
   */
  groups?: string[];
  /**
   * declared today; earlier declarations stay
   */
  level?: 'novice' | 'intermediate' | 'expert';
  cases?: number;
  curriculum_id?: string | null;
}
export interface LookAtInvitation {
  token: string;
}
export interface InvitationGreeting {
  name: string;
  display_name: string;
  expires_utc: string;
}
export interface AcceptInvitation {
  token: string;
  password: string;
}
export interface Groups {
  groups: {
    name: string;
    people: number;
  }[];
}
export interface ImportPeople {
  /**
   * columns name, display_name and any of email, role, level, cases, groups (a|b), curriculum
   */
  csv: string;
  /**
   * import only: leave out the rows with a problem; without it one such row refuses all
   */
  skip_broken?: boolean;
  /**
   * import only: of the preview the administrator saw; conflict when the outcome would differ
   */
  preview_sha256?: string;
}
export interface ImportPreview {
  rows: ImportRow[];
  add: number;
  change: number;
  unchanged: number;
  broken: number;
  /**
   * of the file as a whole; nothing can be imported while there is one
   */
  problems: string[];
  /**
   * of the file and what would happen
   */
  sha256: string;
}
export interface ImportRow {
  /**
   * 1-based in the file
   */
  line: number;
  name: string;
  display_name: string;
  action: 'add' | 'change' | 'unchanged' | 'broken';
  /**
   * what will happen, or what is wrong and what to do
   */
  sentence: string;
}
export interface ImportResult {
  added: number;
  changed: number;
  unchanged: number;
  skipped: number;
  invitations: Invitation[];
}
export interface Curricula {
  curricula: CurriculumRow[];
}
export interface CurriculumRow {
  id: string;
  title: string;
  /**
   * comes with the program and is copied to be changed
   */
  built_in: boolean;
  /**
   * who is assigned nothing else trains by it
   */
  is_default: boolean;
  /**
   * who train by it
   */
  people: number;
  published_version: string | null;
  draft: DraftRow | null;
  /**
   * newest first
   */
  versions: CurriculumVersionRow[];
}
export interface DraftRow {
  /**
   * as its text says; may be empty while it is broken
   */
  version: string;
  saved_utc: string;
  saved_by: string;
  errors: number;
  warnings: number;
}
export interface CurriculumVersionRow {
  version: string;
  status: 'draft' | 'published' | 'retired';
  published_utc: string | null;
  sha256: string;
  exercises: number;
  /**
   * made under this version
   */
  trials: number;
}
export interface CurriculumText {
  id: string;
  title: string;
  version: string;
  status: 'draft' | 'published' | 'retired';
  built_in: boolean;
  yaml: string;
  sha256: string;
  saved_utc: string | null;
  saved_by: string;
  check: CurriculumCheck;
}
export interface CurriculumCheck {
  /**
   * could be published
   */
  ok: boolean;
  errors: number;
  warnings: number;
  /**
   * by line
   */
  problems: CurriculumProblem[];
  /**
   * of the text checked
   */
  sha256: string;
  /**
   * empty while there are errors
   */
  outline: ExerciseOutline[];
}
export interface CurriculumProblem {
  severity: 'error' | 'warning';
  line: number;
  column: number;
  message: string;
  repair: null | {
    title: string;
    line: number;
    before: string;
    after: string;
  };
}
export interface ExerciseOutline {
  exercise_id: string;
  version: number;
  title: string;
  line: number;
  briefing: Briefing;
}
export interface CheckCurriculum {
  yaml: string;
  /**
   * dry run only: this one; all when absent
   */
  exercise_id?: string;
  /**
   * dry run only: per skill and exercise, 5 when absent
   */
  trials?: number;
}
export interface CopyCurriculum {
  from_id: string;
  from_version: string;
  /**
   * the same id begins the next version of one's own curriculum
   */
  new_id: string;
}
export interface SaveDraft {
  yaml: string;
  /**
   * conflict when somebody else saved in between
   */
  replaces_sha256: string;
}
export interface PublishDraft {
  /**
   * of the draft as seen
   */
  sha256: string;
}
export interface RetireCurriculum {
  version: string;
}
export interface DefaultCurriculum {
  curriculum_id: string;
}
export interface CurriculumDiff {
  from: string;
  to: string;
  needed_bump: 'none' | 'patch' | 'minor' | 'major';
  changes: {
    weight: 'patch' | 'minor' | 'major';
    exercise_id: string;
    sentence: string;
  }[];
  /**
   * the two texts side by side, unchanged lines far from a change left out
   */
  lines: {
    kind: 'same' | 'added' | 'removed' | 'gap';
    /**
     * line number, 0 when not there
     */
    before: number;
    after: number;
    text: string;
  }[];
}
export interface DryRun {
  id: string;
  state: 'waiting' | 'running' | 'done' | 'cancelled' | 'failed';
  fraction: number;
  /**
   * how far it is, or what it showed, or why it failed
   */
  sentence: string;
  yaml_sha256: string;
  started_utc: string;
  exercises: DryRunExercise[];
}
export interface DryRunExercise {
  exercise_id: string;
  title: string;
  sentence: string;
  /**
   * an expert finished all steps; null while unknown
   */
  feasible: boolean | null;
  skills: DryRunSkill[];
  /**
   * distribution of time, and of the highest force, by skill
   */
  charts: Chart[];
}
export interface DryRunSkill {
  skill: Level;
  done: number;
  planned: number;
  passed: number;
  completed: number;
  /**
   * of each trial
   */
  time_s: number[];
  force_max_n: number[];
  /**
   * the most frequent reason for not passing; empty when all passed
   */
  why_not: string;
}
export interface Catalogue {
  anatomies: {
    id: string;
    title: string;
    length_mm: number;
  }[];
  instruments: InstrumentInfo[];
  metrics: MetricInfo[];
}
export interface MetricInfo {
  id: string;
  version: number;
  title: string;
  unit: string;
  direction: Direction;
  definition: string;
}
export interface Metrics {
  metrics: MetricInfo[];
}
export interface Instruments {
  instruments: InstrumentDetail[];
}
export interface InstrumentDetail {
  info: InstrumentInfo;
  inner_diameter_mm: number;
  tip_shape: string;
  friction: number;
  /**
   * citation of the stiffness
   */
  source: string;
  sha256: string;
  /**
   * titles of exercises
   */
  used_by: string[];
  sections: {
    from_tip_mm: number;
    length_mm: number;
    bending_stiffness_n_mm2: number;
    twist_stiffness_n_mm2: number;
  }[];
  /**
   * stiffness over the length; tip shape to scale
   */
  charts: Chart[];
}
export interface System {
  versions: {
    what: string;
    version: string;
  }[];
  started_utc: string;
  storage: {
    what: string;
    bytes: number;
  }[];
  counts: {
    what: string;
    count: number;
  }[];
  running_trials: number;
  health: HealthRow[];
  /**
   * newest first
   */
  backups: BackupRow[];
}
export interface HealthRow {
  what: string;
  state: 'ok' | 'warn' | 'bad';
  sentence: string;
}
export interface BackupRow {
  name: string;
  bytes: number;
  made_utc: string;
  sha256: string;
}
export interface AuditLog {
  rows: {
    seq: number;
    utc: string;
    /**
     * display name where there is one
     */
    actor: string;
    action: string;
    object: string;
    hash: string;
  }[];
  more: boolean;
  intact: boolean;
  /**
   * the chain is whole, or the first row that is not
   */
  sentence: string;
}
export interface Cohort {
  /**
   * empty for all
   */
  group: string;
  groups: string[];
  /**
   * 2 of 9 need help: ...
   */
  headline: string;
  exercises: {
    exercise_id: string;
    title: string;
  }[];
  /**
   * who need help first
   */
  people: CohortRow[];
}
export interface CohortRow {
  person_id: string;
  display_name: string;
  level: Level | null;
  groups: string[];
  needs_help: boolean;
  /**
   * empty when no help is needed
   */
  why: string;
  trials: number;
  last_trial_utc: string | null;
  running_trial_id: string | null;
  /**
   * one per exercise, in their order; null where the person's curriculum has it not
   */
  cells: (null | {
    status: Status;
    sentence: string;
    trials: number;
  })[];
}
export interface LiveList {
  trials: {
    trial_id: string;
    person_id: string;
    person_name: string;
    exercise_id: string;
    exercise_title: string;
    ordinal: number;
    started_utc: string;
    device: string;
    paused: boolean;
    briefing: Briefing;
  }[];
}
export interface WriteComment {
  text: string;
  time_s: number | null;
}
export interface VoidTrial {
  reason: string;
}
export interface BeginPractice {
  exercise_id: string;
  device: string;
}
export interface PracticeResult {
  exercise_id: string;
  end_reason: EndReason;
  /**
   * what it would have been
   */
  verdict_sentence: string;
  criteria: CriterionResult[];
  metrics: MetricResult[];
}
export interface Settings {
  feed_mm_s: number;
  turn_deg_s: number;
  fine_fraction: number;
  force_unit: 'N' | 'gf';
  theme: 'auto' | 'light' | 'dark';
  /**
   * action -> KeyboardEvent.code; an action left out has its usual key
   */
  keys: {
    [k: string]: string;
  };
  tour_seen: boolean;
}
export interface ChangePassword {
  old_password: string;
  new_password: string;
}
export interface HandleMessage {
  type: 'handle';
  feed_mm_s: number;
  turn_deg_s: number;
  move_mm?: number;
  rotate_deg?: number;
}
export interface ControlMessage {
  type: 'pause' | 'resume' | 'end';
}
export interface PingMessage {
  type: 'ping';
  sent_ms: number;
}
