import {useEffect, useRef} from 'react';
import styles from './ForceTrace.module.css';
import {binCount, ForceHistory} from './force_history';
import type {TrialStore} from './trial_store';

interface Props {
  store: TrialStore;
  limit_n: number | null;
  scale_n: number;
}

/** Contact force over the last half minute, for a look back without a look away. */
export function ForceTrace({store, limit_n, scale_n}: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const history = useRef(new ForceHistory());
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const draw = () => paint(element, history.current, limit_n, scale_n);
    const observer = new ResizeObserver(draw);
    observer.observe(element);
    const forget = store.onFrame((frame) => {
      if (history.current.push(frame.time_s, frame.contact_force_n)) draw();
    });
    return () => {
      observer.disconnect();
      forget();
    };
  }, [store, limit_n, scale_n]);
  return (
    <div className={styles.trace} aria-hidden="true">
      <div className={styles.words}><span>Contact force, last 30 s</span><span>now</span></div>
      <canvas ref={canvas} />
    </div>
  );
}

function paint(element: HTMLCanvasElement, history: ForceHistory, limit_n: number | null, scale_n: number): void {
  const ratio = Math.min(2, window.devicePixelRatio);
  const [width, height] = [element.clientWidth, element.clientHeight];
  const context = element.getContext('2d');
  if (!context || width === 0 || height === 0) return;
  if (element.width !== Math.round(width * ratio) || element.height !== Math.round(height * ratio)) {
    element.width = Math.round(width * ratio);
    element.height = Math.round(height * ratio);
  }
  const colours = getComputedStyle(element);
  const colour = (name: string) => colours.getPropertyValue(name);
  const y = (force: number) => 1 + (height - 2) * (1 - Math.min(1, force / scale_n));
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.fillStyle = colour('--grid');
  for (let third = 0; third <= 3; ++third) context.fillRect(Math.round((third / 3) * (width - 1)), 0, 1, height);
  context.fillStyle = colour('--axis');
  context.fillRect(0, height - 1, width, 1);
  if (limit_n !== null) {
    context.fillStyle = colour('--limit');
    context.fillRect(0, Math.round(y(limit_n)) - 1, width, 1.5);
  }
  context.beginPath();
  for (let age = 0; age < binCount; ++age) {
    const force = history.at(age);
    if (force === null) break;
    context.lineTo(width - (age / (binCount - 1)) * width, y(force));
  }
  context.strokeStyle = colour('--text');
  context.lineWidth = 1.5;
  context.lineJoin = 'round';
  context.stroke();
}
