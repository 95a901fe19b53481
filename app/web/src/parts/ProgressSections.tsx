import type {ExerciseProgress} from '../wire/types';
import {ChartView} from './ChartView';
import {EmptyState} from './EmptyState';
import {SmallMultiples} from './SmallMultiples';
import {Standings} from './Standings';
import {State} from './State';
import {withoutTitle} from './format';
import {TrialSummary} from './TrialSummary';
import {TrialTable} from './TrialTable';
import styles from './progress.module.css';

/** Curves and trials of one person, one section per exercise. */
export function ProgressSections({exercises, own}: {exercises: ExerciseProgress[]; own: boolean}) {
  if (exercises.length === 0) {
    return <EmptyState title="No exercise yet">{own ? 'You are' : 'This person is'} not enrolled in a curriculum.</EmptyState>;
  }
  return (
    <div className="stack">
      {exercises.map((exercise) => <Section key={exercise.exercise_id} exercise={exercise} own={own} />)}
    </div>
  );
}

function Section({exercise, own}: {exercise: ExerciseProgress; own: boolean}) {
  const heading = `progress-${exercise.exercise_id}`;
  // a server of the version before sends neither
  const standings = exercise.standings ?? [];
  const multiples = exercise.small_multiples ?? [];
  const judged = exercise.trials.some((trial) => trial.source !== 'published-data');
  return (
    <section className={`panel ${styles.section}`} aria-labelledby={heading}>
      <div className={styles.head}>
        <h2 id={heading}>{exercise.title}</h2>
        <State state={exercise.status} />
        <p className="muted num">{withoutTitle(exercise.headline, exercise.title)}</p>
      </div>
      {exercise.trials.length === 0
        ? (
          <div className="panel-body">
            <EmptyState title="No trial yet">
              {own ? 'Your learning curve starts with your first trial.' : 'The learning curve starts with the first trial.'}
            </EmptyState>
          </div>
        )
        : (
          <>
            {judged && <div className="panel-body"><TrialSummary trials={exercise.trials} /></div>}
            <div className={styles.charts}>{exercise.charts.map((chart) => <ChartView key={chart.id} chart={chart} />)}</div>
            {standings.length > 0 && (
              <div className="panel-body">
                <h3>Last trial beside the others</h3>
                <Standings standings={standings} caption={`Last, previous and best of ${exercise.title}`} />
              </div>
            )}
            {multiples.length > 0 && (
              <>
                <h3 className={styles.over}>Every recorded metric, trial by trial</h3>
                <SmallMultiples charts={multiples} />
              </>
            )}
            <div className="panel-body">
              <h3>All trials</h3>
              <TrialTable trials={exercise.trials} caption={`Trials of ${exercise.title}`} own={own} />
            </div>
          </>
        )}
    </section>
  );
}
