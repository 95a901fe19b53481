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
      type: 'filed';
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
  ordinal: number;
  briefing: Briefing;
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
}
export interface ExerciseProgress {
  exercise_id: string;
  title: string;
  status: Status;
  headline: string;
  charts: Chart[];
  trials: TrialRow[];
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
