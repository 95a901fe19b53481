import {Button, Modal} from '@mantine/core';
import {useState} from 'react';
import {OneTimeLink} from '../../parts/OneTimeLink';
import {Problem} from '../../parts/Problem';
import {useSignedIn} from '../../parts/api';
import {useAction} from '../../parts/use_action';
import type {Invitation, PersonDetail} from '../../wire/types';
import dialog from '../../parts/modal.module.css';
import styles from './administration.module.css';

interface Props {
  opened: boolean;
  detail: PersonDetail;
  onClose: (made: boolean) => void;
}

/** A new one-time link, for a lost one or a forgotten password: first what it does, then the link. */
export function LinkDialog({opened, detail, onClose}: Props) {
  const {api} = useSignedIn();
  const action = useAction();
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const {person} = detail;
  const close = () => {
    onClose(invitation !== null);
    setInvitation(null);
    action.forget();
  };
  return (
    <Modal opened={opened} onClose={close} size="lg" centered closeOnClickOutside={invitation === null} title={`New link for ${person.display_name}`}
      classNames={{title: dialog.title}} closeButtonProps={{'aria-label': 'Close'}}>
      {invitation !== null
        ? (
          <>
            <OneTimeLink invitation={invitation} />
            <div className={dialog.buttons}><Button variant="default" onClick={close}>Done</Button></div>
          </>
        )
        : (
          <div className={dialog.body}>
            <ul className={styles.what}>
              <li>The new link sets a new password, once.</li>
              {detail.invitation_expires_utc !== null && <li>The link that was made before stops working.</li>}
              {detail.can_sign_in && <li>Until it is used, the present password keeps working.</li>}
            </ul>
            <Problem sentence={action.problem} />
            <div className={dialog.buttons}>
              <Button variant="default" onClick={close}>Cancel</Button>
              <Button loading={action.busy} data-autofocus onClick={() => action.run(() => api.inviteAgain(person.person_id), setInvitation)}>
                Make the link
              </Button>
            </div>
          </div>
        )}
    </Modal>
  );
}
