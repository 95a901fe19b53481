import {describe, expect, it} from 'vitest';
import {binCount, ForceHistory} from './force_history';

describe('the force of the last half minute', () => {
  it('keeps the largest of each tenth of a second', () => {
    const history = new ForceHistory();
    history.push(1.01, 0.2);
    history.push(1.05, 0.9);
    history.push(1.09, 0.1);
    history.push(1.11, 0.3);
    expect(history.at(0)).toBeCloseTo(0.3, 6);
    expect(history.at(1)).toBeCloseTo(0.9, 6);
    expect(history.at(2)).toBeNull();
  });

  it('forgets what is older, and shows no force where it saw none', () => {
    const history = new ForceHistory();
    history.push(0, 1.5);
    history.push(40, 0.5);
    expect(history.at(0)).toBeCloseTo(0.5, 6);
    for (let age = 1; age < binCount; ++age) expect(history.at(age)).toBe(0);
    expect(history.at(binCount)).toBeNull();
  });

  it('says when there is nothing new to draw', () => {
    const history = new ForceHistory();
    expect(history.push(2, 0.5)).toBe(true);
    expect(history.push(2.01, 0.4)).toBe(false);
    expect(history.push(2.02, 0.6)).toBe(true);
  });
});
