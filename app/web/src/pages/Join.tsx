import {Button, PasswordInput, TextInput} from '@mantine/core';
import {useEffect, useState, type FormEvent} from 'react';
import {Loading} from '../parts/Loading';
import {Problem} from '../parts/Problem';
import {formatWhen} from '../parts/format';
import {useAction} from '../parts/use_action';
import {useTitle} from '../parts/use_title';
import type {Api} from '../wire/api';
import type {InvitationGreeting, Session} from '../wire/types';
import styles from './entrance.module.css';

interface Props {
  api: Api;
  /** Who is signed in in this browser already, if anybody. */
  present: Session | null;
  onDone: (session: Session) => void;
}

type Look = {state: 'looking'} | {state: 'known'; greeting: InvitationGreeting} | {state: 'refused'; sentence: string};

/** A person comes in through the one-time link and sets the own password. */
export function Join({api, present, onDone}: Props) {
  useTitle('Welcome');
  const [token] = useState(() => new URLSearchParams(window.location.search).get('token') ?? '');
  const [look, setLook] = useState<Look>(token === ''
    ? {state: 'refused', sentence: 'The link is not complete. Open the whole link that your administrator gave you.'}
    : {state: 'looking'});

  useEffect(() => {
    if (token === '') return;
    let stale = false;
    api.invitation(token).then(
      (greeting) => { if (!stale) setLook({state: 'known', greeting}); },
      (reason: unknown) => { if (!stale) setLook({state: 'refused', sentence: reason instanceof Error ? reason.message : String(reason)}); });
    return () => { stale = true; };
  }, [api, token]);

  if (look.state === 'looking') return <main className="page"><Loading what="your invitation" /></main>;
  return (
    <main className={styles.entrance}>
      <div className={styles.card}>
        <p className={styles.brand}>Cathedra</p>
        {look.state === 'refused'
          ? (
            <>
              <h1>This link does not work</h1>
              <p className="muted">{look.sentence}</p>
              <p><a href="/">Go to the sign-in</a></p>
            </>
          )
          : <Welcome api={api} token={token} greeting={look.greeting} present={present} onDone={onDone} />}
      </div>
    </main>
  );
}

interface WelcomeProps extends Props {
  token: string;
  greeting: InvitationGreeting;
}

function Welcome({api, token, greeting, present, onDone}: WelcomeProps) {
  const action = useAction();
  const [password, setPassword] = useState('');
  const [again, setAgain] = useState('');
  const [differs, setDiffers] = useState(false);
  const submit = (event: FormEvent) => {
    event.preventDefault();
    setDiffers(password !== again);
    if (password === again) action.run(() => api.acceptInvitation({token, password}), onDone);
  };
  return (
    <>
      <h1>Welcome, {greeting.display_name}</h1>
      <p className="muted">
        Choose a password; from then on you sign in with it and the name below. The link works once, until <span className="num">{formatWhen(greeting.expires_utc)}</span>.
      </p>
      {present && <p className="muted">{present.display_name} is signed in here now and will be signed out.</p>}
      <form className={styles.form} onSubmit={submit}>
        <TextInput label="Your sign-in name" name="name" autoComplete="username" readOnly value={greeting.name} />
        <PasswordInput label="Password" description="Eight characters or more; a sentence is easier to remember" autoComplete="new-password"
          autoFocus required withAsterisk={false} minLength={8} maxLength={128} value={password}
          onChange={(event) => setPassword(event.currentTarget.value)} />
        <PasswordInput label="Password again" autoComplete="new-password" required withAsterisk={false} value={again}
          onChange={(event) => setAgain(event.currentTarget.value)} />
        <Problem sentence={differs ? 'The two passwords differ. Type the same one twice.' : action.problem} />
        <Button type="submit" loading={action.busy} fullWidth>Set the password and sign in</Button>
      </form>
    </>
  );
}
