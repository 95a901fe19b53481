import {NativeSelect} from '@mantine/core';
import {useSearch, useLocation} from 'wouter';
import {ChartView} from '../parts/ChartView';
import {DataTable} from '../parts/DataTable';
import {EmptyState} from '../parts/EmptyState';
import {Icon} from '../parts/Icon';
import {Loaded} from '../parts/Loaded';
import {Panel} from '../parts/Panel';
import {useResource} from '../parts/api';
import {formatCount, formatNumber, formatValue} from '../parts/format';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import type {CompareChoice, Comparison, GroupSummary} from '../wire/types';
import styles from './compare.module.css';

/** Who differs, by how much, how sure? */
export function Compare() {
  useTitle('Compare');
  const options = useResource('compare', (api) => api.compareOptions());
  return <Loaded resource={options} what="the comparisons">{({choices}) => <Chosen choices={choices} />}</Loaded>;
}

function Chosen({choices}: {choices: CompareChoice[]}) {
  const search = new URLSearchParams(useSearch());
  const chosen = choices.find((choice) =>
    choice.exercise_id === search.get('exercise') && choice.dataset === search.get('dataset')) ?? choices[0];
  if (!chosen) {
    return (
      <>
        <div className="page-head"><h1>Novices against experts</h1></div>
        <EmptyState title="Nothing to compare yet">A comparison appears when people of two levels have done the same exercise.</EmptyState>
      </>
    );
  }
  return <Page choices={choices} chosen={chosen} />;
}

function Page({choices, chosen}: {choices: CompareChoice[]; chosen: CompareChoice}) {
  const [, navigate] = useLocation();
  const resource = useResource(`compare ${chosen.exercise_id} ${chosen.dataset}`,
    (api) => api.comparison(chosen.exercise_id, chosen.dataset));
  const report = (kind: string) =>
    `/api/compare/${encodeURIComponent(chosen.exercise_id)}.${kind}?dataset=${encodeURIComponent(chosen.dataset)}`;
  const index = choices.indexOf(chosen);
  return (
    <>
      <div className={styles.head}>
        <h1>Novices against experts</h1>
        <NativeSelect aria-label="Exercise and data" value={String(index)}
          data={choices.map((choice, at) => ({
            value: String(at),
            label: `${choice.exercise_title}, ${choice.dataset_title} (${formatCount(choice.people, 'person', 'people')})`,
          }))}
          onChange={(event) => {
            const choice = choices[Number(event.currentTarget.value)];
            if (choice) navigate(paths.comparison(choice.exercise_id, choice.dataset));
          }} />
        <span className="tag">{chosen.dataset_title}</span>
        <span className="grow" />
        <a className={styles.download} href={report('csv')} download><Icon name="download" />CSV</a>
        <a className={styles.download} href={report('html')} download><Icon name="download" />HTML</a>
      </div>
      <Loaded resource={resource} what="the comparison">{(comparison) => <Content comparison={comparison} />}</Loaded>
    </>
  );
}

function Content({comparison}: {comparison: Comparison}) {
  const [experts, novices, means, effect, floor, ...others] = comparison.charts;
  return (
    <>
      <p className={`num ${styles.headline}`}>{comparison.headline}</p>
      <p className="small faint">Apparatus: {comparison.apparatus}</p>
      <div className={`stack ${styles.body}`}>
        <div className={styles.duo}>
          {[experts, novices].map((chart) => chart && <section key={chart.id} className="panel"><ChartView chart={chart} /></section>)}
        </div>
        {(means || comparison.effect || comparison.test) && (
          <section className={`panel ${styles.stats}`} aria-label="Statistics">
            {means && <ChartView chart={means} />}
            {effect && comparison.effect && (
              <ChartView chart={effect}>
                <p className={styles.big}>{formatNumber(comparison.effect.hedges_g)}</p>
                <p className="small muted num">{comparison.effect.sentence}</p>
              </ChartView>
            )}
            {floor && comparison.test && (
              <ChartView chart={floor}>
                <p className={styles.big}>{formatProbability(comparison.test.p)}</p>
                <p className="small muted num">{comparison.test.sentence}</p>
              </ChartView>
            )}
          </section>
        )}
        {others.map((chart) => <section key={chart.id} className="panel"><ChartView chart={chart} /></section>)}
        <section className={`panel ${styles.nesting}`} aria-label="What the comparison rests on">
          <span className="state tone-warn"><Icon name="triangle" /></span>
          <div className="small num">
            <p><span className="strong">{comparison.nesting_sentence}</span></p>
            {comparison.warnings.map((warning) => <p key={warning} className="muted">{warning}</p>)}
          </div>
        </section>
        <div className="stack">
          <Panel title="Groups"><Groups groups={comparison.groups} /></Panel>
          <Panel title="Learning, person by person"><DataTable table={comparison.learning} caption="Table of learning, person by person" /></Panel>
        </div>
      </div>
    </>
  );
}

// two decimals would turn 0.002 into nothing
function formatProbability(p: number): string {
  return p < 0.1 ? formatNumber(p, 4) : p.toFixed(2);
}

function Groups({groups}: {groups: GroupSummary[]}) {
  if (groups.length === 0) return <EmptyState title="No group">Nobody has done this exercise in this data set.</EmptyState>;
  return (
    <div className="table-scroll">
      <table className="table">
        <thead>
          <tr>
            <th scope="col">Level</th><th scope="col" className="r">People</th><th scope="col" className="r">Trials</th>
            <th scope="col" className="r">Mean</th><th scope="col" className="r">SD between people</th>
            <th scope="col" className="r">First to last</th>
          </tr>
        </thead>
        <tbody>
          {groups.map((group) => (
            <tr key={group.level}>
              <th scope="row">{group.level}</th>
              <td className="r">{group.people}</td>
              <td className="r">{group.trials}</td>
              <td className="r strong">{formatValue(group.mean_s, 's')}</td>
              <td className="r">{group.sd_s === null ? '–' : formatValue(group.sd_s, 's')}</td>
              <td className="r">{group.improvement_percent === null ? '–' : `${formatNumber(group.improvement_percent, 1)} %`}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
