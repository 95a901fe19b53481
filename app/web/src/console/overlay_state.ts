// Which notice, if any, lies over the picture. One at a time, the most pressing first.
import type {TrialSnapshot} from './trial_store';

export type OverlayKind =
  | 'loading'
  | 'signed_out'
  | 'gone'
  | 'second_tab'
  | 'lost'
  | 'ended'
  | 'confirm_end'
  | 'controls'
  | 'start'
  | 'restored'
  | 'paused';

/** What the person opened. */
export type Opened = 'confirm_end' | 'controls' | null;

export function overlayOf(snapshot: TrialSnapshot, opened: Opened): OverlayKind | null {
  const {connection, frame} = snapshot;
  if (snapshot.filed || frame?.ended) return 'ended';
  if (connection === 'signed_out' || connection === 'gone' || connection === 'second_tab' || connection === 'lost') {
    return connection;
  }
  if (!frame || connection !== 'open') return 'loading';
  if (opened) return opened;
  if (!frame.paused) return null;
  if (frame.time_s === 0) return 'start';
  return snapshot.interrupted ? 'restored' : 'paused';
}

/** The hand steers only when nothing lies over the picture. */
export function isSteering(snapshot: TrialSnapshot, opened: Opened): boolean {
  return overlayOf(snapshot, opened) === null;
}
