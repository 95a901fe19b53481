import {Icon} from '../parts/Icon';
import type {Connection} from './live_channel';
import styles from './TopBar.module.css';
import type {TrialSnapshot} from './trial_store';

interface Props {
  title: string;
  ordinal: number;
  person: string;
  snapshot: TrialSnapshot;
  canPause: boolean;
  canEnd: boolean;
  onPause: () => void;
  onEnd: () => void;
}

/** Which trial this is, whether the line holds, and the two ways out. */
export function TopBar({title, ordinal, person, snapshot, canPause, canEnd, onPause, onEnd}: Props) {
  return (
    <header className={styles.bar}>
      <span className={styles.brand}>
        <svg width="20" height="20" viewBox="0 0 20 20" aria-hidden="true">
          <path d="M3 17C3 9 8 11 10 7s4-5 7-4" /><circle cx="17" cy="3" r="1.2" />
        </svg>
        Cathedra
      </span>
      <i className={styles.rule} />
      <h1>{title}</h1>
      <span className={styles.who}>Trial {ordinal} · {person}</span>
      {snapshot.problem && <span className={styles.problem} role="status">{snapshot.problem}</span>}
      <span className={styles.grow} />
      <ConnectionState connection={snapshot.connection} latency_ms={snapshot.latency_ms} />
      <i className={styles.rule} />
      <button type="button" disabled={!canPause} onClick={onPause}>Pause</button>
      <button type="button" disabled={!canEnd} onClick={onEnd}>End trial</button>
    </header>
  );
}

const words: Record<Connection, string> = {
  connecting: 'Connecting',
  open: 'Connected',
  lost: 'Connection lost',
  second_tab: 'In another tab',
  gone: 'Not running',
  signed_out: 'Signed out',
  closed: 'Closed',
};

function ConnectionState({connection, latency_ms}: {connection: Connection; latency_ms: number | null}) {
  const tone = connection === 'open' ? 'tone-ok' : connection === 'connecting' ? 'tone-idle' : 'tone-bad';
  const icon = connection === 'open' ? 'tick' : connection === 'connecting' ? 'circle' : 'octagon';
  return (
    <span className={`state ${tone} ${styles.connection}`} data-testid="connection" data-state={connection}>
      <Icon name={icon} />
      {words[connection]}
      <span className={styles.latency}>{latency_ms !== null && `${Math.max(1, Math.round(latency_ms))} ms`}</span>
    </span>
  );
}
