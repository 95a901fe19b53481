import {Link} from 'wouter';
import {Loaded} from '../parts/Loaded';
import {KindTag, levelWord} from '../parts/PersonFacts';
import {ProgressSections} from '../parts/ProgressSections';
import {useResource} from '../parts/api';
import {formatCount, formatWhen} from '../parts/format';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import type {ProgressReport} from '../wire/types';

/** How does this person's skill grow? */
export function Person({personId}: {personId: string}) {
  const resource = useResource(`progress ${personId}`, (api) => api.progress(personId));
  return <Loaded resource={resource} what="this person">{(report) => <Page report={report} />}</Loaded>;
}

function Page({report}: {report: ProgressReport}) {
  const {person} = report;
  useTitle(person.display_name);
  return (
    <>
      <nav className="crumbs" aria-label="Breadcrumb">
        <ol><li><Link href={paths.people}>People</Link></li><li aria-hidden="true">/</li><li>{person.display_name}</li></ol>
      </nav>
      <div className="page-head">
        <h1>{person.display_name}</h1>
        <KindTag kind={person.kind} />
        <span className="muted num">
          {[`level ${levelWord(person.level)}`, ...person.groups, formatCount(person.trials, 'trial'),
            ...(person.kind === 'published' ? [] : [`last ${formatWhen(person.last_trial_utc)}`])].join(' · ')}
        </span>
      </div>
      <ProgressSections exercises={report.exercises} own={false} />
    </>
  );
}
