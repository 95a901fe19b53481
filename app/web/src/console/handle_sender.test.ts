import {afterEach, beforeEach, describe, expect, it, vi} from 'vitest';
import type {HandleMessage} from '../wire/types';
import {HandleSender} from './handle_sender';

let sent: HandleMessage[];
let online: boolean;
let sender: HandleSender;

beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  online = true;
  sender = new HandleSender((message) => {
    if (online) sent.push(message);
    return online;
  });
});
afterEach(() => vi.useRealTimers());

describe('the sender of the handle', () => {
  it('sends a change at once and the same speeds only once', () => {
    sender.setRates({feed_mm_s: 30, turn_deg_s: 0});
    vi.advanceTimersByTime(500);
    sender.setRates({feed_mm_s: 30, turn_deg_s: 0});
    vi.advanceTimersByTime(500);
    expect(sent).toEqual([{type: 'handle', feed_mm_s: 30, turn_deg_s: 0}]);
  });

  it('sends at most 60 messages a second and loses no move', () => {
    for (let i = 0; i < 1000; ++i) {
      sender.addMove(0.125, -0.5);
      vi.advanceTimersByTime(1);
    }
    vi.advanceTimersByTime(100);
    expect(sent.length).toBeLessThanOrEqual(62);
    expect(sent.length).toBeGreaterThan(50);
    expect(sent.reduce((sum, message) => sum + (message.move_mm ?? 0), 0)).toBe(125);
    expect(sent.reduce((sum, message) => sum + (message.rotate_deg ?? 0), 0)).toBe(-500);
  });

  it('splits a move that is larger than one message may carry', () => {
    sender.addMove(120, 0);
    vi.advanceTimersByTime(100);
    expect(sent.map((message) => message.move_mm)).toEqual([50, 50, 20]);
  });

  it('stops the hand at once on release, and drops moves still waiting', () => {
    sender.setRates({feed_mm_s: 30, turn_deg_s: 0});
    sender.addMove(10, 0);
    sender.release();
    vi.advanceTimersByTime(100);
    expect(sent).toEqual([
      {type: 'handle', feed_mm_s: 30, turn_deg_s: 0},
      {type: 'handle', feed_mm_s: 0, turn_deg_s: 0},
    ]);
  });

  it('does not repeat after a lost line what could not be sent', () => {
    online = false;
    sender.setRates({feed_mm_s: 30, turn_deg_s: 0});
    sender.addMove(5, 0);
    vi.advanceTimersByTime(100);
    online = true;
    sender.release();
    vi.advanceTimersByTime(100);
    expect(sent).toEqual([]);
  });
});
