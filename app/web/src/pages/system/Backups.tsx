import {Button} from '@mantine/core';
import {useState} from 'react';
import {EmptyState} from '../../parts/EmptyState';
import {Icon} from '../../parts/Icon';
import {Panel} from '../../parts/Panel';
import {Problem} from '../../parts/Problem';
import {useSignedIn} from '../../parts/api';
import {formatBytes, formatWhen} from '../../parts/format';
import {useAction} from '../../parts/use_action';
import {downloads} from '../../wire/downloads';
import type {BackupRow} from '../../wire/types';
import styles from '../system.module.css';

/** Backups made here: one more with a click, each to be taken away. */
export function Backups({first}: {first: BackupRow[]}) {
  const {api} = useSignedIn();
  const action = useAction();
  const [backups, setBackups] = useState(first);
  const [made, setMade] = useState<BackupRow | null>(null);
  const make = () => action.run(() => api.makeBackup(), (backup) => {
    setMade(backup);
    setBackups((before) => [backup, ...before.filter(({name}) => name !== backup.name)]);
  });
  return (
    <Panel title="Backups" aside="trials may go on meanwhile">
      <div className={styles.backup}>
        <Button loading={action.busy} onClick={make}>Back up now</Button>
        <span className="small muted" role="status">
          {action.busy
            ? 'Copying the database; a large site takes a minute.'
            : made
              ? <span className="state tone-ok"><Icon name="tick" /><span>{made.name} is made, {formatBytes(made.bytes)}</span></span>
              : 'Copies the whole database while it is in use, and checks the copy.'}
        </span>
      </div>
      <Problem sentence={action.problem} />
      {backups.length === 0
        ? <EmptyState title="No backup yet">Make one now, and keep a copy on another machine.</EmptyState>
        : <Rows backups={backups} />}
      <p className={`small muted ${styles.restore}`}>To restore, stop the server, put the file into an empty folder under this name, and serve that folder:</p>
      <pre className={styles.command}><code>{'cp BACKUP NEW_FOLDER/cathedra.db\ncathedra serve --data NEW_FOLDER'}</code></pre>
    </Panel>
  );
}

function Rows({backups}: {backups: readonly BackupRow[]}) {
  return (
    <div className="table-scroll">
      <table className="table">
        <thead>
          <tr>
            <th scope="col">File</th><th scope="col">Made</th><th scope="col" className="r">Size</th><th scope="col">SHA-256</th>
            <th scope="col"><span className="visually-hidden">Download</span></th>
          </tr>
        </thead>
        <tbody>
          {backups.map((backup) => (
            <tr key={backup.name}>
              <th scope="row">{backup.name}</th>
              <td className="muted">{formatWhen(backup.made_utc)}</td>
              <td className="r">{formatBytes(backup.bytes)}</td>
              <td className="mono faint" title={backup.sha256}>{backup.sha256.slice(0, 12)}</td>
              <td className="r">
                <a className={styles.download} href={downloads.backup(backup.name)} download>
                  Download<span className="visually-hidden"> {backup.name}</span>
                </a>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
