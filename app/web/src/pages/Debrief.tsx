import {Button} from '@mantine/core';
import {useState} from 'react';
import {Link} from 'wouter';
import {ChartView} from '../parts/ChartView';
import {EmptyState} from '../parts/EmptyState';
import {Icon} from '../parts/Icon';
import {Loaded} from '../parts/Loaded';
import {Panel} from '../parts/Panel';
import {lookOf, State} from '../parts/State';
import {endWord, sourceWord, stateOfTrial} from '../parts/TrialTable';
import {useResource, useSignedIn} from '../parts/api';
import {digitsToTellApart, formatBound, formatClock, formatValue, formatWhen, shortTitle} from '../parts/format';
import {paths} from '../parts/paths';
import {useBeginTrial} from '../parts/use_begin_trial';
import {useTitle} from '../parts/use_title';
import type {CriterionResult, Debrief as DebriefData, EventRow, MetricResult} from '../wire/types';
import {Comments} from './debrief/Comments';
import {VoidedBanner, VoidTrial} from './debrief/Voiding';
import styles from './debrief.module.css';

const stepChart = 'step-times';

/** Did I pass, and by which rule? */
export function Debrief({trialId}: {trialId: string}) {
  const resource = useResource(`trial ${trialId}`, (api) => api.trial(trialId));
  return <Loaded resource={resource} what="the debrief">{(debrief) => <Page loaded={debrief} />}</Loaded>;
}

function Page({loaded}: {loaded: DebriefData}) {
  // as the server answered last: a comment or voiding changes it
  const [debrief, setDebrief] = useState(loaded);
  const {trial} = debrief;
  useTitle(`${debrief.exercise_title}, trial ${trial.ordinal}`);
  const {session} = useSignedIn();
  const own = session.role === 'trainee';
  const steps = debrief.charts.find((chart) => chart.id === stepChart);
  const others = debrief.charts.filter((chart) => chart.id !== stepChart);
  return (
    <>
      <nav className="crumbs" aria-label="Breadcrumb">
        <ol>
          <li>{own ? <Link href={paths.training}>My training</Link> : <Link href={paths.people}>People</Link>}</li>
          <li aria-hidden="true">/</li>
          <li>{own ? <Link href={paths.briefing(trial.exercise_id)}>{shortTitle(debrief.exercise_title)}</Link> : debrief.person_name}</li>
          <li aria-hidden="true">/</li>
          <li className="num">{own ? '' : `${shortTitle(debrief.exercise_title)}, `}Trial {trial.ordinal}, {formatWhen(trial.started_utc)}</li>
        </ol>
      </nav>
      <div className="stack">
        <VoidedBanner debrief={debrief} />
        <Verdict debrief={debrief} own={own} onChange={setDebrief} />
        <div className={steps ? styles.duo : undefined}>
          <Criteria debrief={debrief} />
          {steps && <section className="panel"><ChartView chart={steps} /></section>}
        </div>
        <Comments debrief={debrief} onChange={setDebrief} />
        <div className={others.length > 0 ? styles.force : undefined}>
          {others.map((chart) => <section key={chart.id} className="panel"><ChartView chart={chart} /></section>)}
          <Events events={debrief.events} />
        </div>
        <Measurements metrics={debrief.metrics} />
        <Provenance debrief={debrief} />
      </div>
    </>
  );
}

function Verdict({debrief, own, onChange}: {debrief: DebriefData; own: boolean; onChange: (debrief: DebriefData) => void}) {
  const {trial} = debrief;
  const look = lookOf(stateOfTrial(trial));
  const {begin, busy, problem} = useBeginTrial();
  return (
    <section className={`panel ${styles.verdict}`} aria-label="Verdict">
      <div className={styles.result}>
        <span className={`${styles.sign} ${styles[look.tone] ?? ''} tone-${look.tone}`}><Icon name={look.icon} /></span>
        <div>
          <h1>{look.word}</h1>
          <p className="muted num">{debrief.verdict_sentence}</p>
        </div>
      </div>
      <div className={`num ${styles.rule}`}>
        <p className="strong">Rule</p>
        <p className="muted">{debrief.rule_sentence} {shortTitle(debrief.exercise_title)}, version {debrief.exercise_version}.</p>
      </div>
      {own && (
        <div className={styles.again}>
          <Button loading={busy} onClick={() => begin(trial.exercise_id)}>Try again</Button>
          {problem && <p className="small tone-bad" role="alert">{problem.message}</p>}
        </div>
      )}
      {!own && <div className={styles.again}><VoidTrial debrief={debrief} onChange={onChange} /></div>}
      <p className={`small muted num ${styles.progress}`}><State state={debrief.status} /><span>{debrief.progress_sentence}</span></p>
    </section>
  );
}

function Criteria({debrief}: {debrief: DebriefData}) {
  const {criteria, trial} = debrief;
  const met = criteria.filter((criterion) => criterion.met).length;
  return (
    <Panel title="Criteria" aside={criteria.length === 0 ? undefined : `${met} of ${criteria.length} met`}>
      {criteria.length === 0
        ? <EmptyState title="Not judged">{endWord(trial)}: this trial was not judged, so it counts neither for nor against you.</EmptyState>
        : (
          <div className="table-scroll">
            <table className="table">
              <thead>
                <tr><th scope="col">Result</th><th scope="col">Criterion</th><th scope="col" className="r">You</th><th scope="col" className="r">Needed</th></tr>
              </thead>
              <tbody>{criteria.map((criterion) => <CriterionRow key={criterion.subject} criterion={criterion} />)}</tbody>
            </table>
          </div>
        )}
    </Panel>
  );
}

function CriterionRow({criterion}: {criterion: CriterionResult}) {
  const digits = digitsToTellApart(criterion.value, criterion.needed, criterion.unit);
  return (
    <tr>
      <td><State state={criterion.met ? 'met' : 'not_met'} /></td>
      <td>
        {criterion.title}
        <div className="xs faint">{criterion.note}{criterion.provisional ? ' Provisional target.' : ''}</div>
      </td>
      <td className="r strong">{formatValue(criterion.value, criterion.unit, digits)}</td>
      <td className="r muted">{formatBound(criterion.op, criterion.needed, criterion.unit, digits)}</td>
    </tr>
  );
}

function Events({events}: {events: EventRow[]}) {
  return (
    <Panel title="Events" aside={String(events.length)}>
      {events.length === 0
        ? <EmptyState title="No event">Nothing was noted between the first motion and the end.</EmptyState>
        : (
          <div className={styles.scroll} role="region" aria-label="All events" tabIndex={0}>
            <table className="table">
              <thead><tr><th scope="col" className="r">At</th><th scope="col">Weight</th><th scope="col">What happened</th></tr></thead>
              <tbody>
                {events.map((event, index) => (
                  <tr key={index}>
                    <td className="r">{formatClock(event.time_s)}</td>
                    <td><State state={event.severity} /></td>
                    <td>{event.text}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        )}
    </Panel>
  );
}

function Measurements({metrics}: {metrics: MetricResult[]}) {
  return (
    <Panel title="Measurements" aside="Forces are simulated; training values, not clinical">
      {metrics.length === 0
        ? <EmptyState title="Nothing measured">The trial ended before there was anything to measure.</EmptyState>
        : (
          <dl className={styles.metrics}>
            {metrics.map((metric) => (
              <div key={metric.id}>
                <dt className="xs faint">{metric.title}</dt>
                <dd className="strong num">{formatValue(metric.value, metric.unit)}</dd>
                <dd className="xs faint">{metric.definition} {metric.direction === 'lower' ? 'Lower' : 'Higher'} is better.</dd>
              </div>
            ))}
          </dl>
        )}
    </Panel>
  );
}

function Provenance({debrief}: {debrief: DebriefData}) {
  const {trial} = debrief;
  const facts = [
    `${sourceWord(trial.source)}, by ${trial.device}`,
    `${endWord(trial)}${trial.interrupted ? ', with an interruption' : ''}`,
    debrief.paused_s > 0 ? `paused for ${formatValue(debrief.paused_s, 's')}` : '',
    debrief.slowed_s > 0 ? `the simulation fell behind the clock by ${formatValue(debrief.slowed_s, 's')}` : '',
    `build ${debrief.build}`,
  ].filter((fact) => fact !== '');
  return (
    <footer className={`xs faint num ${styles.provenance}`}>
      <p>{facts.join(' · ')}</p>
      <p>Trial <span className="mono">{trial.trial_id}</span>, final state <span className="mono">{debrief.state_hash}</span></p>
    </footer>
  );
}
