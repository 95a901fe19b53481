import {Link} from 'wouter';
import {keyboardSpeeds} from '../console/handle_keys';
import {Panel} from '../parts/Panel';
import {formatNumber} from '../parts/format';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import styles from './controls.module.css';

interface KeyRow {
  keys: string[];
  action: string;
  speed: 'feed_mm_s' | 'turn_deg_s';
}

const rows: KeyRow[] = [
  {keys: ['↑'], action: 'Feed: push the wire in', speed: 'feed_mm_s'},
  {keys: ['↓'], action: 'Retract: draw the wire back', speed: 'feed_mm_s'},
  {keys: ['→'], action: 'Turn clockwise', speed: 'turn_deg_s'},
  {keys: ['←'], action: 'Turn counter-clockwise', speed: 'turn_deg_s'},
];

const units = {feed_mm_s: 'mm/s', turn_deg_s: '°/s'} as const;

const mouse: readonly [string, string][] = [
  ['Drag the handle', 'Up and down feeds, sideways turns; with Shift ten times finer'],
  ['Wheel on the handle', 'Feeds a millimetre a notch; with Shift a tenth'],
  ['Drag the picture', 'Turns the view'],
  ['Wheel on the picture', 'Zoom'],
];

const others: readonly [string, string][] = [
  ['P', 'Pause and resume'],
  ['Esc', 'End the trial, after asking'],
  ['F', 'Whole vessel or follow the tip'],
  ['T', 'Instrument in true size'],
  ['+ −', 'Zoom'],
  ['0', 'Reset the view'],
  ['?', 'All controls, in the console'],
];

function Keys({rows: lines}: {rows: readonly [string, string][]}) {
  return (
    <table className="table">
      <tbody>
        {lines.map(([keys, what]) => (
          <tr key={keys}>
            <th scope="row" className={styles.name}>{keys}</th>
            <td>{what}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Which hand does what? */
export function Controls() {
  useTitle('Controls');
  return (
    <>
      <div className="page-head">
        <h1>Controls</h1>
        <span className="muted">The same keys in every exercise. Speeds are those of the handle.</span>
      </div>
      <div className={styles.columns}>
        <Panel title="Keyboard">
          <div className="table-scroll">
            <table className="table">
              <thead>
                <tr>
                  <th scope="col">Key</th><th scope="col">What the hand does</th>
                  <th scope="col" className="r">Coarse</th><th scope="col" className="r">Fine, with Shift</th>
                </tr>
              </thead>
              <tbody>
                {rows.map((row) => (
                  <tr key={row.action}>
                    <td>{row.keys.map((key) => <kbd key={key} className={styles.key}>{key}</kbd>)}</td>
                    <td>{row.action}</td>
                    <td className="r">{formatNumber(keyboardSpeeds.normal[row.speed])} {units[row.speed]}</td>
                    <td className="r">{formatNumber(keyboardSpeeds.fine[row.speed])} {units[row.speed]}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
          <p className={`small muted ${styles.note}`}>Let go of every key and the hand stands still. Hold Shift for fine work near a target.</p>
        </Panel>
        <div className="stack">
          <Panel title="Mouse">
            <Keys rows={mouse} />
          </Panel>
          <Panel title="Picture and trial">
            <Keys rows={others} />
          </Panel>
          <Panel title="When the hand is interrupted">
            <p className="muted">
              A lost connection or a hidden window stops the hand and pauses the trial; the clock notes it. Only one window at
              a time can steer. <Link href={paths.help}>More in Help</Link>
            </p>
          </Panel>
        </div>
      </div>
    </>
  );
}
