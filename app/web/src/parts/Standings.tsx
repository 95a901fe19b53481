import type {MetricResult, Standing} from '../wire/types';
import {formatNumber, formatValue} from './format';

const space = '\u00a0';

/** −8.04, lower is better -> "−8 %, better". */
export function changeWords(percent: number | null, direction: MetricResult['direction']): string {
  if (percent === null) return '–';
  const rounded = Number(percent.toFixed(1));
  if (rounded === 0) return 'the same';
  const better = rounded < 0 === (direction === 'lower');
  return `${rounded > 0 ? '+' : ''}${formatNumber(rounded, 1)}${space}%, ${better ? 'better' : 'worse'}`;
}

/** Where somebody stands, metric by metric: the last trial beside the one before, the best and the first. */
export function Standings({standings, caption}: {standings: readonly Standing[]; caption: string}) {
  const value = (number: number | null, unit: string) => (number === null ? '–' : formatValue(number, unit));
  return (
    <div className="table-scroll" role="region" aria-label={caption} tabIndex={0}>
      <table className="table">
        <caption className="visually-hidden">{caption}</caption>
        <thead>
          <tr>
            <th scope="col">Metric</th>
            <th scope="col" className="r">Last</th>
            <th scope="col" className="r">Previous</th>
            <th scope="col">Change to previous</th>
            <th scope="col">Change to first</th>
            <th scope="col" className="r">Best</th>
            <th scope="col">Better is</th>
          </tr>
        </thead>
        <tbody>
          {standings.map((standing) => (
            <tr key={standing.metric}>
              <td>{standing.title}</td>
              <td className="r strong">{value(standing.last, standing.unit)}</td>
              <td className="r">{value(standing.previous, standing.unit)}</td>
              <td>{changeWords(standing.change_to_previous_percent, standing.direction)}</td>
              <td>{changeWords(standing.change_to_first_percent, standing.direction)}</td>
              <td className="r">{value(standing.best, standing.unit)}</td>
              <td className="muted">{standing.direction === 'lower' ? 'less' : 'more'}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
