import {SegmentedControl} from '@mantine/core';
import {useState} from 'react';
import {ChartView} from '../parts/ChartView';
import {EmptyState} from '../parts/EmptyState';
import {Loaded} from '../parts/Loaded';
import {useResource} from '../parts/api';
import {formatCount, formatNumber, formatValue} from '../parts/format';
import {useTitle} from '../parts/use_title';
import type {InstrumentDetail} from '../wire/types';
import styles from './instruments.module.css';

type Kind = 'all' | InstrumentDetail['info']['kind'];

/** What is each wire and catheter like? */
export function Instruments() {
  useTitle('Instruments');
  const resource = useResource('instruments', (api) => api.instruments());
  return <Loaded resource={resource} what="the instruments">{({instruments}) => <Gallery instruments={instruments} />}</Loaded>;
}

function Gallery({instruments}: {instruments: InstrumentDetail[]}) {
  const [kind, setKind] = useState<Kind>('all');
  const of = (wanted: Kind) => instruments.filter(({info}) => wanted === 'all' || info.kind === wanted);
  const shown = of(kind);
  return (
    <>
      <div className="page-head">
        <h1>Instruments</h1>
        <span className="muted num">{formatCount(instruments.length, 'instrument')}. Stiffness is cited; friction is a training value.</span>
      </div>
      <SegmentedControl aria-label="Which instruments" size="sm" value={kind} onChange={(value) => setKind(value as Kind)} className={styles.kinds}
        data={([['all', 'All'], ['guidewire', 'Guidewires'], ['catheter', 'Catheters']] as const).map(([value, word]) =>
          ({value, label: `${word} ${of(value).length}`}))} />
      {shown.length === 0
        ? <section className="panel"><div className="panel-body"><EmptyState title="None of this kind">Choose another kind above.</EmptyState></div></section>
        : <div className="stack">{shown.map((instrument) => <Card key={instrument.info.id} instrument={instrument} />)}</div>}
    </>
  );
}

function Card({instrument}: {instrument: InstrumentDetail}) {
  const {info, charts} = instrument;
  const heading = `instrument-${info.id}`;
  return (
    <section className={`panel ${styles.card}`} aria-labelledby={heading}>
      <div className={styles.facts}>
        <div>
          <h2 id={heading}>{info.title}</h2>
          <p className="xs faint"><span className="mono">{info.id}</span></p>
        </div>
        <dl>
          <Fact name="Kind">{info.kind === 'guidewire' ? 'Guidewire' : 'Catheter'}</Fact>
          <Fact name="Outer diameter">{formatValue(info.outer_diameter_mm, 'mm', 3)}</Fact>
          {instrument.inner_diameter_mm > 0 && <Fact name="Inner diameter">{formatValue(instrument.inner_diameter_mm, 'mm', 3)}</Fact>}
          <Fact name="Length">{formatValue(info.length_mm, 'mm', 0)}</Fact>
          <Fact name="Tip">{instrument.tip_shape}</Fact>
          <Fact name="Friction on the wall">{formatNumber(instrument.friction, 3)}</Fact>
          <Fact name="Used by">{instrument.used_by.length === 0 ? 'no exercise yet' : instrument.used_by.join('; ')}</Fact>
        </dl>
        <p className="xs muted">{instrument.source}</p>
        <p className="xs faint">File <span className="mono" title={instrument.sha256}>{instrument.sha256.slice(0, 12)}</span></p>
      </div>
      {charts.map((chart) => <ChartView key={chart.id} chart={chart} className={styles.chart ?? ''} />)}
    </section>
  );
}

function Fact({name, children}: {name: string; children: string}) {
  return <div><dt className="small muted">{name}</dt><dd className="small num">{children}</dd></div>;
}
