import {Button} from '@mantine/core';
import {useEffect, useState} from 'react';
import {Link} from 'wouter';
import {Icon} from '../../parts/Icon';
import {addressOf} from '../../parts/OneTimeLink';
import {Panel} from '../../parts/Panel';
import {saveAsFile, toCsv} from '../../parts/csv_file';
import {formatCount, formatWhen} from '../../parts/format';
import {paths} from '../../parts/paths';
import type {ImportResult} from '../../wire/types';
import styles from './import.module.css';

/** What an import did, and the links that it made: they are shown once. */
export function ImportDone({result, onAgain}: {result: ImportResult; onAgain: () => void}) {
  const {invitations} = result;
  const [saved, setSaved] = useState(false);
  // the links are nowhere else: a closed tab would lose them
  useEffect(() => {
    if (saved || invitations.length === 0) return;
    const ask = (event: BeforeUnloadEvent) => event.preventDefault();
    window.addEventListener('beforeunload', ask);
    return () => window.removeEventListener('beforeunload', ask);
  }, [saved, invitations]);
  const save = () => {
    saveAsFile('invitations.csv', toCsv([
      ['name', 'display_name', 'link', 'expires_utc'],
      ...invitations.map((one) => [one.name, one.display_name, addressOf(one), one.expires_utc]),
    ]));
    setSaved(true);
  };
  return (
    <div className="stack">
      <section className={`panel ${styles.decide}`} aria-label="Result" role="status">
        <p className="state tone-ok"><Icon name="ring_tick" />
          <span>{[`${result.added} added`, `${result.changed} changed`, `${result.unchanged} unchanged`, `${result.skipped} left out`].join(', ')}</span>
        </p>
        <div className={styles.buttons}>
          {invitations.length > 0 && <Button onClick={save}>Download {formatCount(invitations.length, 'link')} as CSV</Button>}
          <Button variant="default" onClick={onAgain}>Import another file</Button>
          <Button component={Link} href={paths.people} variant="default">To the people</Button>
          {invitations.length > 0 && (
            <span className="small muted">{saved ? 'Saved. Each link works once.' : 'The links are shown only now. Save them before you leave this page.'}</span>
          )}
        </div>
      </section>
      {invitations.length > 0 && (
        <Panel title="Invitations" aside={<>until {formatWhen(invitations[0]?.expires_utc ?? null)}</>}>
          <div className="table-scroll" role="region" aria-label="Table of invitations" tabIndex={0}>
            <table className="table">
              <thead><tr><th scope="col">Name</th><th scope="col">Sign-in name</th><th scope="col">One-time link</th></tr></thead>
              <tbody>
                {invitations.map((one) => (
                  <tr key={one.person_id}>
                    <th scope="row">{one.display_name}</th>
                    <td className="muted">{one.name}</td>
                    <td className={`mono ${styles.link}`}>{addressOf(one)}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        </Panel>
      )}
    </div>
  );
}
