import {Button} from '@mantine/core';
import {Link} from 'wouter';
import {Loaded} from '../parts/Loaded';
import {Panel} from '../parts/Panel';
import {State} from '../parts/State';
import {TaskDrawing} from '../parts/TaskDrawing';
import {useResource, useSignedIn} from '../parts/api';
import {formatBound, formatDuration, formatValue} from '../parts/format';
import {navigationOf, paths} from '../parts/paths';
import {useBeginTrial} from '../parts/use_begin_trial';
import {useTitle} from '../parts/use_title';
import type {Briefing as BriefingData, LimitInfo, StepInfo} from '../wire/types';
import styles from './briefing.module.css';

/** What to do, within which limits, and how it is judged. */
export function Briefing({exerciseId}: {exerciseId: string}) {
  const resource = useResource(`briefing ${exerciseId}`, (api) => api.briefing(exerciseId));
  return <Loaded resource={resource} what="the briefing">{(briefing) => <Page briefing={briefing} />}</Loaded>;
}

function Page({briefing}: {briefing: BriefingData}) {
  useTitle(`Briefing: ${briefing.title}`);
  const {session} = useSignedIn();
  const home = navigationOf(session.role)[0];
  return (
    <>
      <nav className="crumbs" aria-label="Breadcrumb">
        <ol><li>{home && <Link href={home.path}>{home.label}</Link>}</li><li aria-hidden="true">/</li><li>Briefing</li></ol>
      </nav>
      <section className={`panel ${styles.head}`} aria-label="Exercise">
        <div>
          <h1>{briefing.title}</h1>
          <p className={styles.goal}>{briefing.goal}</p>
          <p className={styles.status}><State state={briefing.status} /><span className="small muted">{briefing.status_sentence}</span></p>
        </div>
        <TaskDrawing steps={briefing.steps} />
        {session.role === 'trainee' && <Start briefing={briefing} />}
      </section>
      <div className={styles.columns}>
        <div className="stack">
          <Panel title="Steps" aside={`At most ${formatDuration(briefing.time_limit_s)}`}><Steps steps={briefing.steps} /></Panel>
        </div>
        <div className="stack">
          <Panel title="How it is judged" aside={`Version ${briefing.version}`}><Judgement briefing={briefing} /></Panel>
          <Panel title="Limits"><Limits limits={briefing.limits} /></Panel>
          <Panel title="Instrument and anatomy">
            <dl className={styles.facts}>
              <dt>{briefing.instrument.kind === 'guidewire' ? 'Guidewire' : 'Catheter'}</dt>
              <dd>
                {briefing.instrument.title}, {formatValue(briefing.instrument.outer_diameter_mm, 'mm')} across,{' '}
                {formatValue(briefing.instrument.length_mm, 'mm')} long
              </dd>
              <dt>Anatomy</dt>
              <dd>{briefing.anatomy_title}</dd>
              <dt>Hands</dt>
              <dd>Keyboard or mouse. <Link href={paths.controls}>See the controls</Link></dd>
            </dl>
          </Panel>
        </div>
      </div>
    </>
  );
}

function Start({briefing}: {briefing: BriefingData}) {
  const {begin, busy, problem} = useBeginTrial();
  return (
    <div className={styles.go}>
      <Button size="md" fullWidth loading={busy} disabled={!briefing.can_start} onClick={() => begin(briefing.exercise_id)}>Start</Button>
      {!briefing.can_start && <p className="xs muted">{briefing.status_sentence}</p>}
      {problem && <p className="small tone-bad" role="alert">{problem.message}</p>}
    </div>
  );
}

function Steps({steps}: {steps: StepInfo[]}) {
  return (
    <ol className={styles.steps}>
      {steps.map((step, index) => (
        <li key={step.id + String(index)}>
          <span className={styles.number} aria-hidden="true">{index + 1}</span>
          <span className="strong">{step.title}</span>
          <span className="small muted num">{stepDetail(step)}</span>
        </li>
      ))}
    </ol>
  );
}

function stepDetail(step: StepInfo): string {
  const parts: string[] = [];
  if (step.kind === 'hold') parts.push(`keep still for ${formatValue(step.target, step.unit)}`);
  else parts.push(`within ${formatValue(step.tolerance, step.unit)}`);
  if (step.kind !== 'hold' && step.hold_s > 0) parts.push(`hold for ${formatValue(step.hold_s, 's')}`);
  if (step.rounds > 1 && step.round > 0) parts.push(`round ${step.round} of ${step.rounds}`);
  return parts.join(', ');
}

function Judgement({briefing}: {briefing: BriefingData}) {
  return (
    <>
      <p className={styles.pass}>{briefing.pass_sentence}</p>
      {briefing.targets.length > 0 && (
        <dl className={styles.facts}>
          {briefing.targets.map((target) => (
            <div key={target.metric} className={styles.target}>
              <dt className="num strong">{formatBound(target.op, target.value, target.unit)}</dt>
              <dd className="small muted">{target.reason}{target.provisional ? ' Provisional: too few experts yet.' : ''}</dd>
            </div>
          ))}
        </dl>
      )}
    </>
  );
}

const consequences: Readonly<Record<LimitInfo['on_breach'], string>> = {
  mark: 'is noted', fail: 'fails the trial', critical_error: 'is a critical error', stop: 'stops the trial',
};

function Limits({limits}: {limits: LimitInfo[]}) {
  if (limits.length === 0) return <p className="muted">This exercise sets no limits on force.</p>;
  return (
    <>
      <table className="table">
        <thead><tr><th scope="col">Limit</th><th scope="col" className="r">Value</th><th scope="col">Beyond it</th></tr></thead>
        <tbody>
          {limits.map((limit) => (
            <tr key={limit.metric}>
              <td>{limit.title}</td>
              <td className="r strong">{formatBound(limit.op, limit.value, limit.unit)}</td>
              <td className="muted">{consequences[limit.on_breach]}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p className="xs faint">Simulated force. Training values, not clinical.</p>
    </>
  );
}
