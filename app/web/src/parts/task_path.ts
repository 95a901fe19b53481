// The moves of an exercise as arrows on one axis, for the small drawing on My training and the briefing.
import type {StepInfo} from '../wire/types';

export interface Move {
  number: number;
  kind: StepInfo['kind'];
  from: number;
  to: number;
  unit: StepInfo['unit'];
  title: string;
}

export interface TaskPath {
  moves: Move[];
  unit: 'mm' | 'deg';
  low: number;
  high: number;
  /** How often the moves are done; 1 when they are not repeated. */
  rounds: number;
}

/**
 * The moves of the first round. Null when the exercise mixes feeding and turning or has nothing to draw:
 * one axis can only show one of them.
 */
export function taskPath(steps: readonly StepInfo[]): TaskPath | null {
  const shown = steps.filter((step) => step.kind !== 'hold' && step.round <= 1);
  const first = shown[0];
  if (!first || first.unit === 's') return null;
  const unit = first.unit;
  if (shown.some((step) => step.unit !== unit)) return null;
  const moves: Move[] = [];
  let from = 0;
  for (const step of shown) {
    moves.push({number: moves.length + 1, kind: step.kind, from, to: step.target, unit, title: step.title});
    from = step.target;
  }
  const ends = moves.flatMap((move) => [move.from, move.to]);
  return {
    moves, unit, low: Math.min(...ends), high: Math.max(...ends), rounds: Math.max(1, ...steps.map((step) => step.rounds)),
  };
}
