import {Button} from '@mantine/core';
import {useState} from 'react';
import {EmptyState} from '../../parts/EmptyState';
import {Loaded} from '../../parts/Loaded';
import {State} from '../../parts/State';
import {useResource} from '../../parts/api';
import {formatWhen} from '../../parts/format';
import type {AuditLog} from '../../wire/types';
import styles from '../system.module.css';

/** Who did what, and that nobody has touched the list since. */
export function AuditTable() {
  // where each page begins; the last is shown
  const [starts, setStarts] = useState<readonly (number | null)[]>([null]);
  const start = starts[starts.length - 1] ?? null;
  const resource = useResource(`audit ${start ?? 'newest'}`, (api) => api.audit(start));
  return (
    <Loaded resource={resource} what="the audit log">
      {(log) => (
        <Page log={log} newest={starts.length === 1} onNewer={() => setStarts(starts.slice(0, -1))}
          onOlder={() => setStarts([...starts, log.rows[log.rows.length - 1]?.seq ?? null])} />
      )}
    </Loaded>
  );
}

interface PageProps {
  log: AuditLog;
  newest: boolean;
  onNewer: () => void;
  onOlder: () => void;
}

function Page({log, newest, onNewer, onOlder}: PageProps) {
  const first = log.rows[0];
  const last = log.rows[log.rows.length - 1];
  return (
    <>
      <p className={`num ${styles.chain}`}><State state={log.intact ? 'ok' : 'bad'} /> <span>{log.sentence}</span></p>
      <section className="panel" aria-label="Audit log">
        <div className="panel-body">
          {first === undefined || last === undefined
            ? <EmptyState title="Nothing yet">Every change that somebody makes is noted here.</EmptyState>
            : (
              <>
                <div className="table-scroll" role="region" aria-label="Rows of the audit log" tabIndex={0}>
                  <table className="table">
                    <thead>
                      <tr>
                        <th scope="col" className="r">No.</th><th scope="col">When</th><th scope="col">Who</th><th scope="col">What</th>
                        <th scope="col">On what</th><th scope="col">Hash</th>
                      </tr>
                    </thead>
                    <tbody>
                      {log.rows.map((row) => (
                        <tr key={row.seq}>
                          <td className="r">{row.seq}</td>
                          <td className={`muted ${styles.when}`}>{formatWhen(row.utc)}</td>
                          <th scope="row">{row.actor}</th>
                          <td>{row.action}</td>
                          <td className={`muted ${styles.object}`}>{row.object}</td>
                          <td className="mono faint" title={row.hash}>{row.hash.slice(0, 12)}</td>
                        </tr>
                      ))}
                    </tbody>
                  </table>
                </div>
                <nav className={styles.pages} aria-label="Pages of the audit log">
                  <span className="small muted num">No. {last.seq} to {first.seq}</span>
                  <Button variant="default" disabled={newest} onClick={onNewer}>Newer</Button>
                  <Button variant="default" disabled={!log.more} onClick={onOlder}>Older</Button>
                </nav>
              </>
            )}
        </div>
      </section>
    </>
  );
}
