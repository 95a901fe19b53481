import {UnstyledButton} from '@mantine/core';
import {useId, useState, type ReactNode} from 'react';
import type {Chart} from '../wire/types';
import {DataTable} from './DataTable';
import styles from './chart.module.css';

interface Props {
  chart: Chart;
  /** Stands above the drawing, under the title, and says what the summary says. */
  children?: ReactNode;
  className?: string;
}

/** A drawing made by the server, its sentence, and its numbers one click behind. */
export function ChartView({chart, children, className = ''}: Props) {
  const [asTable, setAsTable] = useState(false);
  const heading = useId();
  return (
    <figure className={`${styles.chart} ${className}`} aria-labelledby={heading}>
      <div className={styles.head}>
        <h2 id={heading}>{chart.title}</h2>
        <UnstyledButton className={styles.toggle} aria-pressed={asTable} onClick={() => setAsTable(!asTable)}>
          {asTable ? 'Chart' : 'Table'}<span className="visually-hidden"> of {chart.title}</span>
        </UnstyledButton>
      </div>
      {children}
      {asTable
        ? <DataTable table={chart.table} caption={chart.title} />
        : <Drawing svg={chart.svg} />}
      <figcaption className={children === undefined ? 'small muted' : 'visually-hidden'}>{chart.summary}</figcaption>
    </figure>
  );
}

// The one place that sets markup: the drawing comes from our own server, escaped where it is made,
// and carries its own role, title and description.
function Drawing({svg}: {svg: string}) {
  return <div className={styles.drawing} dangerouslySetInnerHTML={{__html: svg}} />;
}
