import type {ReactNode} from 'react';
import {Link, useLocation} from 'wouter';
import {useSignedIn} from '../parts/api';
import {initialsOf} from '../parts/format';
import {isThere, navigationOf, paths} from '../parts/paths';
import {DemoBanner} from './DemoBanner';
import styles from './shell.module.css';

interface Props {
  demo: boolean;
  onSignedOut: () => void;
  children: ReactNode;
  /** The page fills the window and scrolls by itself. */
  wide?: boolean;
}

/** Bar, demo banner and page of every desk view. */
export function Shell({demo, onSignedOut, children, wide = false}: Props) {
  const {api, session} = useSignedIn();
  const [location] = useLocation();
  const entries = navigationOf(session.role);
  // a lost session is as good as a closed one
  const signOut = () => { api.signOut().then(onSignedOut, onSignedOut); };
  const sectionOf = (path: string) => location === path || location.startsWith(`${path}/`);
  const inTraining = location.startsWith('/exercises/') || location.startsWith('/trials/');
  return (
    <div className={wide ? styles.window : undefined}>
      <a className={styles.skip} href="#content">Skip to content</a>
      {demo && <DemoBanner />}
      <header className={styles.bar}>
        <Link className={styles.brand} href="/"><Mark />Cathedra</Link>
        <nav className={styles.nav} aria-label="Main">
          <ul>
            {entries.map((entry, index) => (
              <li key={entry.path}>
                <Link href={entry.path} aria-current={sectionOf(entry.path) || (index === 0 && inTraining) ? 'page' : undefined}>
                  {entry.label}
                </Link>
              </li>
            ))}
          </ul>
        </nav>
        <div className={styles.who}>
          {isThere(paths.settings)
            ? <Link className={styles.me} href={paths.settings} title="Settings"><Me name={session.display_name} /></Link>
            : <Me name={session.display_name} />}
          <button type="button" className={styles.out} onClick={signOut}>Sign out</button>
        </div>
      </header>
      <main id="content" className={wide ? styles.fill : 'page'} tabIndex={-1}>{children}</main>
    </div>
  );
}

function Me({name}: {name: string}) {
  return <><span>{name}</span><span className={styles.avatar} aria-hidden="true">{initialsOf(name)}</span></>;
}

export function Mark() {
  return (
    <svg width="20" height="20" viewBox="0 0 20 20" fill="none" stroke="var(--accent)" strokeWidth="2" strokeLinecap="round" aria-hidden="true">
      <path d="M3 17C3 9 8 11 10 7s4-5 7-4" />
      <circle cx="17" cy="3" r="1.2" fill="var(--accent)" />
    </svg>
  );
}
