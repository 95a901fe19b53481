import {Button, TextInput} from '@mantine/core';
import {useRef, useState} from 'react';
import type {Invitation} from '../wire/types';
import {formatWhen} from './format';
import {Icon} from './Icon';
import styles from './one_time_link.module.css';

/** The whole address that the person opens. */
export function addressOf(invitation: Invitation): string {
  return new URL(invitation.link, window.location.origin).href;
}

type Copied = 'no' | 'yes' | 'refused';

/** The link by which a person sets the own password: shown once, so that copying it must work. */
export function OneTimeLink({invitation}: {invitation: Invitation}) {
  const field = useRef<HTMLInputElement>(null);
  const [copied, setCopied] = useState<Copied>('no');
  const address = addressOf(invitation);
  const copy = () => {
    field.current?.select();
    // without TLS on another machine the browser has no clipboard for us: the text is selected at least
    const written = window.isSecureContext ? navigator.clipboard.writeText(address) : Promise.reject(new Error('no clipboard'));
    written.then(() => setCopied('yes'), () => setCopied('refused'));
  };
  return (
    <div className={styles.body}>
      <p>
        Give this link to {invitation.display_name}. It sets the password of <span className="strong">{invitation.name}</span>, works once,
        and until <span className="strong num">{formatWhen(invitation.expires_utc)}</span>. It is not shown again.
      </p>
      <div className={styles.link}>
        <TextInput ref={field} label="One-time link" readOnly value={address} onFocus={(event) => event.currentTarget.select()} />
        <Button onClick={copy} autoFocus>Copy</Button>
      </div>
      <p className="small" role="status">
        {copied === 'yes' && <span className="state tone-ok"><Icon name="tick" /><span>Copied</span></span>}
        {copied === 'refused' && <span className="muted">The browser does not let pages copy here. The link is selected: press Ctrl+C.</span>}
        {copied === 'no' && <span className="muted">Send it by a way that only this person reads.</span>}
      </p>
    </div>
  );
}
