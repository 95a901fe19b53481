import {afterEach, beforeEach, describe, expect, it, vi} from 'vitest';
import type {Frame} from '../wire/frame';
import {blankFrame} from './blank_frame';
import {overlayOf} from './overlay_state';
import {TrialStore} from './trial_store';

const running = (part: Partial<Frame> = {}): Frame => ({...blankFrame, paused: false, time_s: 5, ...part});

let store: TrialStore;
beforeEach(() => {
  vi.useFakeTimers();
  store = new TrialStore();
  store.connection('open');
});
afterEach(() => vi.useRealTimers());

describe('what the page knows of the trial', () => {
  it('reaches the panels about 12 times a second, and the picture with every frame', () => {
    let panels = 0;
    let pictures = 0;
    store.subscribe(() => { panels += 1; });
    store.onFrame(() => { pictures += 1; });
    for (let frame = 0; frame < 60; ++frame) {
      store.frame(running({frame}));
      vi.advanceTimersByTime(1000 / 60);
    }
    expect(pictures).toBe(60);
    expect(panels).toBeGreaterThanOrEqual(10);
    expect(panels).toBeLessThanOrEqual(14);
  });

  it('shows the last frame when no other follows', () => {
    store.frame(running({step_value: 1}));
    store.frame(running({step_value: 2}));
    vi.advanceTimersByTime(200);
    expect(store.getSnapshot().frame?.step_value).toBe(2);
  });

  it('tells of a pause and of a new step at once', () => {
    store.frame(running());
    store.frame(running({paused: true}));
    expect(store.getSnapshot().frame?.paused).toBe(true);
    store.frame(running({step_index: 1, elapsed_s: 12.5}));
    expect(store.getSnapshot()).toMatchObject({done_s: [12.5]});
  });

  it('does not know when a step was done that it did not see', () => {
    store.frame(running({step_index: 2}));
    expect(store.getSnapshot().done_s).toEqual([null, null]);
    store.frame(running({step_index: 3, elapsed_s: 40}));
    expect(store.getSnapshot().done_s).toEqual([null, null, 40]);
  });
});

describe('the notice over the picture', () => {
  const notice = () => overlayOf(store.getSnapshot(), null);

  it('waits for the first frame, then for the start', () => {
    expect(notice()).toBe('loading');
    store.frame({...blankFrame, paused: true, time_s: 0});
    expect(notice()).toBe('start');
    store.frame(running());
    expect(notice()).toBeNull();
    store.frame(running({paused: true}));
    expect(notice()).toBe('paused');
  });

  it('says that the line was lost until the trial goes on, also when frames were still under way', () => {
    store.frame(running({frame: 1}));
    store.frame(running({frame: 2}));
    store.connection('lost');
    vi.advanceTimersByTime(200);
    expect(notice()).toBe('lost');
    store.connection('open');
    store.frame(running({paused: true}));
    expect(notice()).toBe('restored');
    store.frame(running());
    expect(notice()).toBeNull();
    store.frame(running({paused: true}));
    expect(notice()).toBe('paused');
  });

  it('puts what was opened below a lost line, and the end above all', () => {
    store.frame(running({paused: true}));
    expect(overlayOf(store.getSnapshot(), 'controls')).toBe('controls');
    store.connection('lost');
    expect(overlayOf(store.getSnapshot(), 'controls')).toBe('lost');
    store.frame(running({ended: true}));
    expect(overlayOf(store.getSnapshot(), 'controls')).toBe('ended');
  });
});
