import type {ReactNode} from 'react';
import type {Briefing} from '../wire/types';
import styles from './Overlay.module.css';
import {keyboardSpeeds} from './handle_keys';
import type {OverlayKind} from './overlay_state';
import {endSentence} from './readings';
import type {TrialSnapshot} from './trial_store';

interface Props {
  kind: OverlayKind;
  briefing: Briefing;
  snapshot: TrialSnapshot;
  onResume: () => void;
  onEnd: () => void;
  onAskEnd: () => void;
  onClose: () => void;
  onTryAgain: () => void;
  onTraining: () => void;
  onDebrief: () => void;
}

interface Content {
  title: string;
  body: ReactNode;
  primary?: {name: string; act: () => void};
  second?: {name: string; act: () => void};
}

/** The one notice over the picture. Its first button has the focus, so that Enter presses it. */
export function Overlay(props: Props) {
  const {title, body, primary, second} = contentOf(props);
  return (
    <div className={styles.veil} data-testid="overlay" data-kind={props.kind}>
      <div className={styles.card} role="dialog" aria-labelledby="overlay-title" data-wide={props.kind === 'controls'}>
        <h2 id="overlay-title">{title}</h2>
        <div className={styles.body}>{body}</div>
        {(primary ?? second) && (
          <div className={styles.buttons}>
            {primary && <button key={props.kind} type="button" className={styles.primary} autoFocus onClick={primary.act}>{primary.name}</button>}
            {second && <button type="button" className={styles.second} onClick={second.act}>{second.name}</button>}
          </div>
        )}
      </div>
    </div>
  );
}

function contentOf(props: Props): Content {
  const {kind, briefing, snapshot, onResume, onEnd, onAskEnd, onClose, onTryAgain, onTraining, onDebrief} = props;
  const step = briefing.steps[snapshot.frame?.step_index ?? 0];
  switch (kind) {
    case 'loading':
      return {title: 'Opening the trial', body: <p>Connecting to the simulation.</p>};
    case 'start':
      return {
        title: `First: ${step?.title ?? briefing.title}`,
        body: (
          <>
            <p>{briefing.goal}</p>
            <p>The clock starts when the handle first moves.</p>
            <p className={styles.hint}>Press Enter or click to start.</p>
          </>
        ),
        primary: {name: 'Start', act: onResume},
      };
    case 'paused':
      return {
        title: 'Paused',
        body: <p>The simulation stands still. The pause is noted in the record.</p>,
        primary: {name: 'Resume', act: onResume},
        second: {name: 'End trial', act: onAskEnd},
      };
    case 'restored':
      return {
        title: 'Connected again',
        body: <p>The trial was paused while the connection was lost. Nothing has moved.</p>,
        primary: {name: 'Resume', act: onResume},
      };
    case 'lost':
      return {
        title: 'Connection lost: the trial is paused',
        body: <p>Nothing moves until you are back. Trying again by itself.</p>,
        primary: {name: 'Try now', act: onTryAgain},
      };
    case 'second_tab':
      return {
        title: 'This trial is being steered in another tab',
        body: <p>Go on in that tab, or close it and try here again. The trial pauses when it is closed.</p>,
        primary: {name: 'Try here again', act: onTryAgain},
        second: {name: 'My training', act: onTraining},
      };
    case 'gone':
      return {
        title: 'This trial is not running any more',
        body: <p>It has ended, or the server was started anew. What was recorded is in its debrief.</p>,
        primary: {name: 'See the debrief', act: onDebrief},
        second: {name: 'My training', act: onTraining},
      };
    case 'signed_out':
      return {
        title: 'You are signed out: the trial is paused',
        body: <p>Sign in again to go on with it.</p>,
        primary: {name: 'Sign in', act: () => location.reload()},
      };
    case 'ended':
      return {
        title: 'The trial has ended',
        body: (
          <>
            <p>{snapshot.frame ? endSentence(snapshot.frame) : ''} The record is being filed; the debrief opens by itself.</p>
            {snapshot.problem && <p className={styles.hint} role="alert">{snapshot.problem}</p>}
          </>
        ),
        second: snapshot.problem ? {name: 'My training', act: onTraining} : undefined,
      };
    case 'confirm_end':
      return {
        title: 'End this trial?',
        body: <p>It is filed as ended early and cannot be continued.</p>,
        primary: {name: 'Keep going', act: onClose},
        second: {name: 'End trial', act: onEnd},
      };
    case 'controls':
      return {title: 'All controls', body: <ControlTable />, primary: {name: 'Close', act: onClose}};
  }
}

const {normal, fine} = keyboardSpeeds;

const controlRows: readonly [string, string][] = [
  ['↑  ↓', `Feed and retract, ${normal.feed_mm_s} mm/s`],
  ['←  →', `Turn counter-clockwise and clockwise, ${normal.turn_deg_s}°/s`],
  ['Shift', `Fine: ${fine.feed_mm_s} mm/s and ${fine.turn_deg_s}°/s`],
  ['Drag the handle', 'Up and down feeds, sideways turns; with Shift ten times finer'],
  ['Wheel on the handle', 'Feeds a millimetre a notch; with Shift a tenth'],
  ['Drag the picture', 'Turns the view'],
  ['Wheel, +  −', 'Zoom'],
  ['F', 'Whole vessel or follow the tip'],
  ['T', 'Instrument in true size'],
  ['0', 'Reset the view'],
  ['P', 'Pause and resume'],
  ['Esc', 'End the trial, after asking'],
];

function ControlTable() {
  return (
    <table className={styles.controls}>
      <tbody>
        {controlRows.map(([key, what]) => <tr key={key}><th scope="row">{key}</th><td>{what}</td></tr>)}
      </tbody>
    </table>
  );
}
