import {Button, PasswordInput, TextInput} from '@mantine/core';
import {useState, type FormEvent} from 'react';
import {Icon} from '../parts/Icon';
import type {Api} from '../wire/api';
import type {DemoAccount, Session, Site} from '../wire/types';
import styles from './entrance.module.css';

interface Props {
  api: Api;
  site: Site;
  onDone: (session: Session) => void;
}

export function SignIn({api, site, onDone}: Props) {
  const [name, setName] = useState('');
  const [password, setPassword] = useState('');
  const [problem, setProblem] = useState('');
  const [busy, setBusy] = useState(false);

  const submit = (event: FormEvent) => {
    event.preventDefault();
    setBusy(true);
    setProblem('');
    api.signIn({name: name.trim(), password}).then(onDone, (reason: unknown) => {
      setProblem(reason instanceof Error ? reason.message : String(reason));
      setPassword('');
      setBusy(false);
    });
  };
  const use = (account: DemoAccount) => {
    setName(account.name);
    setPassword(account.password);
    setProblem('');
  };

  return (
    <main className={styles.entrance}>
      <div className={styles.card}>
        <p className={styles.brand}>Cathedra</p>
        <h1>Sign in</h1>
        <form className={styles.form} onSubmit={submit}>
          <TextInput label="Name" name="name" autoComplete="username" autoFocus required withAsterisk={false} value={name}
            onChange={(event) => setName(event.currentTarget.value)} />
          <PasswordInput label="Password" name="password" autoComplete="current-password" required withAsterisk={false} value={password}
            onChange={(event) => setPassword(event.currentTarget.value)} />
          <div role="alert">
            {problem !== '' && <p className={`tone-bad ${styles.problem}`}><Icon name="octagon" />{problem}</p>}
          </div>
          <Button type="submit" loading={busy} fullWidth>Sign in</Button>
        </form>
        {site.demo_accounts.length > 0 && <DemoAccounts accounts={site.demo_accounts} onUse={use} />}
      </div>
      <p className="xs faint">Cathedra {site.version}. A training tool; its values are not clinical.</p>
    </main>
  );
}

function DemoAccounts({accounts, onUse}: {accounts: DemoAccount[]; onUse: (account: DemoAccount) => void}) {
  return (
    <section className={styles.accounts} aria-labelledby="demo-accounts">
      <h2 id="demo-accounts">Demo accounts</h2>
      <p className="small muted">Choose one to fill in its name and password.</p>
      <ul>
        {accounts.map((account) => (
          <li key={account.name}>
            <button type="button" className={styles.account} onClick={() => onUse(account)}>
              <span className="strong">{account.name}</span>
              <span className="muted">{account.role}</span>
              <span className="mono faint">{account.password}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
