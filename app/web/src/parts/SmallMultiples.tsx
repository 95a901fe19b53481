import type {Chart} from '../wire/types';
import {ChartView} from './ChartView';
import styles from './progress.module.css';

/** The same small drawing for every recorded metric, side by side. */
export function SmallMultiples({charts}: {charts: readonly Chart[]}) {
  return (
    <div className={styles.multiples}>
      {charts.map((chart) => <ChartView key={chart.id} chart={chart} className={styles.multiple ?? ''} />)}
    </div>
  );
}
