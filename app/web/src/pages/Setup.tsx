import {Button, PasswordInput, TextInput} from '@mantine/core';
import {useState, type FormEvent} from 'react';
import {Icon} from '../parts/Icon';
import type {Api} from '../wire/api';
import type {Session} from '../wire/types';
import styles from './entrance.module.css';

interface Props {
  api: Api;
  needed: boolean;
  onDone: (session: Session) => void;
}

/** The first administrator of a new site, with the one-time link that the server printed. */
export function Setup({api, needed, onDone}: Props) {
  const [token] = useState(() => new URLSearchParams(window.location.search).get('token') ?? '');
  const [name, setName] = useState('');
  const [password, setPassword] = useState('');
  const [again, setAgain] = useState('');
  const [problem, setProblem] = useState('');
  const [busy, setBusy] = useState(false);

  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (password !== again) {
      setProblem('The two passwords differ. Type the same one twice.');
      return;
    }
    setBusy(true);
    setProblem('');
    api.setUp({token, name: name.trim(), password}).then(onDone, (reason: unknown) => {
      setProblem(reason instanceof Error ? reason.message : String(reason));
      setBusy(false);
    });
  };

  return (
    <main className={styles.entrance}>
      <div className={styles.card}>
        <p className={styles.brand}>Cathedra</p>
        <h1>Set up this site</h1>
        {!needed && <p className="muted">This site is set up already. <a href="/">Sign in</a> instead.</p>}
        {needed && token === '' && (
          <p className="muted">Open the set-up link that the server printed when it started; it holds a one-time key.</p>
        )}
        {needed && token !== '' && (
          <form className={styles.form} onSubmit={submit}>
            <p className="muted">You become the first administrator. The link works once.</p>
            <TextInput label="Name" autoComplete="username" autoFocus required withAsterisk={false} value={name}
              onChange={(event) => setName(event.currentTarget.value)} />
            <PasswordInput label="Password" description="Twelve characters or more" autoComplete="new-password" required withAsterisk={false}
              minLength={12} value={password} onChange={(event) => setPassword(event.currentTarget.value)} />
            <PasswordInput label="Password again" autoComplete="new-password" required withAsterisk={false} value={again}
              onChange={(event) => setAgain(event.currentTarget.value)} />
            <div role="alert">
              {problem !== '' && <p className={`tone-bad ${styles.problem}`}><Icon name="octagon" />{problem}</p>}
            </div>
            <Button type="submit" loading={busy} fullWidth>Create the administrator</Button>
          </form>
        )}
      </div>
    </main>
  );
}
