import {Button, TextInput} from '@mantine/core';
import {useState} from 'react';
import {Link, useLocation} from 'wouter';
import {Confirm} from '../parts/Confirm';
import {EmptyState} from '../parts/EmptyState';
import {Icon} from '../parts/Icon';
import {Loaded} from '../parts/Loaded';
import {useResource, useSignedIn} from '../parts/api';
import {formatCount, formatWhen} from '../parts/format';
import {paths} from '../parts/paths';
import {useAction} from '../parts/use_action';
import {useTitle} from '../parts/use_title';
import type {CurriculumRow} from '../wire/types';
import styles from './curricula.module.css';

type Asked = {what: 'copy' | 'default' | 'discard'; row: CurriculumRow} | {what: 'retire'; row: CurriculumRow; version: string};

/** Which curricula are there, who trains by them, and what is being changed? */
export function Curricula() {
  useTitle('Curricula');
  const resource = useResource('curricula', (api) => api.curricula());
  return <Loaded resource={resource} what="the curricula">{({curricula}, reload) => <List curricula={curricula} onChanged={reload} />}</Loaded>;
}

function List({curricula, onChanged}: {curricula: CurriculumRow[]; onChanged: () => void}) {
  const [asked, setAsked] = useState<Asked | null>(null);
  return (
    <>
      <div className="page-head">
        <h1>Curricula</h1>
        <span className="muted num">{formatCount(curricula.length, 'curriculum', 'curricula')}. Copy a built-in one to change it.</span>
      </div>
      {curricula.length === 0 && <EmptyState title="No curriculum">The program brings one along. Ask who installed it.</EmptyState>}
      <div className="stack">{curricula.map((row) => <Card key={row.id} row={row} onAsk={setAsked} />)}</div>
      {asked && <Question asked={asked} curricula={curricula} onClose={() => setAsked(null)} onDone={() => { setAsked(null); onChanged(); }} />}
    </>
  );
}

function Card({row, onAsk}: {row: CurriculumRow; onAsk: (asked: Asked) => void}) {
  const {api} = useSignedIn();
  const [, navigate] = useLocation();
  const begin = useAction();
  const published = row.published_version;
  const next = () => begin.run(() => api.copyCurriculum({from_id: row.id, from_version: published ?? '', new_id: row.id}), () => navigate(paths.curriculum(row.id)));
  return (
    <section className={`panel ${styles.card}`} aria-label={row.title}>
      <div className={styles.head}>
        <h2>{published === null && row.draft ? <Link href={paths.curriculum(row.id)}>{row.title}</Link> : row.title}</h2>
        <span className="mono faint">{row.id}</span>
        <span className="tag">{row.built_in ? 'Built-in' : 'Own'}</span>
        {row.is_default && <span className="state tone-ok"><Icon name="tick" /><span>Default</span></span>}
        <span className="grow" />
        <span className={styles.actions}>
          {row.draft && <Button component={Link} href={paths.curriculum(row.id)} variant="default">Edit draft</Button>}
          {!row.built_in && !row.draft && published !== null && <Button variant="default" loading={begin.busy} onClick={next}>New version</Button>}
          {published !== null && <Button variant="default" onClick={() => onAsk({what: 'copy', row})}>Copy</Button>}
          {published !== null && !row.is_default && <Button variant="default" onClick={() => onAsk({what: 'default', row})}>Make default</Button>}
          {row.draft && <Button variant="default" onClick={() => onAsk({what: 'discard', row})}>Delete draft</Button>}
        </span>
      </div>
      {begin.problem !== '' && <p className="tone-bad small" role="alert">{begin.problem}</p>}
      <p className="small muted num">
        {published === null ? 'Not published yet.' : `Version ${published} is published.`}{' '}
        {row.people === 0 ? 'Nobody trains by it.' : `${formatCount(row.people, 'person trains', 'people train')} by it.`}
      </p>
      {row.draft && (
        <p className="small num">
          Draft{row.draft.version === '' ? '' : ` ${row.draft.version}`}, saved by {row.draft.saved_by}, {formatWhen(row.draft.saved_utc)}.{' '}
          {row.draft.errors > 0
            ? <span className="state tone-bad"><Icon name="octagon" /><span>{formatCount(row.draft.errors, 'problem')}</span></span>
            : <span className="state tone-ok"><Icon name="tick" /><span>No problems</span></span>}
        </p>
      )}
      {row.versions.length > 0 && <Versions row={row} onAsk={onAsk} />}
    </section>
  );
}

function Versions({row, onAsk}: {row: CurriculumRow; onAsk: (asked: Asked) => void}) {
  return (
    <details className={styles.versions}>
      <summary className="small">{formatCount(row.versions.length, 'version')}</summary>
      <div className="table-scroll">
        <table className="table">
          <thead><tr><th scope="col">Version</th><th scope="col">Status</th><th scope="col">Published</th><th scope="col" className="r">Exercises</th><th scope="col" className="r">Trials</th><th scope="col"><span className="visually-hidden">Actions</span></th></tr></thead>
          <tbody>
            {row.versions.map((version, index) => {
              const before = row.versions[index + 1];
              return (
                <tr key={version.version}>
                  <th scope="row"><Link href={paths.curriculum(row.id, version.version)}>{version.version}</Link></th>
                  <td>{version.status === 'published' ? 'Published' : version.status === 'retired' ? 'Retired' : 'Draft'}</td>
                  <td className="muted">{row.built_in ? 'with the program' : formatWhen(version.published_utc)}</td>
                  <td className="r">{version.exercises}</td>
                  <td className="r">{version.trials}</td>
                  <td className="r">
                    {before && <Link href={paths.curriculumDiff(row.id, before.version, version.version)}>Changes since {before.version}</Link>}{' '}
                    {!row.built_in && version.status === 'published' && (
                      <button type="button" className={styles.link} onClick={() => onAsk({what: 'retire', row, version: version.version})}>Retire<span className="visually-hidden"> {version.version}</span></button>
                    )}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </details>
  );
}

interface QuestionProps {
  asked: Asked;
  curricula: CurriculumRow[];
  onClose: () => void;
  onDone: () => void;
}

function Question({asked, curricula, onClose, onDone}: QuestionProps) {
  const {api} = useSignedIn();
  const [, navigate] = useLocation();
  const action = useAction();
  const [id, setId] = useState('');
  const {row} = asked;
  const common = {busy: action.busy, problem: action.problem, onClose};
  if (asked.what === 'copy') {
    const wrong = id === '' ? '' : curricula.some((one) => one.id === id) ? 'There is a curriculum of this id. Choose another.'
      : /^[a-z][a-z0-9_-]{0,63}$/.test(id) ? '' : 'Use small letters, digits, "-" and "_", beginning with a letter.';
    const copy = () => {
      if (id === '' || wrong !== '') return;
      action.run(() => api.copyCurriculum({from_id: row.id, from_version: row.published_version ?? '', new_id: id}), () => navigate(paths.curriculum(id)));
    };
    return (
      <Confirm title={`Copy ${row.title}`} action="Copy" onConfirm={copy} {...common}>
        <p className="small">The copy is a draft of your own. It changes nothing for anybody until it is published.</p>
        <TextInput label="Id of the copy" description="Never changes afterwards, because records name it." value={id} error={wrong === '' ? false : wrong}
          placeholder="our-basics" onChange={(event) => setId(event.currentTarget.value.trim())} onKeyDown={(event) => { if (event.key === 'Enter') copy(); }} />
      </Confirm>
    );
  }
  if (asked.what === 'default') {
    const now = curricula.find((one) => one.is_default);
    return (
      <Confirm title={`Make ${row.title} the default?`} action="Make default" onConfirm={() => action.run(() => api.setDefaultCurriculum(row.id), onDone)} {...common}>
        <p className="small">Whoever is assigned no curriculum of their own trains by it from the next trial on{now ? `, instead of ${now.title} (${formatCount(now.people, 'person', 'people')} now)` : ''}. What was recorded stays.</p>
      </Confirm>
    );
  }
  if (asked.what === 'retire') {
    return (
      <Confirm title={`Retire ${asked.version}?`} action="Retire" onConfirm={() => action.run(() => api.retireCurriculum(row.id, asked.version), onDone)} {...common}>
        <p className="small">Nobody can be assigned it any more. {row.people === 0 ? 'Nobody trains by it now.' : `${formatCount(row.people, 'person trains', 'people train')} by this curriculum now.`} Trials made under it stay as they are.</p>
      </Confirm>
    );
  }
  return (
    <Confirm title={`Delete the draft of ${row.title}?`} action="Delete draft" onConfirm={() => action.run(() => api.deleteDraft(row.id), onDone)} {...common}>
      <p className="small">Its text is lost. Published versions and trials stay.</p>
    </Confirm>
  );
}
