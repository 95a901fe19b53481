// The keyboard of the console: handle keys to the hand, single keys to what the page does.
import {useEffect, useRef} from 'react';
import {afterKey, isHandleKey, type KeyState, noKeys, ratesOf} from './handle_keys';
import type {RunningTrial} from './running_trial';

/** What a key does besides steering. */
export type KeyAction = 'pause' | 'end' | 'controls' | 'view' | 'true_size' | 'reset' | 'closer' | 'further' | 'confirm';

const actions: Readonly<Record<string, KeyAction>> = {
  p: 'pause', Escape: 'end', '?': 'controls', f: 'view', t: 'true_size', '0': 'reset', Home: 'reset',
  '+': 'closer', '=': 'closer', '-': 'further', Enter: 'confirm',
};

/** Steers while `steering`; whatever takes the hand off the keys releases them. */
export function useSteering(trial: RunningTrial, steering: boolean, act: (action: KeyAction) => void): void {
  const keys = useRef<KeyState>(noKeys);
  const latestAct = useRef(act);
  useEffect(() => {
    latestAct.current = act;
  });

  useEffect(() => {
    const letGo = () => {
      keys.current = noKeys;
      trial.hand.release();
    };
    const changed = (event: KeyboardEvent) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (isHandleKey(event.key)) event.preventDefault();
      if (steering) {
        keys.current = afterKey(keys.current, {
          type: event.type === 'keydown' ? 'keydown' : 'keyup', key: event.key, shiftKey: event.shiftKey, repeat: event.repeat,
        });
        trial.hand.setRates(ratesOf(keys.current));
      }
      if (event.type !== 'keydown' || event.repeat) return;
      const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
      // a button that has the focus is pressed by Enter itself
      const onControl = event.target instanceof HTMLElement && event.target.closest('button, a') !== null;
      if (action && !(action === 'confirm' && onControl)) latestAct.current(action);
    };
    const hidden = () => {
      if (document.hidden) letGo();
    };
    window.addEventListener('keydown', changed);
    window.addEventListener('keyup', changed);
    window.addEventListener('blur', letGo);
    document.addEventListener('visibilitychange', hidden);
    return () => {
      window.removeEventListener('keydown', changed);
      window.removeEventListener('keyup', changed);
      window.removeEventListener('blur', letGo);
      document.removeEventListener('visibilitychange', hidden);
      letGo();
    };
  }, [trial, steering]);
}
