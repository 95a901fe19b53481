import type {ExerciseProgress} from '../wire/types';
import {ChartView} from './ChartView';
import {EmptyState} from './EmptyState';
import {State} from './State';
import {withoutTitle} from './format';
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
  return (
    <section className="panel" aria-labelledby={heading}>
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
            <div className={styles.charts}>{exercise.charts.map((chart) => <ChartView key={chart.id} chart={chart} />)}</div>
            <div className="panel-body"><TrialTable trials={exercise.trials} caption={`Trials of ${exercise.title}`} /></div>
          </>
        )}
    </section>
  );
}
