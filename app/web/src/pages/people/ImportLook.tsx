import {Button, SegmentedControl} from '@mantine/core';
import {useState} from 'react';
import {Icon} from '../../parts/Icon';
import {Pager} from '../../parts/Pager';
import {Panel} from '../../parts/Panel';
import {Problem} from '../../parts/Problem';
import {State} from '../../parts/State';
import {importChoice, orderRows} from '../../parts/import_choice';
import type {ImportPreview, ImportRow} from '../../wire/types';
import styles from './import.module.css';

interface Props {
  fileName: string;
  preview: ImportPreview;
  busy: boolean;
  problem: string;
  onImport: (skipBroken: boolean) => void;
  onAgain: () => void;
  /** Looks at the same file once more, after somebody changed people in between. */
  onLook: () => void;
}

type View = 'all' | ImportRow['action'];
const rowsPerPage = 100;

/** What an import would do, row by row. */
export function ImportLook({fileName, preview, busy, problem, onImport, onAgain, onLook}: Props) {
  const choice = importChoice(preview);
  return (
    <div className="stack">
      <section className={`panel ${styles.decide}`} aria-label="What to do">
        <ul className={styles.counts}>
          {(['add', 'change', 'unchanged', 'broken'] as const).map((action) => (
            <li key={action}><span className={styles.count}>{preview[action]}</span><State state={action} /></li>
          ))}
        </ul>
        {preview.problems.length > 0 && (
          <ul className={styles.problems} role="alert">
            {preview.problems.map((sentence) => <li key={sentence} className="tone-bad small"><Icon name="octagon" />{sentence}</li>)}
          </ul>
        )}
        <Problem sentence={problem} />
        <div className={styles.buttons}>
          <Button loading={busy} disabled={!choice.possible} onClick={() => onImport(choice.skipBroken)}>{choice.action}</Button>
          <Button variant="default" onClick={onAgain}>Choose another file</Button>
          {problem !== '' && <Button variant="default" loading={busy} onClick={onLook}>Look again</Button>}
          <span className="small muted">{choice.sentence}</span>
        </div>
      </section>
      {preview.rows.length > 0 && <Rows fileName={fileName} preview={preview} />}
    </div>
  );
}

function Rows({fileName, preview}: {fileName: string; preview: ImportPreview}) {
  const [view, setView] = useState<View>('all');
  const [page, setPage] = useState(0);
  const rows = orderRows(preview.rows).filter(({action}) => view === 'all' || action === view);
  const words: readonly [View, string, number][] = [
    ['all', 'All', preview.rows.length], ['broken', 'Left out', preview.broken], ['add', 'Add', preview.add], ['change', 'Change', preview.change],
    ['unchanged', 'Unchanged', preview.unchanged],
  ];
  return (
    <Panel title="Row by row" aside={fileName}>
      <SegmentedControl aria-label="Which rows" size="sm" value={view} className={styles.views} onChange={(value) => {
        setView(value as View);
        setPage(0);
      }} data={words.map(([value, word, count]) => ({value, label: `${word} ${count}`, disabled: count === 0}))} />
      <div className="table-scroll" role="region" aria-label="Rows of the file" tabIndex={0}>
        <table className="table">
          <thead>
            <tr>
              <th scope="col" className="r">Line</th><th scope="col">What</th><th scope="col">Name</th><th scope="col">Sign-in name</th>
              <th scope="col">In words</th>
            </tr>
          </thead>
          <tbody>
            {rows.slice(page * rowsPerPage, (page + 1) * rowsPerPage).map((row) => (
              <tr key={row.line}>
                <td className="r">{row.line}</td>
                <td><State state={row.action} /></td>
                <th scope="row">{row.display_name === '' ? '–' : row.display_name}</th>
                <td className="muted">{row.name === '' ? '–' : row.name}</td>
                <td className={row.action === 'broken' ? undefined : 'muted'}>{row.sentence}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <Pager page={page} size={rowsPerPage} total={rows.length} what="rows" onPage={setPage} />
    </Panel>
  );
}
