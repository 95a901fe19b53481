import {Icon} from '../parts/Icon';
import type {InstrumentInfo} from '../wire/types';
import {ForceTrace} from './ForceTrace';
import {Gauge} from './Gauge';
import styles from './InstrumentPanel.module.css';
import {fixed, signedFixed} from './readings';
import type {Gauges} from './trial_gauges';
import type {TrialStore} from './trial_store';

interface Props {
  store: TrialStore;
  instrument: InstrumentInfo;
  inserted_mm: number;
  rotation_deg: number;
  gauges: Gauges;
}

const kindWords: Record<InstrumentInfo['kind'], string> = {guidewire: 'Guidewire', catheter: 'Catheter'};

/** What the hand holds, and what it feels. */
export function InstrumentPanel({store, instrument, inserted_mm, rotation_deg, gauges}: Props) {
  return (
    <section className={styles.panel} aria-label="Instrument">
      <header className={styles.head}>
        <h2>Instrument</h2>
        <span className={styles.held}><Icon name="tick" />In hand</span>
      </header>
      <div className={styles.body}>
        <p className={styles.name}><b>{kindWords[instrument.kind]}</b> <span>{instrument.title}</span></p>
        <dl className={styles.place}>
          <div>
            <dt>Inserted</dt>
            <dd data-testid="inserted" data-value={inserted_mm.toFixed(3)}>{fixed(inserted_mm, 1)}<small>mm</small></dd>
          </div>
          <div>
            <dt>Angle</dt>
            <dd data-testid="angle" data-value={rotation_deg.toFixed(3)}>{signedFixed(rotation_deg, 0)}<small>°</small></dd>
          </div>
        </dl>
        <div className={styles.gauges}>
          <Gauge name="Contact force" unit="N" reading={gauges.contact} testId="contact-force" />
          <Gauge name="Push force" unit="N" reading={gauges.push} bipolar testId="handle-force" />
          <Gauge name="Torque" unit="N mm" reading={gauges.torque} bipolar testId="handle-torque" />
        </div>
        <ForceTrace store={store} limit_n={gauges.contact.limit} scale_n={gauges.contact.scale} />
        <p className={styles.note}>Simulated force; limits are training values, not clinical.</p>
      </div>
    </section>
  );
}
