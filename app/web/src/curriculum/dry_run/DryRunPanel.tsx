import {Button, NativeSelect, Progress} from '@mantine/core';
import {useEffect, useState} from 'react';
import {ChartView} from '../../parts/ChartView';
import {Icon} from '../../parts/Icon';
import {Problem} from '../../parts/Problem';
import {useSignedIn} from '../../parts/api';
import {formatValue, formatWhen} from '../../parts/format';
import {useAction} from '../../parts/use_action';
import type {DryRun, DryRunExercise, DryRunSkill} from '../../wire/types';
import styles from './dry_run.module.css';

interface Props {
  curriculumId: string;
  yaml: string;
  /** Of the text in the editor; empty while it is being checked. */
  sha256: string;
  /** Why it cannot run now; empty when it can. */
  obstacle: string;
  exercises: readonly {id: string; title: string}[];
  onClose: () => void;
}

const poll_ms = 1000;

/** What simulated operators of three skills make of the text. */
export function DryRunPanel({curriculumId, yaml, sha256, obstacle, exercises, onClose}: Props) {
  const {api} = useSignedIn();
  const key = `cathedra.dry-run.${curriculumId}`;
  const [id, setId] = useState(() => sessionStorage.getItem(key) ?? '');
  const [run, setRun] = useState<DryRun | null>(null);
  const [lost, setLost] = useState('');
  const [exercise, setExercise] = useState('');
  const [trials, setTrials] = useState('5');
  const start = useAction();
  const over = run !== null && run.id === id && run.state !== 'waiting' && run.state !== 'running';
  useEffect(() => {
    if (id === '' || over) return undefined;
    let stale = false;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const ask = () => {
      api.dryRun(id).then(
        (answer) => {
          if (stale) return;
          setRun(answer);
          setLost('');
          timer = setTimeout(ask, poll_ms);
        },
        (reason: unknown) => {
          if (stale) return;
          setLost(reason instanceof Error ? reason.message : String(reason));
          timer = setTimeout(ask, 5 * poll_ms);
        });
    };
    ask();
    return () => {
      stale = true;
      clearTimeout(timer);
    };
  }, [api, id, over]);
  const begin = () => start.run(
    () => api.startDryRun({yaml, trials: Number(trials), ...(exercise === '' ? {} : {exercise_id: exercise})}),
    (answer) => {
      sessionStorage.setItem(key, answer.id);
      setRun(answer);
      setLost('');
      setId(answer.id);
    });
  const running = id !== '' && !over && run !== null;
  return (
    <section className={styles.panel} aria-label="Dry run">
      <div className={styles.head}>
        <h2>Dry run</h2>
        <NativeSelect aria-label="Exercise to run" value={exercise} onChange={(event) => setExercise(event.currentTarget.value)}
          data={[{value: '', label: 'All exercises'}, ...exercises.map((one) => ({value: one.id, label: one.title}))]} />
        <NativeSelect aria-label="Trials per skill" value={trials} onChange={(event) => setTrials(event.currentTarget.value)}
          data={['1', '3', '5', '10', '20', '50'].map((value) => ({value, label: `${value} per skill`}))} />
        {running
          ? <Button variant="default" onClick={() => { void api.cancelDryRun(id).catch((reason: unknown) => setLost(String(reason))); }}>Cancel</Button>
          : <Button variant="default" loading={start.busy} disabled={obstacle !== ''} onClick={begin}>Run</Button>}
        <span className="small faint num grow">{obstacle !== '' ? obstacle : run ? textWord(run, sha256) : 'Simulated operators of three skills do the exercises, in the background.'}</span>
        <button type="button" className={styles.close} onClick={onClose}>Close</button>
      </div>
      <Problem sentence={start.problem === '' ? lost : start.problem} />
      {run && (
        <div className={styles.body}>
          <p className={`state ${tone(run)}`} role="status"><Icon name={sign(run)} /><span>{run.sentence}</span></p>
          {running && <Progress value={run.fraction * 100} aria-label="How far the dry run is" />}
          {run.exercises.map((one) => <Result key={one.exercise_id} exercise={one} />)}
        </div>
      )}
    </section>
  );
}

function textWord(run: DryRun, sha256: string): string {
  const when = `Run ${formatWhen(run.started_utc)}.`;
  if (sha256 === '') return `${when} Comparing it with the text in the editor.`;
  return run.yaml_sha256 === sha256 ? `${when} The text is unchanged since.` : `${when} The text was changed since: run it again to be sure.`;
}

const tone = (run: DryRun) => (run.state === 'failed' ? 'tone-bad' : run.state === 'done' ? 'tone-ok' : run.state === 'cancelled' ? 'tone-idle' : 'tone-now');
const sign = (run: DryRun) => (run.state === 'failed' ? 'octagon' : run.state === 'done' ? 'tick' : run.state === 'cancelled' ? 'dash' : 'half');

function Result({exercise}: {exercise: DryRunExercise}) {
  const {feasible} = exercise;
  return (
    <section className={styles.result} aria-label={exercise.title}>
      <h3>{exercise.title}</h3>
      <p className="small">
        {feasible !== null && <span className={`state ${feasible ? 'tone-ok' : 'tone-bad'}`}><Icon name={feasible ? 'tick' : 'cross'} /><span>{feasible ? 'Can be done' : 'Cannot be done'}</span></span>}{' '}
        {exercise.sentence}
      </p>
      <div className="table-scroll" role="region" aria-label={`Results of ${exercise.title}`} tabIndex={0}>
        <table className="table">
          <thead>
            <tr>
              <th scope="col">Simulated operator</th><th scope="col" className="r">Done</th><th scope="col" className="r">Passed</th>
              <th scope="col" className="r">Time, median (range)</th><th scope="col" className="r">Highest force, median (range)</th><th scope="col">Why not</th>
            </tr>
          </thead>
          <tbody>{exercise.skills.map((skill) => <SkillRow key={skill.skill} skill={skill} />)}</tbody>
        </table>
      </div>
      <div className={styles.charts}>{exercise.charts.map((chart) => <ChartView key={chart.id} chart={chart} />)}</div>
    </section>
  );
}

function SkillRow({skill}: {skill: DryRunSkill}) {
  return (
    <tr>
      <th scope="row">{skill.skill.charAt(0).toUpperCase() + skill.skill.slice(1)}</th>
      <td className="r">{skill.completed} of {skill.done}{skill.done < skill.planned ? ` (${skill.planned} planned)` : ''}</td>
      <td className="r">{skill.passed} of {skill.done}</td>
      <td className="r">{spread(skill.time_s, 's')}</td>
      <td className="r">{spread(skill.force_max_n, 'N')}</td>
      <td className="muted">{skill.why_not === '' ? '–' : skill.why_not}</td>
    </tr>
  );
}

/** "32.1 s (30.2 s to 35 s)". */
export function spread(values: readonly number[], unit: string): string {
  const sorted = [...values].sort((a, b) => a - b);
  const [low, high] = [sorted[0], sorted.at(-1)];
  if (low === undefined || high === undefined) return '–';
  const middle = sorted.length / 2;
  const median = sorted.length % 2 === 1 ? sorted[Math.floor(middle)] : ((sorted[middle - 1] ?? 0) + (sorted[middle] ?? 0)) / 2;
  return `${formatValue(median ?? null, unit)} (${formatValue(low, unit)} to ${formatValue(high, unit)})`;
}
