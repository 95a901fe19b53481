import type {StepInfo} from '../wire/types';
import {formatNumber} from './format';
import {taskPath, type Move} from './task_path';

const width = 300;
const left = 8;
const right = 262;
const rowHeight = 34;
const maxMoves = 4;

/** Arrows for the moves of an exercise: solid forward, dashed back. */
export function TaskDrawing({steps}: {steps: readonly StepInfo[]}) {
  const path = taskPath(steps);
  if (!path) return null;
  const moves = path.moves.slice(0, maxMoves);
  const axisY = moves.length * rowHeight + 12;
  const span = path.high - path.low || 1;
  const x = (value: number) => left + ((value - path.low) / span) * (right - left);
  const ticks = [...new Set(path.moves.flatMap((move) => [move.from, move.to]))].sort((a, b) => a - b);
  const unit = path.unit === 'deg' ? '°' : ' mm';
  const rounds = path.rounds > 1 ? `, ${path.rounds} rounds` : '';
  const words = path.moves.map((move) => move.title).join(', ') + rounds;
  return (
    <svg className="num" viewBox={`0 0 ${width} ${axisY + 30}`} width={width} role="img" aria-label={words}>
      <line x1={left} x2={right + 12} y1={axisY} y2={axisY} className="axisline" />
      {ticks.map((tick, index) => (
        <g key={tick}>
          <line x1={x(tick)} x2={x(tick)} y1={axisY - 4} y2={axisY + 4} className="axisline" />
          <text x={x(tick)} y={axisY + 18} className="ax" textAnchor={index === 0 ? 'start' : 'middle'}>
            {formatNumber(tick, 0)}{index === ticks.length - 1 ? unit : ''}
          </text>
        </g>
      ))}
      {moves.map((move, index) => <Arrow key={move.number} move={move} y={index * rowHeight + 24} x={x} />)}
    </svg>
  );
}

function Arrow({move, y, x}: {move: Move; y: number; x: (value: number) => number}) {
  const forward = move.to >= move.from;
  const start = x(move.from);
  const end = x(move.to) - (forward ? 4 : -4);
  const back = forward ? -7 : 7;
  const textX = Math.min(Math.min(start, end), width - 140);
  return (
    <g>
      <text x={Math.max(left, textX)} y={y - 9} className="lab2">{move.number}{'  '}{move.title}</text>
      <g fill="none" stroke="var(--accent)" strokeWidth="2">
        <line x1={start} x2={end} y1={y} y2={y} strokeDasharray={forward ? undefined : '5 4'} />
        <path d={`M${end + back} ${y - 5}l${-back} 5l${back} 5`} />
      </g>
    </g>
  );
}
