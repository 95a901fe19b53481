import type {ReactNode, Ref} from 'react';
import {useImperativeHandle} from 'react';
import {Icon} from '../parts/Icon';
import type {Briefing} from '../wire/types';
import styles from './MonitorPanel.module.css';
import {type Alarm, digitsFor, fixed, type GaugeReading} from './readings';
import type {RunningTrial} from './running_trial';
import {ringRadius} from './scene/palette';
import type {MonitorScene, SceneSettings} from './scene/monitor_scene';
import {fullForce} from './trial_gauges';
import {useOrbit, useScene} from './use_scene';

interface Props {
  trial: RunningTrial;
  briefing: Briefing;
  alarm: Alarm;
  contact: GaugeReading;
  settings: SceneSettings;
  onSettings: (settings: SceneSettings) => void;
  /** the view, for the keys that move it; null until it is there */
  ref: Ref<MonitorScene | null>;
  /** the column with the handle */
  side: ReactNode;
  /** what lies over the picture */
  children: ReactNode;
}

/** The main monitor: the 3-D view with the handle beside it and the alarm above. */
export function MonitorPanel({trial, briefing, alarm, contact, settings, onSettings, ref, side, children}: Props) {
  const {attach, scene, thickness, problem, retry} = useScene(trial, briefing, settings);
  const swap = () => onSettings({...settings, mode: settings.mode === 'whole' ? 'follow' : 'whole'});
  const orbit = useOrbit(scene, swap);
  useImperativeHandle<MonitorScene | null, MonitorScene | null>(ref, () => scene, [scene]);
  const view = (mode: SceneSettings['mode'], name: string) => (
    <button type="button" aria-pressed={settings.mode === mode} onClick={() => onSettings({...settings, mode})}>{name}</button>
  );
  return (
    <main className={styles.monitor} data-level={alarm.level}>
      <header className={styles.head}>
        <div className={styles.lamp} data-level={alarm.level} data-testid="alarm">
          {alarm.level !== 'ok' && <Icon name={alarm.level === 'over' ? 'octagon' : 'triangle'} />}
          <span>{alarm.text}</span>
        </div>
        <h2>3-D view</h2>
        <span className={styles.grow} />
        <div className={styles.seg} role="group" aria-label="The picture shows">{view('whole', 'Whole vessel')}{view('follow', 'Follow tip')}</div>
        <button
          type="button" className={styles.toggle} aria-pressed={settings.trueSize}
          onClick={() => onSettings({...settings, trueSize: !settings.trueSize})}
        >
          True size
        </button>
        <button type="button" className={styles.toggle} onClick={() => scene?.reset()}>Reset view</button>
      </header>
      <div className={styles.body}>
        {side}
        <div className={styles.picture}>
          <div ref={attach} className={styles.host} role="img" aria-label={`3-D view of ${briefing.anatomy_title} with the instrument`} {...orbit} />
          <RingLegend full_n={fullForce(briefing)} limited={contact.limit !== null} thickness={thickness} />
          <ForceBar contact={contact} />
          {problem && (
            <div className={styles.problem} role="alert">
              <p>{problem}</p>
              {retry && <button type="button" className={styles.toggle} onClick={retry}>Try again</button>}
            </div>
          )}
          {children}
        </div>
      </div>
    </main>
  );
}

function RingLegend({full_n, limited, thickness}: {full_n: number; limited: boolean; thickness: number}) {
  const samples = [0.05, 0.4, 1].map((part) => ({part, force: part * full_n}));
  const classes = [styles.sand, styles.orange, styles.red];
  return (
    <div className={styles.legend} aria-hidden="true">
      <span>Contact force</span>
      {samples.map(({part, force}, index) => (
        <span key={part}>
          <svg width={26} height={26}><circle cx={13} cy={13} r={ringRadius(part)} className={classes[index]} strokeWidth={1.5 + part} fill="none" /></svg>
          {fixed(force, 1)}{part === 1 && (limited ? ' N limit' : ' N')}
        </span>
      ))}
      <span>{thickness > 1.05 ? `Instrument ${fixed(thickness, 1)} × thicker than life` : 'Instrument in true size'}</span>
    </div>
  );
}

// beside the eye's focus: the same gauge as in the panel, without its numbers
function ForceBar({contact}: {contact: GaugeReading}) {
  const part = (value: number) => `${(Math.min(1, value / contact.scale) * 100).toFixed(2)}%`;
  return (
    <div className={styles.forceBar} data-level={contact.level} aria-hidden="true">
      <div>
        {contact.limit !== null && <i className={styles.beyond} style={{bottom: part(contact.limit)}} />}
        <i className={styles.fill} style={{height: part(contact.value)}} />
        {contact.limit !== null && <i className={styles.limit} style={{bottom: part(contact.limit)}} />}
        <i className={styles.peak} style={{bottom: part(contact.peak)}} />
      </div>
      <span>{fixed(contact.value, digitsFor('N'))}</span>
      <small>N</small>
    </div>
  );
}
