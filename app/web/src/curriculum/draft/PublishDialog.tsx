import {Button} from '@mantine/core';
import {Dialog} from '../../parts/Dialog';
import {Problem} from '../../parts/Problem';
import {useResource, useSignedIn} from '../../parts/api';
import {Loaded} from '../../parts/Loaded';
import {formatCount} from '../../parts/format';
import {useAction} from '../../parts/use_action';
import type {CurriculumRow, CurriculumText} from '../../wire/types';
import {Changes} from '../diff/Changes';
import type {DraftSaver} from './draft_saver';

interface Props {
  draft: CurriculumText;
  row: CurriculumRow | null;
  version: string;
  saver: DraftSaver;
  onClose: () => void;
  onPublished: () => void;
}

/** What publishing changes, and for whom. */
export function PublishDialog({draft, row, version, saver, onClose, onPublished}: Props) {
  const {api} = useSignedIn();
  const action = useAction();
  const published = row?.published_version ?? null;
  const people = row?.people ?? 0;
  const publish = () => action.run(async () => {
    await saver.saveNow();
    if (!saver.isSaved) throw new Error('The draft could not be saved, so that nothing was published. Save it first.');
    return api.publishDraft(draft.id, {sha256: saver.savedSha256});
  }, onPublished);
  return (
    <Dialog title={`Publish ${version}?`} onClose={onClose} actions={(
      <>
        <Button loading={action.busy} onClick={publish}>Publish {version}</Button>
        <Button variant="default" onClick={onClose}>Cancel</Button>
      </>
    )}>
      {published === null
        ? <p className="small">This is its first version. Nobody trains by it until it is assigned or made the default.</p>
        : <SavedDiff id={draft.id} from={published} saver={saver} />}
      {published !== null && (
        <p className="small">
          {people === 0 ? 'Nobody trains by this curriculum now.' : `${formatCount(people, 'person trains', 'people train')} by this curriculum and will go on with ${version}.`}{' '}
          Trials made before keep the version they were made under.
        </p>
      )}
      <p className="small muted">A published version never changes.</p>
      <Problem sentence={action.problem} />
    </Dialog>
  );
}

function SavedDiff({id, from, saver}: {id: string; from: string; saver: DraftSaver}) {
  const diff = useResource(`publish ${id} ${from}`, async (api) => {
    await saver.saveNow();
    return api.curriculumDiff(id, from, 'draft');
  });
  return <Loaded resource={diff} what="the changes">{(value) => <><p className="small">Since {from}:</p><Changes diff={value} /></>}</Loaded>;
}
