import {Button} from '@mantine/core';
import {useState} from 'react';
import {Confirm} from '../../parts/Confirm';
import {Dialog} from '../../parts/Dialog';
import {OneTimeLink} from '../../parts/OneTimeLink';
import {useSignedIn} from '../../parts/api';
import {useAction} from '../../parts/use_action';
import type {Invitation, PersonDetail} from '../../wire/types';
import styles from './administration.module.css';

/** A new one-time link, for a lost one or a forgotten password: first what it does, then the link. */
export function LinkDialog({detail, onClose}: {detail: PersonDetail; onClose: (made: boolean) => void}) {
  const {api} = useSignedIn();
  const action = useAction();
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const {person} = detail;
  if (invitation !== null) {
    return (
      <Dialog key="link" title={`New link for ${person.display_name}`} onClose={() => onClose(true)}
        actions={<Button variant="default" onClick={() => onClose(true)}>Done</Button>}>
        <OneTimeLink invitation={invitation} />
      </Dialog>
    );
  }
  return (
    <Confirm title={`New link for ${person.display_name}?`} action="Make the link" busy={action.busy} problem={action.problem}
      onClose={() => onClose(false)} onConfirm={() => action.run(() => api.inviteAgain(person.person_id), setInvitation)}>
      <ul className={styles.what}>
        <li>The new link sets a new password, once.</li>
        {detail.invitation_expires_utc !== null && <li>The link that was made before stops working.</li>}
        {detail.can_sign_in && <li>Until it is used, the present password keeps working.</li>}
      </ul>
    </Confirm>
  );
}
