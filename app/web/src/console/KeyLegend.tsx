import styles from './KeyLegend.module.css';
import {keyboardSpeeds} from './handle_keys';

const {normal, fine} = keyboardSpeeds;

const entries: readonly (readonly {keys: readonly string[]; what: string}[])[] = [
  [
    {keys: ['↑', '↓'], what: `Feed, retract ${normal.feed_mm_s} mm/s`},
    {keys: ['←', '→'], what: `Turn ${normal.turn_deg_s}°/s`},
    {keys: ['Shift'], what: `Fine ${fine.feed_mm_s} mm/s, ${fine.turn_deg_s}°/s`},
  ],
  [
    {keys: ['F'], what: 'Follow tip'},
    {keys: ['T'], what: 'True size'},
    {keys: ['0'], what: 'Reset view'},
  ],
  [
    {keys: ['P'], what: 'Pause'},
    {keys: ['Esc'], what: 'End'},
    {keys: ['?'], what: 'All controls'},
  ],
];

/** What the keys do, with the speeds they have. */
export function KeyLegend() {
  return (
    <footer className={styles.legend}>
      {entries.map((group, index) => (
        <span className={styles.group} key={index}>
          {group.map(({keys, what}) => (
            <span className={styles.entry} key={what}>{keys.map((key) => <kbd key={key}>{key}</kbd>)}{what}</span>
          ))}
        </span>
      ))}
    </footer>
  );
}
