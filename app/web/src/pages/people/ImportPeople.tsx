import {Button, Textarea} from '@mantine/core';
import {useEffect, useRef, useState, type DragEvent} from 'react';
import {Link} from 'wouter';
import {Panel} from '../../parts/Panel';
import {Problem} from '../../parts/Problem';
import {useSignedIn} from '../../parts/api';
import {saveAsFile, toCsv} from '../../parts/csv_file';
import {importColumns, importTemplate} from '../../parts/import_choice';
import {paths} from '../../parts/paths';
import {useAction} from '../../parts/use_action';
import {useTitle} from '../../parts/use_title';
import type {ImportPreview, ImportResult} from '../../wire/types';
import {ImportDone} from './ImportDone';
import {ImportLook} from './ImportLook';
import styles from './import.module.css';

interface ChosenFile {
  name: string;
  csv: string;
}

/** Adds and changes many people from one table: first what would happen, then the doing. */
export function ImportPeople() {
  useTitle('Import people');
  const {api} = useSignedIn();
  const action = useAction();
  const [file, setFile] = useState<ChosenFile | null>(null);
  const [preview, setPreview] = useState<ImportPreview | null>(null);
  const [result, setResult] = useState<ImportResult | null>(null);

  const look = (chosen: ChosenFile) => {
    setFile(chosen);
    action.run(() => api.previewImport({csv: chosen.csv}), setPreview);
  };
  const again = () => {
    setFile(null);
    setPreview(null);
    setResult(null);
    action.forget();
  };
  const go = (skipBroken: boolean) => {
    if (!file || !preview) return;
    const body = {csv: file.csv, skip_broken: skipBroken, preview_sha256: preview.sha256};
    action.run(() => api.importPeople(body), setResult);
  };
  return (
    <>
      <nav className="crumbs" aria-label="Breadcrumb">
        <ol><li><Link href={paths.people}>People</Link></li><li aria-hidden="true">/</li><li>Import</li></ol>
      </nav>
      <div className="page-head">
        <h1>Import people</h1>
        <span className="muted">{result ? 'Done.' : preview ? 'This would happen. Nothing has been changed yet.' : 'From a CSV file; you see what would happen first.'}</span>
      </div>
      {result
        ? <ImportDone result={result} onAgain={again} />
        : preview && file
          ? <ImportLook fileName={file.name} preview={preview} busy={action.busy} problem={action.problem} onImport={go} onAgain={again}
            onLook={() => look(file)} />
          : <Choose busy={action.busy} problem={action.problem} onChosen={look} />}
    </>
  );
}

interface ChooseProps {
  busy: boolean;
  problem: string;
  onChosen: (file: ChosenFile) => void;
}

// far beyond any school, and below what the server takes
const largest_bytes = 900_000;

function Choose({busy, problem, onChosen}: ChooseProps) {
  const input = useRef<HTMLInputElement>(null);
  const [over, setOver] = useState(false);
  const [refused, setRefused] = useState('');
  const [pasted, setPasted] = useState('');
  const take = (file: File | undefined) => {
    if (!file) return;
    if (file.size > largest_bytes) {
      setRefused(`${file.name} is larger than 900 kB. Split it into several files.`);
      return;
    }
    setRefused('');
    file.text().then((csv) => onChosen({name: file.name, csv}),
      () => setRefused(`${file.name} could not be read. Close it in other programs and choose it again.`));
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setOver(false);
    take(event.dataTransfer.files[0]);
  };
  // a file dropped beside the field must not replace the page
  useEffect(() => {
    const keep = (event: Event) => event.preventDefault();
    window.addEventListener('dragover', keep);
    window.addEventListener('drop', keep);
    return () => {
      window.removeEventListener('dragover', keep);
      window.removeEventListener('drop', keep);
    };
  }, []);
  return (
    <div className={styles.columns}>
      <Panel title="The file">
        <div className={`${styles.drop} ${over ? styles.over : ''}`} onDragOver={() => setOver(true)} onDragLeave={() => setOver(false)} onDrop={drop}>
          <p>Drop a CSV file here, or</p>
          <input ref={input} type="file" accept=".csv,text/csv,text/plain" className="visually-hidden" aria-label="CSV file" tabIndex={-1}
            onChange={(event) => {
              take(event.currentTarget.files?.[0]);
              event.currentTarget.value = '';
            }} />
          <Button loading={busy} onClick={() => input.current?.click()}>Choose a file</Button>
        </div>
        <Problem sentence={refused === '' ? problem : refused} />
        <form className={styles.paste} onSubmit={(event) => {
          event.preventDefault();
          onChosen({name: 'pasted table', csv: pasted});
        }}>
          <Textarea label="Or paste the table" rows={6} value={pasted} spellCheck={false} classNames={{input: styles.text}}
            placeholder={'name,display_name,role,groups\nresident14,Resident 14,trainee,2026'}
            onChange={(event) => setPasted(event.currentTarget.value)} />
          <Button type="submit" variant="default" disabled={pasted.trim() === ''} loading={busy}>Look at what would happen</Button>
        </form>
      </Panel>
      <Panel title="What it holds">
        <p className="small muted">The first line names the columns; name and display_name must be there. A name that exists already is changed, not doubled.</p>
        <dl className={styles.fields}>
          {importColumns.map(([name, meaning]) => (
            <div key={name}><dt className="mono">{name}</dt><dd className="small muted">{meaning}</dd></div>
          ))}
        </dl>
        <Button variant="default" onClick={() => saveAsFile('people.csv', toCsv(importTemplate))}>Download a template</Button>
      </Panel>
    </div>
  );
}
