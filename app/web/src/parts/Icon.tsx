const shapes = {
  tick: 'M3 8.5l3.2 3.2L13 5',
  cross: 'M4 4l8 8M12 4l-8 8',
  triangle: 'M8 2.5l6 11H2zM8 7v3M8 11.8v.2',
  octagon: 'M5.5 2h5L14 5.5v5L10.5 14h-5L2 10.5v-5zM8 5v4M8 11v.2',
  padlock: 'M4 7.5h8a.5.5 0 0 1 .5.5v5a.5.5 0 0 1-.5.5H4a.5.5 0 0 1-.5-.5V8a.5.5 0 0 1 .5-.5zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5',
  dash: 'M3.5 8h9',
  plus: 'M8 3.5v9M3.5 8h9',
  circle: 'M8 2.5a5.5 5.5 0 1 1 0 11a5.5 5.5 0 0 1 0-11',
  half: 'M8 2.5a5.5 5.5 0 1 1 0 11a5.5 5.5 0 0 1 0-11',
  info: 'M8 2.5a5.5 5.5 0 1 1 0 11a5.5 5.5 0 0 1 0-11M8 7.5v3.5M8 5v.2',
  ring_tick: 'M8 2a6 6 0 1 1 0 12a6 6 0 0 1 0-12M5 8.3l2.2 2.2L11 6',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
  eye: 'M1.5 8s2.4-4.5 6.5-4.5S14.5 8 14.5 8s-2.4 4.5-6.5 4.5S1.5 8 1.5 8M8 6a2 2 0 1 1 0 4a2 2 0 0 1 0-4',
  comment: 'M2.5 3h11v7.5H8L4.8 13v-2.5H2.5z',
  download: 'M8 2.5v8M4.8 7.5L8 10.7l3.2-3.2M3 13.5h10',
} as const;

export type IconName = keyof typeof shapes;

/** A 16 px line drawing. It never stands alone: a word beside it says the same. */
export function Icon({name}: {name: IconName}) {
  return (
    <svg className="icon" viewBox="0 0 16 16" aria-hidden="true">
      <path d={shapes[name]} />
      {name === 'half' && <path d="M8 2.5a5.5 5.5 0 0 1 0 11z" fill="currentColor" stroke="none" />}
    </svg>
  );
}
