import {Button} from '@mantine/core';
import {useState} from 'react';
import {Dialog} from '../../parts/Dialog';
import {Icon} from '../../parts/Icon';
import {formatWhen} from '../../parts/format';
import type {CurriculumText} from '../../wire/types';
import type {DraftSaver, Saving} from './draft_saver';
import styles from '../editor.module.css';

interface Props {
  saving: Saving;
  saver: DraftSaver;
  onTake: (theirs: CurriculumText) => void;
}

/** Why the draft is not saved, and what one can do; one's own text stays in every case. */
export function SavingProblem({saving, saver, onTake}: Props) {
  const [looking, setLooking] = useState(false);
  if (saving.kind === 'failed') {
    return (
      <p className={styles.notice} role="alert">
        <Icon name="triangle" /><span className="grow">{saving.sentence} Your text is kept here and is tried again.</span>
        <Button variant="default" onClick={() => void saver.saveNow()}>Save now</Button>
      </p>
    );
  }
  if (saving.kind !== 'conflict') return null;
  const {theirs} = saving;
  return (
    <>
      <p className={styles.notice} role="alert">
        <Icon name="triangle" />
        <span className="grow">
          {theirs ? `${theirs.saved_by} saved this draft (${formatWhen(theirs.saved_utc)}) while you were changing it.` : 'Somebody else changed this draft meanwhile.'} Your text is kept here.
        </span>
        {theirs && <Button variant="default" onClick={() => setLooking(true)}>Look at theirs</Button>}
        {theirs && <Button variant="default" onClick={() => void saver.overwrite(theirs)}>Overwrite with mine</Button>}
      </p>
      {looking && theirs && (
        <Dialog title={`As ${theirs.saved_by} saved it`} onClose={() => setLooking(false)} actions={(
          <>
            <Button onClick={() => { setLooking(false); onTake(theirs); }}>Take theirs (undo brings mine back)</Button>
            <Button variant="default" onClick={() => setLooking(false)}>Close</Button>
          </>
        )}>
          <pre className="mono" tabIndex={0} aria-label="Their text">{theirs.yaml}</pre>
        </Dialog>
      )}
    </>
  );
}
