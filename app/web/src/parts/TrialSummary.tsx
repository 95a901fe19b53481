import type {TrialRow} from '../wire/types';
import {formatCount} from './format';
import {countDefinitions, countErrors, countTrials, type TrialCounts} from './trial_counts';
import {endWords} from './TrialTable';
import styles from './progress.module.css';

const names: readonly {key: keyof TrialCounts; title: string}[] = [
  {key: 'started', title: 'Started'}, {key: 'valid', title: 'Valid'}, {key: 'counted', title: 'Counted'},
];

/** How many trials, of which kind, and what went wrong in them; every number says what it counts. */
export function TrialSummary({trials}: {trials: readonly TrialRow[]}) {
  const counts = countTrials(trials);
  const errors = countErrors(trials);
  const ends = errors.ends.map(({reason, count}) => `${endWords[reason].toLowerCase()} ${count}`).join(', ');
  return (
    <dl className={styles.counts}>
      {names.map(({key, title}) => (
        <div key={key}>
          <dt className="xs faint">{title}</dt>
          <dd className="strong num">{formatCount(counts[key], 'trial')}</dd>
          <dd className="xs faint">{countDefinitions[key]}</dd>
        </div>
      ))}
      <div>
        <dt className="xs faint">Critical errors</dt>
        <dd className="strong num">{errors.critical === 0 ? 'None' : `${errors.critical} in ${formatCount(errors.withCritical, 'trial')}`}</dd>
        <dd className="xs faint num">Among {errors.ended} that ended and were not voided.</dd>
      </div>
      <div>
        <dt className="xs faint">Not completed</dt>
        <dd className="strong num">{formatCount(errors.ends.reduce((sum, end) => sum + end.count, 0), 'trial')}</dd>
        <dd className="xs faint num">{ends === '' ? 'Every trial that ended was completed.' : `${ends.charAt(0).toUpperCase()}${ends.slice(1)}.`}</dd>
      </div>
    </dl>
  );
}
