import {SegmentedControl} from '@mantine/core';
import {useLocation, useSearch} from 'wouter';
import {Loaded} from '../parts/Loaded';
import {Panel} from '../parts/Panel';
import {State} from '../parts/State';
import {useResource} from '../parts/api';
import {formatBytes, formatCount, formatWhen} from '../parts/format';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import type {HealthRow, System as SystemState} from '../wire/types';
import {AuditTable} from './system/AuditTable';
import {Backups} from './system/Backups';
import styles from './system.module.css';

/** Is the site well, and is it saved? */
export function System() {
  useTitle('System');
  const [, navigate] = useLocation();
  const audit = new URLSearchParams(useSearch()).get('show') === 'audit';
  return (
    <>
      <div className={styles.head}>
        <h1>System</h1>
        <SegmentedControl aria-label="Which part" size="sm" value={audit ? 'audit' : 'state'}
          onChange={(value) => navigate(value === 'audit' ? paths.audit : paths.system, {replace: true})}
          data={[{value: 'state', label: 'State'}, {value: 'audit', label: 'Audit log'}]} />
      </div>
      {audit ? <AuditTable /> : <Condition />}
    </>
  );
}

function Condition() {
  const resource = useResource('system', (api) => api.system());
  return <Loaded resource={resource} what="the state of the system">{(system) => <Sections system={system} />}</Loaded>;
}

// the worst one decides
function headline(rows: readonly HealthRow[], running: number): string {
  const broken = rows.filter(({state}) => state === 'bad').length;
  const warned = rows.filter(({state}) => state === 'warn').length;
  const trials = running === 0 ? 'No trial is running.' : `${formatCount(running, 'trial is', 'trials are')} running.`;
  if (broken > 0) return `${formatCount(broken, 'check is', 'checks are')} broken. ${trials}`;
  if (warned > 0) return `${formatCount(warned, 'check wants', 'checks want')} a look. ${trials}`;
  return `All ${formatCount(rows.length, 'check')} are well. ${trials}`;
}

function Sections({system}: {system: SystemState}) {
  return (
    <>
      <p className={`num ${styles.headline}`}>{headline(system.health, system.running_trials)}</p>
      <div className={styles.columns}>
        <div className="stack">
          <Panel title="Health" aside={<>server started: {formatWhen(system.started_utc)}</>}>
            <ul className={styles.health}>
              {system.health.map((row) => (
                <li key={row.what}>
                  <State state={row.state} />
                  <span className="small strong">{row.what}</span>
                  <span className="small muted num">{row.sentence}</span>
                </li>
              ))}
            </ul>
          </Panel>
          <Backups first={system.backups} />
        </div>
        <div className="stack">
          <Panel title="Storage">
            <Pairs rows={system.storage.map((row) => [row.what, formatBytes(row.bytes)])} />
          </Panel>
          <Panel title="What is stored">
            <Pairs rows={system.counts.map((row) => [row.what, row.count.toLocaleString('en-GB')])} />
          </Panel>
          <Panel title="Versions">
            <Pairs rows={system.versions.map((row) => [row.what, row.version])} />
          </Panel>
        </div>
      </div>
    </>
  );
}

function Pairs({rows}: {rows: readonly (readonly [string, string])[]}) {
  return (
    <dl className={styles.pairs}>
      {rows.map(([what, value]) => <div key={what}><dt className="small muted">{what}</dt><dd className="small num">{value}</dd></div>)}
    </dl>
  );
}
