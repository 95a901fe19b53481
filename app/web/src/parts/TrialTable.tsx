import {Link} from 'wouter';
import type {TrialRow} from '../wire/types';
import {formatDifference, formatValue, formatWhen} from './format';
import {paths} from './paths';
import {State, type StateName} from './State';

export function stateOfTrial(trial: TrialRow): StateName {
  if (trial.voided) return 'voided';
  if (trial.end_reason === null) return 'running';
  return trial.outcome ?? 'invalid';
}

export const endWords: Readonly<Record<NonNullable<TrialRow['end_reason']>, string>> = {
  completed: 'Completed', timeout: 'Time ran out', limit: 'Stopped at a limit', aborted: 'Ended early',
  diverged: 'Simulation stopped',
};

export function endWord(trial: TrialRow): string {
  return trial.end_reason === null ? 'Running' : endWords[trial.end_reason];
}

const sourceWords: Readonly<Record<TrialRow['source'], string>> = {
  live: 'Live', imported: 'Imported', 'simulated-operator': 'Simulated operator', 'published-data': 'Published data',
};

export function sourceWord(source: TrialRow['source']): string {
  return sourceWords[source];
}

/** Every trial of an exercise, newest first. */
export function TrialTable({trials, caption, own}: {trials: readonly TrialRow[]; caption: string; own: boolean}) {
  const rows = [...trials].sort((a, b) => b.ordinal - a.ordinal);
  const judged = rows.some((trial) => trial.target_s !== null);
  return (
    <div className="table-scroll" role="region" aria-label={caption} tabIndex={0}>
      <table className="table">
        <caption className="visually-hidden">{caption}</caption>
        <thead>
          <tr>
            <th scope="col" className="r">Trial</th>
            <th scope="col">When</th>
            <th scope="col">Verdict</th>
            <th scope="col" className="r">Time</th>
            {judged && <th scope="col" className="r">Against target</th>}
            <th scope="col" className="r">Highest force</th>
            <th scope="col" className="r">Critical errors</th>
            <th scope="col">End</th>
            <th scope="col">Source</th>
            <th scope="col"><span className="visually-hidden">Debrief</span></th>
          </tr>
        </thead>
        <tbody>
          {rows.map((trial) => <Row key={trial.trial_id} trial={trial} judged={judged} own={own} />)}
        </tbody>
      </table>
    </div>
  );
}

function Row({trial, judged, own}: {trial: TrialRow; judged: boolean; own: boolean}) {
  const over = trial.time_s !== null && trial.target_s !== null ? trial.time_s - trial.target_s : null;
  return (
    <tr>
      <td className="r">{trial.ordinal}</td>
      <td className="muted">{trial.source === 'published-data' ? '–' : formatWhen(trial.started_utc)}</td>
      <td>{trial.source === 'published-data' ? <span className="faint">Not judged</span> : <State state={stateOfTrial(trial)} />}</td>
      <td className="r strong">{formatValue(trial.time_s, 's')}</td>
      {judged && <td className="r">{over === null ? '–' : formatDifference(over, 's')}</td>}
      <td className="r">{trial.force_max_n === null ? '–' : formatValue(trial.force_max_n, 'N')}</td>
      <td className="r">{trial.source === 'published-data' ? '–' : trial.critical_errors}</td>
      <td className="muted">{endWord(trial)}{trial.interrupted ? ', interrupted' : ''}</td>
      <td className="muted">{sourceWord(trial.source)}</td>
      <td className="r">
        {trial.source !== 'published-data' && (trial.end_reason !== null || own) && (
          <Link href={trial.end_reason !== null ? paths.debrief(trial.trial_id) : paths.console(trial.trial_id)}>
            {trial.end_reason !== null ? 'Debrief' : 'Open'}<span className="visually-hidden"> of trial {trial.ordinal}</span>
          </Link>
        )}
      </td>
    </tr>
  );
}
