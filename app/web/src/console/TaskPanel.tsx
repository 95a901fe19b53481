import {formatClock} from '../parts/format';
import {Icon} from '../parts/Icon';
import type {Frame} from '../wire/frame';
import type {Briefing, StepInfo} from '../wire/types';
import {LevelWord} from './LevelWord';
import {type LimitReading, nearLimit, readLimits, readStep, visibleSteps} from './readings';
import styles from './TaskPanel.module.css';

interface Props {
  briefing: Briefing;
  frame: Frame;
  done_s: readonly (number | null)[];
}

const listRows = 4;

/** Time, the step at hand with its bar, the steps around it, the limits as counters. */
export function TaskPanel({briefing, frame, done_s}: Props) {
  const {steps} = briefing;
  const current = Math.min(frame.step_index, steps.length);
  const {first, last} = visibleSteps(steps.length, current, listRows);
  return (
    <section className={styles.panel} aria-label="Task">
      <Clock briefing={briefing} frame={frame} current={current} />
      <ol className={styles.steps} start={first + 1} data-rows={Math.min(listRows, steps.length)}>
        {steps.slice(first, last).map((step, row) => {
          const index = first + row;
          if (index < current) return <DoneStep key={index} step={step} done_s={done_s[index] ?? null} />;
          if (index === current) return <CurrentStep key={index} step={step} number={index + 1} frame={frame} />;
          return <NextStep key={index} step={step} number={index + 1} />;
        })}
      </ol>
      <Limits rows={readLimits(briefing, frame)} />
      <p className={styles.times}>
        {frame.paused_s >= 1 && <span>Paused {formatClock(frame.paused_s)} so far. </span>}
        {frame.slowed_s >= 0.5 && <span>The simulation ran {frame.slowed_s.toFixed(1)} s behind the clock.</span>}
      </p>
    </section>
  );
}

function Clock({briefing, frame, current}: {briefing: Briefing; frame: Frame; current: number}) {
  const {steps, time_limit_s} = briefing;
  const step = steps[Math.min(current, steps.length - 1)];
  const near = time_limit_s > 0 && frame.elapsed_s >= nearLimit * time_limit_s;
  return (
    <div className={styles.clock}>
      <b data-testid="trial-clock" data-value={frame.elapsed_s.toFixed(3)}>{formatClock(frame.elapsed_s)}</b>
      {time_limit_s > 0 && <span className={styles.of}>of {formatClock(time_limit_s)}</span>}
      <LevelWord level={near ? 'near' : 'ok'} />
      <span className={styles.where}>
        {current < steps.length ? `Step ${current + 1} of ${steps.length}` : `${steps.length} of ${steps.length} done`}
        {step && step.round > 0 && current < steps.length && <span>Round {step.round} of {step.rounds}</span>}
      </span>
    </div>
  );
}

function DoneStep({step, done_s}: {step: StepInfo; done_s: number | null}) {
  return (
    <li className={styles.done}>
      <span className={styles.number}><Icon name="tick" /></span>
      <b>{step.title}</b>
      <span className={styles.value}>Done{done_s !== null && ` ${formatClock(done_s)}`}</span>
    </li>
  );
}

function NextStep({step, number}: {step: StepInfo; number: number}) {
  return (
    <li className={styles.next}>
      <span className={styles.number}>{number}</span>
      <b>{step.title}</b>
    </li>
  );
}

const percent = (part: number) => `${(part * 100).toFixed(2)}%`;

function CurrentStep({step, number, frame}: {step: StepInfo; number: number; frame: Frame}) {
  const reading = readStep(step, frame);
  return (
    <li className={styles.now} aria-current="step">
      <span className={styles.number}>{number}</span>
      <b data-testid="step-title">{reading.title}</b>
      <span className={styles.value} data-testid="step-value" data-value={reading.raw.toFixed(3)}>{reading.value}</span>
      <div className={styles.bar} data-ask={reading.ask}>
        <i className={styles.fill} style={{width: percent(reading.fraction)}} />
        <i className={styles.tolerance} style={{left: percent(reading.goalLow), width: percent(reading.goalHigh - reading.goalLow)}} />
        <i className={styles.goal} style={{left: percent(reading.goal)}} />
      </div>
      <span className={styles.ask} data-testid="step-state" data-state={reading.ask}>{reading.sentence}</span>
      <span className={styles.hold} aria-hidden="true">
        {reading.held !== null && <i style={{width: percent(reading.held)}} />}
      </span>
    </li>
  );
}

function Limits({rows}: {rows: LimitReading[]}) {
  if (rows.length === 0) return <p className={styles.noLimits}>This exercise sets no limits besides the time.</p>;
  return (
    <div className={styles.limits}>
      <div className={styles.limitsHead}><span>Limits</span><span>If exceeded</span></div>
      <ul>
        {rows.map((row) => (
          <li key={row.title} data-level={row.level}>
            <span className={styles.limitName}>{row.title}</span>
            <span className={styles.limitValue}><b>{row.value}</b> of {row.bound}</span>
            <span className={styles.limitBar}><i style={{width: percent(row.fraction)}} /></span>
            <span className={styles.consequence}>
              {row.level === 'ok' ? row.consequence : <LevelWord level={row.level} over="exceeded" />}
            </span>
          </li>
        ))}
      </ul>
    </div>
  );
}
