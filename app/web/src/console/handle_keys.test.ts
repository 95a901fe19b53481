import {describe, expect, it} from 'vitest';
import {afterKey, keyboardSpeeds, type KeyChange, type KeyState, noKeys, ratesOf} from './handle_keys';

const down = (key: string, shiftKey = false, repeat = false): KeyChange => ({type: 'keydown', key, shiftKey, repeat});
const up = (key: string, shiftKey = false): KeyChange => ({type: 'keyup', key, shiftKey, repeat: false});
const after = (...changes: KeyChange[]): KeyState => changes.reduce(afterKey, noKeys);

describe('the handle keys', () => {
  it('feed and turn at the normal speed', () => {
    expect(ratesOf(after(down('ArrowUp')))).toEqual({feed_mm_s: 30, turn_deg_s: 0});
    expect(ratesOf(after(down('ArrowDown')))).toEqual({feed_mm_s: -30, turn_deg_s: 0});
    expect(ratesOf(after(down('ArrowRight')))).toEqual({feed_mm_s: 0, turn_deg_s: 120});
    expect(ratesOf(after(down('ArrowLeft')))).toEqual({feed_mm_s: 0, turn_deg_s: -120});
  });

  it('feed and turn at once', () => {
    expect(ratesOf(after(down('ArrowUp'), down('ArrowLeft')))).toEqual({feed_mm_s: 30, turn_deg_s: -120});
  });

  it('stop when the key is let go', () => {
    expect(ratesOf(after(down('ArrowUp'), up('ArrowUp'))).feed_mm_s).toBe(0);
  });

  it('cancel when they oppose, and go on with the one still held', () => {
    const both = after(down('ArrowUp'), down('ArrowDown'));
    expect(ratesOf(both).feed_mm_s).toBe(0);
    expect(ratesOf(afterKey(both, up('ArrowUp'))).feed_mm_s).toBe(-30);
  });

  it('are slow while Shift is held, also when it comes or goes during the movement', () => {
    const fine = after(down('ArrowUp'), down('Shift', true));
    expect(ratesOf(fine).feed_mm_s).toBe(keyboardSpeeds.fine.feed_mm_s);
    expect(ratesOf(afterKey(fine, up('Shift', false))).feed_mm_s).toBe(keyboardSpeeds.normal.feed_mm_s);
  });

  it('heal a lost key-up of Shift at the next key', () => {
    const stuck = after(down('Shift', true));
    expect(ratesOf(afterKey(stuck, down('ArrowUp', false))).feed_mm_s).toBe(keyboardSpeeds.normal.feed_mm_s);
  });

  it('ignore auto-repeat, so that a key released by losing the focus stays released', () => {
    const held = after(down('ArrowUp'), down('ArrowUp', false, true));
    expect(ratesOf(held).feed_mm_s).toBe(30);
    expect(ratesOf(afterKey(noKeys, down('ArrowUp', false, true))).feed_mm_s).toBe(0);
  });

  it('leave other keys alone', () => {
    expect(after(down('a'), down('Enter'))).toBe(noKeys);
  });
});
