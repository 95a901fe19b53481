import {Button} from '@mantine/core';
import {Link} from 'wouter';
import {ChartView} from '../parts/ChartView';
import {EmptyState} from '../parts/EmptyState';
import {Icon} from '../parts/Icon';
import {Loaded} from '../parts/Loaded';
import {Panel} from '../parts/Panel';
import {lookOf} from '../parts/State';
import {TaskDrawing} from '../parts/TaskDrawing';
import {stateOfTrial, endWord} from '../parts/TrialTable';
import {useResource} from '../parts/api';
import {formatCount, formatDifference, formatDuration, formatValue, formatWhen, shortTitle, withoutTitle} from '../parts/format';
import {paths} from '../parts/paths';
import {useBeginTrial} from '../parts/use_begin_trial';
import {useTitle} from '../parts/use_title';
import type {BegunTrial, ExerciseCard, NextExercise, PlanBlock, Training as TrainingData, TrialRow} from '../wire/types';
import styles from './training.module.css';

/** What do I do next? */
export function Training() {
  useTitle('My training');
  const resource = useResource('training', async (api) => {
    const [training, mine] = await Promise.all([api.training(), api.liveMine()]);
    return {training, running: mine.trial};
  });
  return (
    <Loaded resource={resource} what="your training">
      {({training, running}) => (
        <>
          <div className="page-head">
            <h1>My training</h1>
            <span className="muted">{training.curriculum_title} {training.curriculum_version}</span>
            <span className="grow" />
            <span className="small muted num">
              {training.proficient_count} of {formatCount(training.exercise_count, 'exercise')} proficient
            </span>
          </div>
          <div className="stack">
            <Next next={training.next} running={running} />
            <Plan training={training} />
            {training.next && <Results next={training.next} />}
          </div>
        </>
      )}
    </Loaded>
  );
}

function Next({next, running}: {next: NextExercise | null; running: BegunTrial | null}) {
  if (running) {
    return (
      <section className={`panel ${styles.next}`} aria-label="Running trial">
        <div>
          <span className={styles.eyebrow}>Still running</span>
          <h2>{running.briefing.title}, trial {running.ordinal}</h2>
          <p className={styles.why}>The simulation is paused and waits for you.</p>
        </div>
        <TaskDrawing steps={running.briefing.steps} />
        <div className={styles.go}>
          <Button component={Link} href={paths.console(running.trial_id)} size="md" fullWidth>Continue</Button>
        </div>
      </section>
    );
  }
  if (!next) {
    return (
      <section className={`panel ${styles.done}`} aria-label="Next exercise">
        <EmptyState title="Nothing is due">Every exercise of your plan is proficient, waived or locked. The plan below says which.</EmptyState>
      </section>
    );
  }
  return <NextPanel next={next} />;
}

function NextPanel({next}: {next: NextExercise}) {
  const {begin, busy, problem} = useBeginTrial();
  const {briefing} = next;
  return (
    <section className={`panel ${styles.next}`} aria-label="Next exercise">
      <div>
        <span className={styles.eyebrow}>Next exercise</span>
        <h2>{briefing.title}</h2>
        <p className={`num ${styles.why}`}>{withoutTitle(next.headline, briefing.title)}</p>
      </div>
      <TaskDrawing steps={briefing.steps} />
      <div className={styles.go}>
        <Button size="md" fullWidth loading={busy} disabled={!briefing.can_start} onClick={() => begin(briefing.exercise_id)}>
          Start
        </Button>
        <div className="xs muted num">
          {briefing.can_start
            ? <p>Trial {next.ordinal}, at most {formatDuration(briefing.time_limit_s)}. By keyboard or mouse.</p>
            : <p>{briefing.status_sentence}</p>}
          <p><Link className={styles.target} href={paths.briefing(briefing.exercise_id)}>Read the briefing</Link></p>
        </div>
        {problem && <p className="small tone-bad" role="alert">{problem.message}</p>}
      </div>
    </section>
  );
}

function Plan({training}: {training: TrainingData}) {
  const nextId = training.next?.briefing.exercise_id;
  const aside = training.max_trials_per_day > 0
    ? `At most ${formatCount(training.max_trials_per_day, 'trial')} a day, ${training.trials_today} done today`
    : `${formatCount(training.trials_today, 'trial')} today`;
  return (
    <Panel title="Plan" aside={aside}>
      {training.blocks.length === 0
        ? <EmptyState title="No plan yet">Ask your instructor to enrol you in a curriculum.</EmptyState>
        : (
          <ol className={styles.plan}>
            {training.blocks.map((block) => <Block key={block.id} block={block} nextId={nextId} />)}
          </ol>
        )}
    </Panel>
  );
}

function Block({block, nextId}: {block: PlanBlock; nextId: string | undefined}) {
  const order = block.after === '' ? (block.any_order ? 'any order' : '') : `after ${block.after}`;
  return (
    <li className={styles.block}>
      <h3>{block.title} <span>{order}</span></h3>
      <ol>
        {block.exercises.map((card) => <Station key={card.exercise_id} card={card} next={card.exercise_id === nextId} />)}
      </ol>
    </li>
  );
}

function Station({card, next}: {card: ExerciseCard; next: boolean}) {
  const look = lookOf(card.status);
  const tone = next ? 'now' : look.tone;
  return (
    <li className={`${styles.station} ${styles[tone] ?? ''}`} aria-current={next ? 'step' : undefined}>
      <span className={`${styles.sign} tone-${tone}`}><Icon name={card.status === 'proficient' ? 'tick' : look.icon} /></span>
      <Link className="strong" href={paths.briefing(card.exercise_id)}>{shortTitle(card.title)}</Link>
      <span className={`state tone-${tone}`}>{look.word}{next ? ', next' : ''}</span>
      <span className="xs faint num">{card.sentence}</span>
    </li>
  );
}

function Results({next}: {next: NextExercise}) {
  const target = next.briefing.targets.find((bound) => bound.metric === 'time_s');
  const name = shortTitle(next.briefing.title);
  const aside = target ? `${name}, target ${formatValue(target.value, target.unit)}` : name;
  return (
    <div className={next.chart ? styles.two : undefined}>
      <Panel title="Last results" aside={aside}>
        {next.last_trials.length === 0
          ? <EmptyState title="No trial yet">Your first result appears here when you have done this exercise once.</EmptyState>
          : <LastTrials trials={next.last_trials} />}
      </Panel>
      {next.chart && <section className="panel"><ChartView chart={next.chart} /></section>}
    </div>
  );
}

function LastTrials({trials}: {trials: TrialRow[]}) {
  const rows = [...trials].sort((a, b) => b.ordinal - a.ordinal);
  const top = Math.max(...rows.flatMap((trial) => [trial.time_s ?? 0, trial.target_s ?? 0])) * 1.1;
  const judged = rows.some((trial) => trial.target_s !== null);
  return (
    <div className="table-scroll">
      <table className={`table ${styles.results}`}>
        <thead>
          <tr>
            <th scope="col" className="r">Trial</th>
            <th scope="col">When</th>
            <th scope="col" className="r">Time</th>
            <th scope="col"><span className="visually-hidden">Time as a bar</span></th>
            {judged && <th scope="col" className="r">Against target</th>}
            <th scope="col">Result</th>
            <th scope="col"><span className="visually-hidden">Debrief</span></th>
          </tr>
        </thead>
        <tbody>
          {rows.map((trial) => (
            <tr key={trial.trial_id}>
              <td className="r">{trial.ordinal}</td>
              <td className="muted">{formatWhen(trial.started_utc)}</td>
              <td className="r strong">{formatValue(trial.time_s, 's')}</td>
              <td>{trial.time_s !== null && <TimeBar time={trial.time_s} target={trial.target_s} top={top} />}</td>
              {judged && (
                <td className="r">
                  {trial.time_s !== null && trial.target_s !== null ? formatDifference(trial.time_s - trial.target_s, 's') : '–'}
                </td>
              )}
              <td><Result trial={trial} /></td>
              <td className="r">
                <Link href={paths.debrief(trial.trial_id)}>Debrief<span className="visually-hidden"> of trial {trial.ordinal}</span></Link>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Result({trial}: {trial: TrialRow}) {
  const look = lookOf(stateOfTrial(trial));
  return (
    <span className={`state tone-${look.tone}`} title={endWord(trial)}><Icon name={look.icon} /><span>{look.word}</span></span>
  );
}

function TimeBar({time, target, top}: {time: number; target: number | null; top: number}) {
  const width = 180;
  const x = (value: number) => 4 + (value / top) * (width - 10);
  const from = target === null ? x(0) : Math.min(x(target), x(time));
  const to = target === null ? x(time) : Math.max(x(target), x(time));
  return (
    <svg width={width} height="22" viewBox={`0 0 ${width} 22`} aria-hidden="true">
      <rect x="0" y="9" width={width} height="4" rx="2" fill="var(--surface-3)" />
      <rect x={from} y="9" width={to - from} height="4" fill="var(--text-3)" />
      {target !== null && <line x1={x(target)} x2={x(target)} y1="2" y2="20" stroke="var(--target)" strokeWidth="2" />}
      <circle cx={x(time)} cy="11" r="5" fill="var(--you)" />
    </svg>
  );
}
