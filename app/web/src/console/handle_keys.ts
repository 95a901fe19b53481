// Which handle speeds the pressed keys ask for. Pure: the page feeds it key events and sends on
// what comes out when it differs from before.
import type {HandleMessage} from '../wire/types';

export type HandleRates = Pick<HandleMessage, 'feed_mm_s' | 'turn_deg_s'>;

export const stillRates: HandleRates = {feed_mm_s: 0, turn_deg_s: 0};

/** Hand speeds of the keyboard: about an unhurried pull of the wire, and a fine correction. */
export const keyboardSpeeds = {
  normal: {feed_mm_s: 30, turn_deg_s: 120},
  fine: {feed_mm_s: 5, turn_deg_s: 20},
} as const;

const handleKeys = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight'] as const;
export type HandleKey = (typeof handleKeys)[number];

export interface KeyState {
  readonly pressed: ReadonlySet<HandleKey>;
  readonly fine: boolean;
}

export const noKeys: KeyState = {pressed: new Set(), fine: false};

/** The part of a KeyboardEvent that matters. */
export interface KeyChange {
  type: 'keydown' | 'keyup';
  key: string;
  shiftKey: boolean;
  repeat: boolean;
}

export function isHandleKey(key: string): key is HandleKey {
  return (handleKeys as readonly string[]).includes(key);
}

/**
 * The state after one key event. An auto-repeated press counts for nothing, so that a key released
 * for the user (the page lost the focus) stays released until it is pressed anew.
 */
export function afterKey(state: KeyState, change: KeyChange): KeyState {
  // the modifier of every event is believed, so that a lost key-up of Shift heals itself
  const fine = change.shiftKey;
  if (!isHandleKey(change.key) || change.repeat) return fine === state.fine ? state : {...state, fine};
  const pressed = new Set(state.pressed);
  if (change.type === 'keydown') pressed.add(change.key);
  else pressed.delete(change.key);
  return {pressed, fine};
}

/** Opposing keys cancel. Positive feed pushes in, positive turn is clockwise. */
export function ratesOf(state: KeyState): HandleRates {
  const speed = state.fine ? keyboardSpeeds.fine : keyboardSpeeds.normal;
  return {
    feed_mm_s: speed.feed_mm_s * balance(state, 'ArrowUp', 'ArrowDown'),
    turn_deg_s: speed.turn_deg_s * balance(state, 'ArrowRight', 'ArrowLeft'),
  };
}

function balance(state: KeyState, forward: HandleKey, backward: HandleKey): number {
  return Number(state.pressed.has(forward)) - Number(state.pressed.has(backward));
}
