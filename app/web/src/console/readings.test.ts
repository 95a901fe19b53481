import {describe, expect, it} from 'vitest';
import type {Frame} from '../wire/frame';
import type {Briefing, LimitInfo, StepInfo} from '../wire/types';
import {blankFrame} from './blank_frame';
import {
  fixedAgainst,
  fixed,
  signedFixed,
  limitOn,
  readAlarm,
  readGauge,
  readLimits,
  readStep,
  visibleSteps,
} from './readings';

const feed: StepInfo = {
  id: 'feed-1', kind: 'translate', title: 'Feed to 350 mm', target: 350, tolerance: 2, hold_s: 1, unit: 'mm', round: 0, rounds: 0,
};
const turn: StepInfo = {...feed, id: 'cw', kind: 'rotate', title: 'Turn to 360°', target: 360, tolerance: 5, hold_s: 0, unit: 'deg'};
const force: LimitInfo = {
  metric: 'force_max_n', title: 'Largest contact force', op: '<=', value: 2, unit: 'N', on_breach: 'critical_error',
};

const frameWith = (part: Partial<Frame>): Frame => ({...blankFrame, ...part});

describe('numbers', () => {
  it('carry a true minus sign, and none before zero', () => {
    expect(fixed(-1.25, 1)).toBe('\u22121.3');
    expect(fixed(-0.01, 1)).toBe('0.0');
    expect(signedFixed(1.84, 1)).toBe('+1.8');
    expect(signedFixed(0.01, 1)).toBe('0.0');
  });

  it('are never rounded across their bound', () => {
    expect(fixedAgainst(1.999, 2, 2)).toBe('1.99');
    expect(fixedAgainst(2.001, 2, 2)).toBe('2.01');
    expect(fixedAgainst(2, 2, 2)).toBe('2.00');
    expect(fixedAgainst(0.42, 2, 2)).toBe('0.42');
    expect(fixedAgainst(2.4, 2, 2)).toBe('2.40');
  });
});

describe('the current step', () => {
  it('says how far to feed, and fills the bar in proportion', () => {
    const reading = readStep(feed, frameWith({step_value: 175}));
    expect(reading.ask).toBe('feed');
    expect(reading.sentence).toBe('Feed 175.0\u00a0mm more');
    expect(reading.fraction).toBeCloseTo(0.45);  // half the way to the mark at 0.9
    expect(reading.goal).toBe(0.9);
    expect(reading.held).toBeNull();
  });

  it('asks to come back after an overshoot and shows it behind the mark', () => {
    const reading = readStep(feed, frameWith({step_value: 360}));
    expect(reading.ask).toBe('retract');
    expect(reading.fraction).toBeGreaterThan(reading.goalHigh);
  });

  it('runs the bar forwards when the way leads back', () => {
    const retract = {...feed, target: 150};
    const reading = readStep(retract, frameWith({step_start: 350, step_value: 250}));
    expect(reading.ask).toBe('retract');
    expect(reading.sentence).toBe('Retract 100.0\u00a0mm more');
    expect(reading.fraction).toBeCloseTo(0.45);
  });

  it('asks to hold still within the tolerance, its edge included', () => {
    const reading = readStep(feed, frameWith({step_value: 348, held_s: 0.4}));
    expect(reading.ask).toBe('hold');
    expect(reading.held).toBeCloseTo(0.4);
    expect(reading.sentence).toBe('Within ±2\u00a0mm. Hold still: 0.4 of 1.0 s');
    expect(readStep(feed, frameWith({step_value: 347.99})).ask).toBe('feed');
  });

  it('turns in degrees', () => {
    expect(readStep(turn, frameWith({step_value: 90})).sentence).toBe('Turn clockwise 270° more');
    expect(readStep({...turn, target: 0}, frameWith({step_start: 360, step_value: 90})).sentence).toBe(
      'Turn counter-clockwise 90° more',
    );
  });

  it('keeps still for a time', () => {
    const hold: StepInfo = {...feed, kind: 'hold', title: 'Hold 3 s', target: 3, tolerance: 0, hold_s: 3, unit: 's'};
    const reading = readStep(hold, frameWith({held_s: 1.5}));
    expect(reading.sentence).toBe('Keep still: 1.5 of 3.0 s');
    expect(reading.fraction).toBeCloseTo(0.45);
  });

  it('stays in sight in a long list', () => {
    expect(visibleSteps(3, 0, 4)).toEqual({first: 0, last: 3});
    expect(visibleSteps(12, 0, 4)).toEqual({first: 0, last: 4});
    expect(visibleSteps(12, 5, 4)).toEqual({first: 4, last: 8});
    expect(visibleSteps(12, 11, 4)).toEqual({first: 8, last: 12});
    expect(visibleSteps(12, 12, 4)).toEqual({first: 8, last: 12});
  });
});

describe('a gauge', () => {
  it('joins "near limit" at 80 % and turns at the limit', () => {
    const level = (value: number) => readGauge(value, 0, 2, []).level;
    expect(level(1.59)).toBe('ok');
    expect(level(1.6)).toBe('near');
    expect(level(-1.6)).toBe('near');
    expect(level(1.999)).toBe('near');
    expect(level(2)).toBe('over');
  });

  it('has room behind its limit, and a scale from the row when it has none', () => {
    expect(readGauge(0, 0, 1.5, []).scale).toBeCloseTo(2);
    expect(readGauge(0.2, 0.7, null, [0.5, 1, 2]).scale).toBe(1);
    expect(readGauge(0.2, 7, null, [0.5, 1, 2]).scale).toBe(7);
  });
});

describe('limits and the alarm', () => {
  const briefing = {limits: [force]} as unknown as Briefing;

  it('find the bound on a metric', () => {
    expect(limitOn([force], 'force_max_n')).toBe(2);
    expect(limitOn([force], 'torque_max_n_mm')).toBeNull();
  });

  it('believe the server about a breach, not the number', () => {
    const [row] = readLimits(briefing, frameWith({limits: [{value: 2.001, breached: true}]}));
    expect(row).toMatchObject({value: '2.01', bound: '2.00\u00a0N', level: 'over', consequence: 'critical error'});
    const [near] = readLimits(briefing, frameWith({limits: [{value: 1.7, breached: false}]}));
    expect(near?.level).toBe('near');
  });

  it('name the worst first', () => {
    const gauge = (name: string, value: number) => ({name, unit: 'N', reading: readGauge(value, value, 2, [])});
    expect(readAlarm([gauge('Contact force', 1.7), gauge('Push force', 2.1)], []).text).toBe('Push force 2.10, limit 2.00\u00a0N');
    expect(readAlarm([gauge('Contact force', 0.1)], [])).toMatchObject({level: 'ok', spoken: ''});
    expect(readAlarm([gauge('Contact force', 1.7)], []).spoken).toBe('Contact force near limit');
    const broken = readLimits(briefing, frameWith({limits: [{value: 2.4, breached: true}]}));
    expect(readAlarm([gauge('Contact force', 0.1)], broken)).toMatchObject({level: 'near', text: 'Largest contact force was exceeded'});
  });
});
