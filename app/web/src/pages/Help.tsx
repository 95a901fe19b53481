import {Link} from 'wouter';
import {Panel} from '../parts/Panel';
import {State} from '../parts/State';
import {useSignedIn} from '../parts/api';
import {paths} from '../parts/paths';
import {useTitle} from '../parts/use_title';
import styles from './help.module.css';

/** How does this work? */
export function Help({version}: {version: string}) {
  useTitle('Help');
  const {session} = useSignedIn();
  return (
    <>
      <div className="page-head">
        <h1>Help</h1>
        <span className="muted">Cathedra {version}</span>
      </div>
      <div className={styles.columns}>
        {session.role === 'trainee' ? <ForTrainees /> : (
          <div className="stack">
            {session.role === 'administrator' && <ForAdministrators />}
            <ForInstructors />
          </div>
        )}
        <div className="stack">
          <Panel title="What the states mean">
            <dl className={styles.states}>
              <dt><State state="available" /></dt><dd>You may start it.</dd>
              <dt><State state="in_progress" /></dt><dd>Begun, not passed yet.</dd>
              <dt><State state="practised" /></dt><dd>Passed, but not yet often enough in a row.</dd>
              <dt><State state="proficient" /></dt><dd>Passed as often in a row as the curriculum asks.</dd>
              <dt><State state="locked" /></dt><dd>Another exercise comes first; the plan names it.</dd>
              <dt><State state="lapsed" /></dt><dd>Proficient once, but not in the retention test.</dd>
              <dt><State state="exhausted" /></dt><dd>All allowed trials are used; your instructor can add more.</dd>
              <dt><State state="waived" /></dt><dd>Your instructor has excused it.</dd>
            </dl>
          </Panel>
          <Panel title="What the numbers are">
            <p className="muted">
              Forces are those of the simulated wire on the simulated wall. They serve training and comparison, not clinical
              decisions. Simulated operators and published data are always labelled and never pooled with people.
            </p>
          </Panel>
        </div>
      </div>
    </>
  );
}

function ForTrainees() {
  return (
    <Panel title="Your way through">
      <ol className={styles.list}>
        <li><span className="strong">My training</span> shows the next exercise. Start opens the console.</li>
        <li>
          <span className="strong">The console</span> shows the wire in the vessel, your hands, and the step you are at. The clock
          starts with your first motion. <Link href={paths.controls}>The keys</Link> stand at its foot.
        </li>
        <li><span className="strong">Lost connection.</span> The trial pauses. Come back and choose Continue on My training.</li>
        <li><span className="strong">A second window</span> cannot steer: go on in the first one, or close it and try again in the second.</li>
        <li><span className="strong">The debrief</span> gives the verdict, the rule it came from, and what to do next.</li>
        <li><span className="strong">My progress</span> keeps every trial and your learning curve.</li>
      </ol>
    </Panel>
  );
}

function ForAdministrators() {
  return (
    <Panel title="Accounts">
      <ol className={styles.list}>
        <li><span className="strong">Invite a person</span> on People makes a link, shown once. Who opens it sets the own password.</li>
        <li><span className="strong">Import from CSV</span> shows row by row what would happen; broken rows are named and can be left out.</li>
        <li>
          <span className="strong">A name</span> opens the account: groups, experience with its dates, curriculum, a new link for a
          forgotten password. Disable ends the sessions and deletes nothing.
        </li>
      </ol>
    </Panel>
  );
}

function ForInstructors() {
  return (
    <Panel title="Your way through">
      <ol className={styles.list}>
        <li><span className="strong">People</span> lists who needs help first. A name opens learning curves and all trials.</li>
        <li><span className="strong">A trial</span> opens with its verdict, the rule, the force over time and every event.</li>
        <li>
          <span className="strong">Compare</span> sets novices against experts for one exercise and one data set, with the
          effect, its interval and what the number of people can prove at all.
        </li>
        <li><span className="strong">CSV and HTML</span> on Compare give the same numbers for the record.</li>
      </ol>
    </Panel>
  );
}
