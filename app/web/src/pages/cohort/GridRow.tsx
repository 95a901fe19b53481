import {memo} from 'react';
import {State} from '../../parts/State';
import {formatCount} from '../../parts/format';
import {paths} from '../../parts/paths';
import type {CohortRow} from '../../wire/types';
import styles from './cohort.module.css';
import {cellSentence, personFacts, type CohortCell, type CohortExercise} from './cohort_view';

export const personColumn = 0;
export const nowColumn = 1;
/** columns before the first exercise */
export const leadColumns = 2;

interface Props {
  person: CohortRow;
  exercises: readonly CohortExercise[];
  index: number;
  top_px: number;
  height_px: number;
  compact: boolean;
  /** the column that the Tab key reaches; -1 in all rows but one */
  active: number;
  /** a trial runs now */
  running: boolean;
}

/** One person. Plain links: the grid above turns clicks into moves within the application. */
export const GridRow = memo(function GridRow({person, exercises, index, top_px, height_px, compact, active, running}: Props) {
  const place = (column: number) => ({'data-place': `${index} ${column}`, tabIndex: column === active ? 0 : -1});
  return (
    <div
      role="row" aria-rowindex={index + 2} className={styles.row} data-help={person.needs_help}
      style={{top: top_px, height: height_px}}
    >
      <div role="rowheader" aria-colindex={personColumn + 1} className={styles.person}>
        <a {...place(personColumn)} href={paths.person(person.person_id)} className={styles.name}>
          <span className={styles.who}>
            <b>{person.display_name}</b>
            {person.needs_help && <State state="needs_help" />}
          </span>
          {person.needs_help
            ? <span className={`xs ${styles.why}`} title={person.why}>{person.why}</span>
            : <span className={`xs faint num ${styles.facts}`}>{personFacts(person)}</span>}
        </a>
      </div>
      {running
        ? (
          <div role="gridcell" aria-colindex={nowColumn + 1} className={styles.now} {...place(nowColumn)}>
            <State state="running" form={compact ? 'stacked' : 'inline'} />
          </div>
        )
        : <div role="gridcell" aria-colindex={nowColumn + 1} className={styles.now} aria-label="Not running" {...place(nowColumn)} />}
      {exercises.map((exercise, at) => (
        <Cell
          key={exercise.exercise_id} cell={person.cells[at] ?? null} href={paths.personExercise(person.person_id, exercise.exercise_id)}
          column={at + leadColumns} compact={compact} place={place(at + leadColumns)}
        />
      ))}
    </div>
  );
});

interface CellProps {
  cell: CohortCell;
  href: string;
  column: number;
  compact: boolean;
  place: {'data-place': string; tabIndex: number};
}

function Cell({cell, href, column, compact, place}: CellProps) {
  if (cell === null) {
    return (
      <div role="gridcell" aria-colindex={column + 1} className={`faint ${styles.cell}`} aria-label={cellSentence(null)} {...place}>
        <span aria-hidden="true">–</span>
      </div>
    );
  }
  return (
    <div role="gridcell" aria-colindex={column + 1} className={styles.cell}>
      <a {...place} href={href} {...(compact ? {'aria-label': cellSentence(cell)} : {})}>
        <State state={cell.status} form={compact ? 'stacked' : 'short'} />
        {!compact && (
          <span className={`xs faint num ${styles.sentence}`}>
            {cell.sentence}<span className="visually-hidden">, {formatCount(cell.trials, 'trial')}</span>
          </span>
        )}
      </a>
    </div>
  );
}
