import type {Outcome, Status} from '../wire/types';
import {Icon, type IconName} from './Icon';

export type StateName = Status | Outcome | 'met' | 'not_met' | 'voided' | 'running' | 'critical' | 'fail' | 'mark' | 'info'
  | 'ok' | 'warn' | 'bad' | 'add' | 'change' | 'unchanged' | 'broken' | 'active' | 'invited' | 'disabled' | 'needs_help' | 'paused';
export type Tone = 'ok' | 'warn' | 'bad' | 'idle' | 'now';

interface Look {
  icon: IconName;
  word: string;
  /** where the whole word has no room; the place says the whole word another way */
  short?: string;
  tone: Tone;
}

const looks: Readonly<Record<StateName, Look>> = {
  proficient: {icon: 'ring_tick', word: 'Proficient', tone: 'ok'},
  in_progress: {icon: 'half', word: 'In progress', tone: 'now'},
  practised: {icon: 'half', word: 'Practised', tone: 'now'},
  available: {icon: 'circle', word: 'Available', tone: 'idle'},
  locked: {icon: 'padlock', word: 'Locked', tone: 'idle'},
  lapsed: {icon: 'triangle', word: 'Lapsed, retention failed', short: 'Lapsed', tone: 'warn'},
  exhausted: {icon: 'triangle', word: 'Exhausted, ask your instructor', short: 'Exhausted', tone: 'warn'},
  waived: {icon: 'dash', word: 'Waived', tone: 'idle'},
  passed: {icon: 'tick', word: 'Passed', tone: 'ok'},
  not_passed: {icon: 'cross', word: 'Not passed', tone: 'bad'},
  invalid: {icon: 'dash', word: 'Not counted', tone: 'idle'},
  met: {icon: 'tick', word: 'Met', tone: 'ok'},
  not_met: {icon: 'cross', word: 'Not met', tone: 'bad'},
  voided: {icon: 'dash', word: 'Voided', tone: 'idle'},
  running: {icon: 'half', word: 'Running', tone: 'now'},
  critical: {icon: 'octagon', word: 'Critical error', tone: 'bad'},
  fail: {icon: 'cross', word: 'Fails the trial', tone: 'bad'},
  mark: {icon: 'triangle', word: 'Noted', tone: 'warn'},
  info: {icon: 'info', word: 'Event', tone: 'idle'},
  needs_help: {icon: 'triangle', word: 'Needs help', tone: 'warn'},
  paused: {icon: 'pause', word: 'Paused', tone: 'idle'},
  // health of the system
  ok: {icon: 'tick', word: 'Well', tone: 'ok'},
  warn: {icon: 'triangle', word: 'Look at it', tone: 'warn'},
  bad: {icon: 'octagon', word: 'Broken', tone: 'bad'},
  // rows of an import
  add: {icon: 'plus', word: 'Add', tone: 'now'},
  change: {icon: 'half', word: 'Change', tone: 'now'},
  unchanged: {icon: 'dash', word: 'Unchanged', tone: 'idle'},
  broken: {icon: 'octagon', word: 'Left out', tone: 'bad'},
  // people
  active: {icon: 'ring_tick', word: 'Active', tone: 'ok'},
  invited: {icon: 'circle', word: 'Invited', tone: 'now'},
  disabled: {icon: 'padlock', word: 'Disabled', tone: 'idle'},
};

/** Sign, word, colour of a state, for the few places that lay them out apart. */
export function lookOf(state: StateName): Look {
  return looks[state];
}

interface Props {
  state: StateName;
  /** inline: a word in a line; short: the same with its short word; stacked: sign over short word, for narrow columns. */
  form?: 'inline' | 'short' | 'stacked';
}

/** The only place that colours a state: a sign and a word carry it, the colour repeats it. */
export function State({state, form = 'inline'}: Props) {
  const look = looks[state];
  const word = form === 'inline' ? look.word : look.short ?? look.word;
  return (
    <span className={`${form === 'stacked' ? 'state-stacked' : 'state'} tone-${look.tone}`}><Icon name={look.icon} /><span>{word}</span></span>
  );
}
