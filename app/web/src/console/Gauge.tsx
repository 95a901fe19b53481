import {unitWord} from '../parts/format';
import styles from './Gauge.module.css';
import {LevelWord} from './LevelWord';
import {digitsFor, fixed, fixedAgainst, type GaugeReading, signedFixed} from './readings';

interface Props {
  name: string;
  unit: string;
  reading: GaugeReading;
  /** from -scale to +scale; otherwise from zero */
  bipolar?: boolean;
  testId: string;
}

const percent = (part: number) => `${(Math.max(0, Math.min(1, part)) * 100).toFixed(2)}%`;

/** A value on its track: limit line and hatching beyond it, peak marker, words when it gets near. */
export function Gauge({name, unit, reading, bipolar = false, testId}: Props) {
  const {value, peak, limit, scale, level} = reading;
  const digits = digitsFor(unit);
  const word = unitWord(unit);
  const place = (at: number) => (bipolar ? (at + scale) / (2 * scale) : at / scale);
  const endDigits = scale % 1 === 0 ? 0 : 1;
  const from = Math.min(place(0), place(value));
  const size = limit === null ? Math.abs(value) : Number(fixedAgainst(Math.abs(value), limit, digits));
  const shown = bipolar ? signedFixed(Math.sign(value) * size, digits) : fixed(size, digits);
  const label = `${name} ${shown} ${word}${limit === null ? '' : `, limit ${limit} ${word}`}, highest ${fixed(peak, digits)} ${word}`;
  return (
    <div className={styles.gauge} data-level={level}>
      <div className={styles.read}>
        <span className={styles.name}>{name}</span>
        <span className={styles.value}>
          <span data-testid={testId} data-value={value.toFixed(4)}>{shown}</span>
          <small>{word}</small>
        </span>
      </div>
      <div className={styles.scale} role="img" aria-label={label}>
        <div className={styles.track}>
          {limit !== null && <Beyond from={place(limit)} to={1} />}
          {limit !== null && bipolar && <Beyond from={0} to={place(-limit)} />}
          <i className={styles.fill} style={{left: percent(from), width: percent(Math.abs(place(value) - place(0)))}} />
          {bipolar && <i className={styles.zero} style={{left: percent(place(0))}} />}
          {limit !== null && <i className={styles.limit} style={{left: percent(place(limit))}} />}
          {limit !== null && bipolar && <i className={styles.limit} style={{left: percent(place(-limit))}} />}
          <Peak at={place(peak)} text={`peak ${limit === null ? fixed(peak, digits) : fixedAgainst(peak, limit, digits)}`} />
        </div>
        <div className={styles.below}>
          <span className={styles.starting}>{bipolar ? fixed(-scale, endDigits) : '0'}<LevelWord level={level} /></span>
          {bipolar && <span className={styles.centred} style={{left: '50%'}}>0</span>}
          {limit === null && <span className={styles.ending}>no limit · {fixed(scale, endDigits)}</span>}
          {limit !== null && (
            <span className={`${styles.centred} ${styles.limitWord}`} style={{left: percent(place(limit))}}>
              limit {bipolar && '±'}{fixed(limit, limit % 1 === 0 ? 0 : 1)} {word}
            </span>
          )}
        </div>
      </div>
    </div>
  );
}

function Beyond({from, to}: {from: number; to: number}) {
  return <i className={styles.beyond} style={{left: percent(from), width: percent(to - from)}} />;
}

// the number stands on the side of the triangle that has room
function Peak({at, text}: {at: number; text: string}) {
  const side = at > 0.45 ? styles.peakLeft : styles.peakRight;
  return <span className={`${styles.peak} ${side}`} style={{left: percent(at)}}><i /><b>{text}</b></span>;
}
