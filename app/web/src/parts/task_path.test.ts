import {expect, it} from 'vitest';
import type {StepInfo} from '../wire/types';
import {taskPath} from './task_path';

const step = (kind: StepInfo['kind'], target: number, unit: StepInfo['unit'], round = 0, rounds = 0): StepInfo =>
  ({id: 'x', kind, title: `to ${target}`, target, tolerance: 2, hold_s: 0, unit, round, rounds});

it('chains cumulative targets from zero', () => {
  const path = taskPath([step('translate', 350, 'mm'), step('translate', 150, 'mm'), step('translate', 350, 'mm')]);
  expect(path?.moves.map((move) => [move.from, move.to])).toEqual([[0, 350], [350, 150], [150, 350]]);
  expect(path).toMatchObject({low: 0, high: 350, unit: 'mm', rounds: 1});
});

it('draws one round of a repeat and leaves out holds', () => {
  const path = taskPath([
    step('rotate', 360, 'deg', 1, 2), step('hold', 1, 's', 1, 2), step('rotate', 0, 'deg', 1, 2),
    step('rotate', 360, 'deg', 2, 2), step('rotate', 0, 'deg', 2, 2)]);
  expect(path?.moves.map((move) => [move.from, move.to])).toEqual([[0, 360], [360, 0]]);
  expect(path?.rounds).toBe(2);
});

it('draws nothing when one axis cannot show it', () => {
  expect(taskPath([])).toBeNull();
  expect(taskPath([step('hold', 2, 's')])).toBeNull();
  expect(taskPath([step('translate', 10, 'mm'), step('rotate', 90, 'deg')])).toBeNull();
});
