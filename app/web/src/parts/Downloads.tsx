import {NativeSelect} from '@mantine/core';
import {useState, type MouseEvent} from 'react';
import type {ReportKind} from '../wire/downloads';
import {Icon} from './Icon';
import {type Paper, papers, rememberedPaper, rememberPaper, withPaper} from './paper';
import {saveFile} from './save_file';
import styles from './downloads.module.css';

interface Props {
  /** What is downloaded, for screen readers: "progress of Trainee 4". */
  what: string;
  href: (kind: ReportKind) => string;
}

const kinds: readonly {kind: ReportKind; label: string}[] = [
  {kind: 'pdf', label: 'PDF'},
  {kind: 'csv', label: 'CSV'},
  {kind: 'html', label: 'HTML'},
];

/** The same report on paper, as numbers and as a page to keep. */
export function Downloads({what, href}: Props) {
  const [paper, setPaper] = useState<Paper>(rememberedPaper);
  const [making, setMaking] = useState<ReportKind | null>(null);
  const [problem, setProblem] = useState<string | null>(null);

  const save = (event: MouseEvent, kind: ReportKind, address: string) => {
    // with a modifier the browser opens a tab of its own
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    if (making !== null) return;
    setMaking(kind);
    setProblem(null);
    saveFile(address).then(
      () => setMaking(null),
      (reason: unknown) => {
        setMaking(null);
        setProblem(reason instanceof Error ? reason.message : String(reason));
      });
  };
  return (
    <div className={styles.downloads} role="group" aria-label={`Download the ${what}`}>
      {kinds.map(({kind, label}) => {
        const address = withPaper(href(kind), kind, paper);
        const link = (
          <a key={kind} className={styles.link} href={address} download data-busy={making === kind}
            aria-disabled={making !== null} onClick={(event) => save(event, kind, address)}>
            <Icon name="download" />{label}<span className="visually-hidden"> of the {what}</span>
          </a>
        );
        if (kind !== 'pdf') return link;
        return (
          <span key={kind} className={styles.pair}>
            {link}
            <NativeSelect aria-label="Paper" className={styles.paper} value={paper}
              data={papers.map(({id, label: name}) => ({value: id, label: name}))}
              onChange={(event) => {
                const chosen: Paper = event.currentTarget.value === 'letter' ? 'letter' : 'a4';
                setPaper(chosen);
                rememberPaper(chosen);
              }} />
          </span>
        );
      })}
      <span className="visually-hidden" role="status">{making === null ? '' : `The ${making.toUpperCase()} is being made`}</span>
      {problem !== null && <p className={`small tone-bad ${styles.problem}`} role="alert">{problem}</p>}
    </div>
  );
}
