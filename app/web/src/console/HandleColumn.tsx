import {type PointerEvent, useEffect, useRef, useState} from 'react';
import type {Frame} from '../wire/frame';
import type {StepInfo} from '../wire/types';
import {axisOf, type DragAxis, fineDrag, placeOn, ticksOf, type Travel, travelOf, turnPerPixel_deg, wheelNotch_mm} from './handle_travel';
import styles from './HandleColumn.module.css';
import type {HandleSender} from './handle_sender';
import {fixed} from './readings';
import type {TrialStore} from './trial_store';

interface Props {
  store: TrialStore;
  hand: HandleSender;
  steering: boolean;
  steps: readonly StepInfo[];
  step: StepInfo | null;
}

const shaft = 30;         // x of the instrument in the drawing, px
const ruler = 60;
const grip = {width: 34, height: 56};
const padding = grip.height / 2 + 4;

/** The handle on its travel: shows where the hand is, and can be dragged. Up feeds, sideways turns. */
export function HandleColumn({store, hand, steering, steps, step}: Props) {
  const [height, setHeight] = useState(400);
  const area = useRef<HTMLDivElement>(null);
  const travel = travelOf(steps);
  const length = Math.max(1, height - 2 * padding);

  useEffect(() => {
    const element = area.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setHeight(element.clientHeight));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  useWheel(area, hand, steering);
  const drag = useDrag(hand, steering, (travel.high_mm - travel.low_mm) / length);
  return (
    <div className={styles.column}>
      <h3>Handle</h3>
      <div
        ref={area} className={styles.area} data-steering={steering} data-testid="handle-strip"
        title="Drag up and down to feed, sideways to turn; wheel for single millimetres; Shift for fine" {...drag}
      >
        <svg width="100%" height={height} role="img" aria-label="Handle: drag up and down to feed, sideways to turn">
          <Ruler travel={travel} length={length} step={step?.kind === 'translate' ? step : null} />
          <line className={styles.shaft} x1={shaft} x2={shaft} y1={0} y2={height} />
          <Grip store={store} travel={travel} length={length} />
        </svg>
      </div>
      <Dial store={store} step={step?.kind === 'rotate' ? step : null} />
    </div>
  );
}

function useDrag(hand: HandleSender, steering: boolean, mmPerPixel: number) {
  const from = useRef<{x: number; y: number; axis: DragAxis} | null>(null);
  const end = () => {
    from.current = null;
  };
  return {
    onPointerDown: (event: PointerEvent<HTMLDivElement>) => {
      if (!steering || event.button !== 0) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      from.current = {x: event.clientX, y: event.clientY, axis: null};
    },
    onPointerMove: (event: PointerEvent<HTMLDivElement>) => {
      const start = from.current;
      if (!start || !steering) return;
      const dx = event.clientX - start.x;
      const dy = event.clientY - start.y;
      start.axis ??= axisOf(dx, dy);
      if (!start.axis) return;
      start.x = event.clientX;
      start.y = event.clientY;
      const scale = event.shiftKey ? fineDrag : 1;
      if (start.axis === 'feed') hand.addMove(-dy * mmPerPixel * scale, 0);
      else hand.addMove(0, dx * turnPerPixel_deg * scale);
    },
    onPointerUp: end,
    onPointerCancel: end,
  };
}

// React listens passively to the wheel, and the page must not scroll
function useWheel(area: React.RefObject<HTMLDivElement | null>, hand: HandleSender, steering: boolean): void {
  useEffect(() => {
    const element = area.current;
    if (!element) return;
    const turned = (event: WheelEvent) => {
      event.preventDefault();
      const notches = -Math.sign(event.deltaY || event.deltaX);
      if (steering) hand.addMove(notches * wheelNotch_mm * (event.shiftKey ? fineDrag : 1), 0);
    };
    element.addEventListener('wheel', turned, {passive: false});
    return () => element.removeEventListener('wheel', turned);
  }, [area, hand, steering]);
}

function Ruler({travel, length, step}: {travel: Travel; length: number; step: StepInfo | null}) {
  const y = (at_mm: number) => padding + placeOn(travel, at_mm) * length;
  return (
    <g className={styles.ruler}>
      {ticksOf(travel).map(({at_mm, major}) => (
        <g key={at_mm}>
          <line x1={ruler} x2={ruler + (major ? 9 : 5)} y1={y(at_mm)} y2={y(at_mm)} />
          {major && at_mm !== step?.target && <text className="ax" x={ruler + 14} y={y(at_mm) + 4}>{fixed(at_mm, 0)}</text>}
        </g>
      ))}
      {step && (
        <g className={styles.target}>
          <rect
            x={shaft - 19} width={ruler - shaft + 23} y={y(step.target + step.tolerance)}
            height={Math.max(3, y(step.target - step.tolerance) - y(step.target + step.tolerance))}
          />
          <line x1={shaft - 19} x2={ruler + 9} y1={y(step.target)} y2={y(step.target)} />
          <text className="lab" x={ruler + 14} y={y(step.target) + 4}>{fixed(step.target, 0)}</text>
        </g>
      )}
    </g>
  );
}

// the lines on the grip run round it as it turns
const knurls = 8;

function Grip({store, travel, length}: {store: TrialStore; travel: Travel; length: number}) {
  const group = useRef<SVGGElement>(null);
  const lines = useRef<SVGGElement>(null);
  useEffect(() => {
    const show = (frame: Frame) => {
      const y = padding + placeOn(travel, frame.handle_axial_mm) * length;
      group.current?.setAttribute('transform', `translate(${shaft} ${y.toFixed(2)})`);
      const turned = (frame.handle_rotation_deg * Math.PI) / 180;
      Array.from(lines.current?.children ?? []).forEach((line, index) => {
        const angle = turned + (2 * Math.PI * index) / knurls;
        const x = (grip.width / 2 - 2) * Math.sin(angle);
        const visible = Math.cos(angle) > 0.05;
        line.setAttribute('transform', `translate(${x.toFixed(2)} 0)`);
        line.setAttribute('visibility', visible ? 'visible' : 'hidden');
      });
    };
    if (store.latest) show(store.latest);
    return store.onFrame(show);
  }, [store, travel, length]);
  const half = grip.height / 2;
  return (
    <g ref={group} transform={`translate(${shaft} ${padding + placeOn(travel, 0) * length})`} className={styles.grip}>
      <rect x={-grip.width / 2} y={-half} width={grip.width} height={grip.height} rx={6} />
      <g ref={lines} className={styles.knurls}>
        {Array.from({length: knurls}, (_, index) => (
          <line key={index} y1={-half + 7} y2={half - 7} className={index === 0 ? styles.first : undefined} />
        ))}
      </g>
      <path className={styles.pointer} d={`M${grip.width / 2 + 3} 0l8 -4v8z`} transform={`matrix(-1 0 0 1 ${grip.width + 14} 0)`} />
    </g>
  );
}

function Dial({store, step}: {store: TrialStore; step: StepInfo | null}) {
  const needle = useRef<SVGGElement>(null);
  useEffect(() => {
    const show = (frame: Frame) => needle.current?.setAttribute('transform', `rotate(${frame.handle_rotation_deg.toFixed(2)})`);
    if (store.latest) show(store.latest);
    return store.onFrame(show);
  }, [store]);
  return (
    <svg className={styles.dial} viewBox="-46 -46 92 92" width={92} height={92} aria-hidden="true">
      <circle r={34} />
      <path d="M0 -34v6M0 34v-6M-34 0h6M34 0h-6" />
      {step && (
        <g transform={`rotate(${step.target})`} className={styles.dialTarget}>
          <path d={arcOf(step.tolerance)} className={styles.dialTolerance} />
          <line y1={-42} y2={-27} />
        </g>
      )}
      <g ref={needle} className={styles.needle}><line y1={6} y2={-25} /></g>
    </svg>
  );
}

function arcOf(tolerance_deg: number): string {
  const angle = (Math.max(2, tolerance_deg) * Math.PI) / 180;
  const [x, y] = [34 * Math.sin(angle), -34 * Math.cos(angle)];
  return `M${(-x).toFixed(2)} ${y.toFixed(2)}A34 34 0 0 1 ${x.toFixed(2)} ${y.toFixed(2)}`;
}
