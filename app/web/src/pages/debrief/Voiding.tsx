import {Button, Textarea} from '@mantine/core';
import {useState} from 'react';
import {Confirm} from '../../parts/Confirm';
import {Icon} from '../../parts/Icon';
import {useSignedIn} from '../../parts/api';
import {formatWhen} from '../../parts/format';
import {useAction} from '../../parts/use_action';
import type {Debrief} from '../../wire/types';
import {reasonProblem} from './judgement';
import styles from './judgement.module.css';

/** Who took the trial out of what counts, when and why: the same words for everybody who may see it. */
export function VoidedBanner({debrief}: {debrief: Debrief}) {
  if (!debrief.void) return null;
  const {voided_by, voided_utc, reason} = debrief.void;
  return (
    <section className={`panel ${styles.banner}`} aria-label="Voided">
      <Icon name="dash" />
      <div>
        <p className="strong num">Voided by {voided_by}, {formatWhen(voided_utc)}</p>
        <p className={styles.words}>{reason}</p>
        <p className="small muted">It does not count: not for proficiency, not in comparisons, not as a trial of its day. What was measured is kept below.</p>
      </div>
    </section>
  );
}

interface Props {
  debrief: Debrief;
  onChange: (debrief: Debrief) => void;
}

/** Takes a finished trial out of what counts, with a reason that the person reads. */
export function VoidTrial({debrief, onChange}: Props) {
  const [open, setOpen] = useState(false);
  if (!debrief.may_judge || debrief.void || debrief.trial.end_reason === null) return null;
  return (
    <>
      <Button variant="default" onClick={() => setOpen(true)}>Void this trial…</Button>
      {open && <Ask debrief={debrief} onChange={onChange} onClose={() => setOpen(false)} />}
    </>
  );
}

function Ask({debrief, onChange, onClose}: Props & {onClose: () => void}) {
  const {api} = useSignedIn();
  const {busy, problem, run} = useAction();
  const [reason, setReason] = useState('');
  const [tried, setTried] = useState(false);
  const wrong = reasonProblem(reason);
  const confirm = () => {
    setTried(true);
    if (wrong !== '') return;
    run(() => api.voidTrial(debrief.trial.trial_id, {reason: reason.trim()}), (changed) => {
      onClose();
      onChange(changed);
    });
  };
  return (
    <Confirm title={`Void trial ${debrief.trial.ordinal} of ${debrief.person_name}?`} action="Void the trial" busy={busy} problem={problem}
      onConfirm={confirm} onClose={onClose}>
      <ul className={styles.what}>
        <li>The trial no longer counts for proficiency or in comparisons. A pass in it is lost, and so may be what it unlocked.</li>
        <li>It does not use up one of the trials of its day.</li>
        <li>Nothing is deleted: the recording, the measurements and the comments stay, and the trial stays in the list, marked as voided.</li>
        <li>{debrief.person_name} sees who voided it, when, and your reason.</li>
        <li>It cannot be undone.</li>
      </ul>
      <Textarea label="Reason" description="10 to 500 characters" required autosize minRows={3} maxRows={8} value={reason}
        error={tried && wrong !== '' ? wrong : undefined} onChange={(event) => setReason(event.currentTarget.value)} />
    </Confirm>
  );
}
