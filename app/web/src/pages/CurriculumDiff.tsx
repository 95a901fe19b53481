import {Link, useSearch} from 'wouter';
import {Changes} from '../curriculum/diff/Changes';
import {DiffLines} from '../curriculum/diff/DiffLines';
import {EmptyState} from '../parts/EmptyState';
import {Loaded} from '../parts/Loaded';
import {Panel} from '../parts/Panel';
import {useResource} from '../parts/api';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';

/** What changed between two versions, in sentences and line by line. */
export function CurriculumDiff({id}: {id: string}) {
  const search = new URLSearchParams(useSearch());
  const from = search.get('from') ?? '';
  const to = search.get('to') ?? 'draft';
  useTitle(`Changes of ${id}`);
  const resource = useResource(`diff ${id} ${from} ${to}`, (api) => api.curriculumDiff(id, from, to));
  const word = to === 'draft' ? 'the draft' : to;
  return (
    <>
      <nav className="crumbs" aria-label="Breadcrumb">
        <ol><li><Link href={paths.curricula}>Curricula</Link></li><li aria-hidden="true">/</li><li><Link href={paths.curriculum(id, to)}>{id}</Link></li><li aria-hidden="true">/</li><li>Changes</li></ol>
      </nav>
      <div className="page-head"><h1>From {from} to {word}</h1></div>
      <Loaded resource={resource} what="the changes">
        {(diff) => (
          <div className="stack">
            <Panel title="What changed"><Changes diff={diff} /></Panel>
            <Panel title="Line by line">
              {diff.lines.length === 0 ? <EmptyState title="No line differs">Both texts are the same.</EmptyState> : <DiffLines lines={diff.lines} from={from} to={word} />}
            </Panel>
          </div>
        )}
      </Loaded>
    </>
  );
}
