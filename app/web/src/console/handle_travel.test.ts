import {describe, expect, it} from 'vitest';
import type {StepInfo} from '../wire/types';
import {axisOf, placeOn, ticksOf, travelOf} from './handle_travel';

const to = (target: number, kind: StepInfo['kind'] = 'translate') => ({kind, target}) as StepInfo;

describe('the travel of the handle', () => {
  it('reaches over the start and every target, with room at both ends', () => {
    const travel = travelOf([to(350), to(150), to(350)]);
    expect(travel.low_mm).toBeLessThan(0);
    expect(travel.high_mm).toBeGreaterThan(360);
    expect(travel.high_mm).toBeLessThan(420);
  });

  it('has a length also when nothing is fed, and does not mind degrees', () => {
    expect(travelOf([to(360, 'rotate')])).toEqual({low_mm: -50, high_mm: 50});
  });

  it('puts the far end up', () => {
    const travel = {low_mm: 0, high_mm: 400};
    expect(placeOn(travel, 400)).toBe(0);
    expect(placeOn(travel, 100)).toBe(0.75);
    expect(placeOn(travel, -30)).toBe(1);
  });

  it('has a long tick at zero', () => {
    const ticks = ticksOf({low_mm: -30, high_mm: 380});
    expect(ticks.find((tick) => tick.at_mm === 0)?.major).toBe(true);
    expect(ticks.filter((tick) => tick.major).map((tick) => tick.at_mm)).toEqual([0, 50, 100, 150, 200, 250, 300, 350]);
  });

  it('is dragged one way at a time', () => {
    expect(axisOf(1, -2)).toBeNull();
    expect(axisOf(2, -5)).toBe('feed');
    expect(axisOf(-6, 3)).toBe('turn');
  });
});
