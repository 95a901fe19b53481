import {Button} from '@mantine/core';
import {useState} from 'react';
import {Link, useLocation, useSearch} from 'wouter';
import {Editor} from '../curriculum/Editor';
import {TextDesk} from '../curriculum/text/desk';
import {TextView} from '../curriculum/text/TextView';
import {ErrorState} from '../parts/ErrorState';
import {Loaded} from '../parts/Loaded';
import {useResource} from '../parts/api';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import type {CurriculumText} from '../wire/types';
import styles from './curricula.module.css';

/** One curriculum: its draft in the editor, or a version to read. */
export default function CurriculumPage({id}: {id: string}) {
  const version = new URLSearchParams(useSearch()).get('version') ?? 'draft';
  useTitle(version === 'draft' ? `Edit ${id}` : `${id} ${version}`);
  return version === 'draft' ? <Draft id={id} /> : <Version id={id} version={version} />;
}

function Draft({id}: {id: string}) {
  const [, navigate] = useLocation();
  const resource = useResource(`draft ${id}`, async (api) => {
    const [draft, catalogue, {curricula}] = await Promise.all([api.curriculum(id, 'draft'), api.catalogue(), api.curricula()]);
    return {draft, catalogue, row: curricula.find((one) => one.id === id) ?? null};
  });
  if (resource.state === 'failed') {
    return (
      <div className="page stack">
        <ErrorState problem={resource.problem} onRetry={resource.retry} />
        <p><Link href={paths.curricula}>Back to the curricula</Link></p>
      </div>
    );
  }
  if (resource.state === 'loading') return <div className="page"><Loaded resource={resource} what="the draft">{() => null}</Loaded></div>;
  return <Editor {...resource.value} onPublished={() => navigate(paths.curricula)} />;
}

function Version({id, version}: {id: string; version: string}) {
  const resource = useResource(`curriculum ${id} ${version}`, (api) => api.curriculum(id, version));
  return <div className="page"><Loaded resource={resource} what="the version">{(text) => <ReadOnly text={text} />}</Loaded></div>;
}

function ReadOnly({text}: {text: CurriculumText}) {
  const [desk] = useState(() => new TextDesk({
    text: text.yaml, readOnly: true, label: 'Text of the curriculum',
    nonce: document.querySelector<HTMLMetaElement>('meta[name="csp-nonce"]')?.content ?? '',
  }));
  return (
    <>
      <div className="page-head">
        <h1>{text.title}</h1><span className="tag num">{text.version}</span><span className="tag">{text.built_in ? 'Built-in' : text.status}</span>
        <span className="grow" /><Button variant="default" component={Link} href={paths.curricula}>Back</Button>
      </div>
      <section className={`panel ${styles.text}`} aria-label="Text">
        <TextView desk={desk} hint={`To read. SHA-256 ${text.sha256.slice(0, 12)}. Copy it, or begin a new version, to change it.`} />
      </section>
    </>
  );
}
