import {lazy, Suspense, type ReactNode} from 'react';
import {Redirect, Route, Switch} from 'wouter';
import {EmptyState} from '../parts/EmptyState';
import {Loading} from '../parts/Loading';
import {useSignedIn} from '../parts/api';
import {navigationOf} from '../parts/paths';
import {Briefing} from '../pages/Briefing';
import {Cohort} from '../pages/cohort/Cohort';
import {Compare} from '../pages/Compare';
import {Curricula} from '../pages/Curricula';
import {CurriculumDiff} from '../pages/CurriculumDiff';
import {Controls} from '../pages/Controls';
import {Debrief} from '../pages/Debrief';
import {Help} from '../pages/Help';
import {Instruments} from '../pages/Instruments';
import {People} from '../pages/People';
import {Person} from '../pages/Person';
import {Progress} from '../pages/Progress';
import {System} from '../pages/System';
import {Training} from '../pages/Training';
import {ImportPeople} from '../pages/people/ImportPeople';
import {DemoBanner} from './DemoBanner';
import {Shell} from './Shell';
import styles from './shell.module.css';

// three.js comes with the console only
const ConsolePage = lazy(() => import('../console/ConsolePage'));
// the text editor comes with the curriculum only
const CurriculumPage = lazy(() => import('../pages/CurriculumPage'));

interface Props {
  demo: boolean;
  version: string;
  onSignedOut: () => void;
}

export function SignedInRoutes({demo, version, onSignedOut}: Props) {
  const {session} = useSignedIn();
  const home = navigationOf(session.role)[0]?.path ?? '/help';
  const desk = (page: ReactNode) => <Shell demo={demo} onSignedOut={onSignedOut}>{page}</Shell>;
  return (
    <Switch>
      <Route path="/console/:id">
        {({id}) => (
          <div className={demo ? styles.room : undefined}>
            {demo && <DemoBanner />}
            <Suspense fallback={<Loading what="the console" />}><ConsolePage trialId={decodeURIComponent(id)} /></Suspense>
          </div>
        )}
      </Route>
      <Route path="/training">{desk(<Training />)}</Route>
      <Route path="/exercises/:id">{({id}) => desk(<Briefing exerciseId={decodeURIComponent(id)} />)}</Route>
      <Route path="/trials/:id">{({id}) => desk(<Debrief trialId={decodeURIComponent(id)} />)}</Route>
      <Route path="/progress">{desk(<Progress />)}</Route>
      <Route path="/cohort">{desk(<Cohort />)}</Route>
      <Route path="/people">{desk(<People />)}</Route>
      {session.role === 'administrator' && <Route path="/people/import">{desk(<ImportPeople />)}</Route>}
      <Route path="/people/:id">{({id}) => desk(<Person personId={decodeURIComponent(id)} />)}</Route>
      <Route path="/curricula">{desk(<Curricula />)}</Route>
      <Route path="/curricula/:id/diff">{({id}) => desk(<CurriculumDiff id={decodeURIComponent(id)} />)}</Route>
      <Route path="/curricula/:id">
        {({id}) => (
          <Shell demo={demo} onSignedOut={onSignedOut} wide>
            <Suspense fallback={<div className="page"><Loading what="the editor" /></div>}><CurriculumPage id={decodeURIComponent(id)} key={id} /></Suspense>
          </Shell>
        )}
      </Route>
      <Route path="/instruments">{desk(<Instruments />)}</Route>
      <Route path="/system">{desk(<System />)}</Route>
      <Route path="/compare">{desk(<Compare />)}</Route>
      <Route path="/controls">{desk(<Controls />)}</Route>
      <Route path="/help">{desk(<Help version={version} />)}</Route>
      <Route path="/"><Redirect to={home} replace /></Route>
      <Route path="/setup"><Redirect to={home} replace /></Route>
      <Route>
        {desk(<EmptyState title="No such page">The address leads nowhere. Use the bar above.</EmptyState>)}
      </Route>
    </Switch>
  );
}
