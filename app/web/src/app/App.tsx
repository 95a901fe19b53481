import {MantineProvider} from '@mantine/core';
import {useCallback, useEffect, useMemo, useState} from 'react';
import {useLocation} from 'wouter';
import {ErrorState} from '../parts/ErrorState';
import {Loading} from '../parts/Loading';
import {SignedInContext} from '../parts/api';
import {paths} from '../parts/paths';
import {Join} from '../pages/Join';
import {Setup} from '../pages/Setup';
import {SignIn} from '../pages/SignIn';
import {createApi} from '../wire/api';
import type {Session, Site} from '../wire/types';
import {DemoBanner} from './DemoBanner';
import {SignedInRoutes} from './SignedInRoutes';
import {cssVariables, theme} from './theme';

function styleNonce(): string {
  return document.querySelector<HTMLMetaElement>('meta[name="csp-nonce"]')?.content ?? '';
}

// The console is dark as a cath lab; every other view is a desk page.
function useLook(): 'light' | 'dark' {
  const [location] = useLocation();
  const lab = location.startsWith('/console/');
  useEffect(() => {
    document.documentElement.dataset.theme = lab ? 'lab' : 'desk';
  }, [lab]);
  return lab ? 'dark' : 'light';
}

interface Start {
  site: Site;
  session: Session | null;
}

export function App() {
  const look = useLook();
  return (
    <MantineProvider theme={theme} cssVariablesResolver={cssVariables} getStyleNonce={styleNonce} forceColorScheme={look}>
      <Entrance />
    </MantineProvider>
  );
}

// Asks the server who is here and shows the set-up, the sign-in or the application.
function Entrance() {
  const [start, setStart] = useState<Start | null>(null);
  const [problem, setProblem] = useState<Error | null>(null);
  const [attempt, setAttempt] = useState(0);
  const [location, navigate] = useLocation();

  const forget = useCallback(() => setStart((known) => known && {...known, session: null}), []);
  const api = useMemo(() => createApi(forget), [forget]);
  const enter = useCallback((session: Session) => setStart((known) => known && {
    site: {...known.site, needs_setup: false}, session}), []);
  const leave = useCallback(() => {
    forget();
    navigate('/');
  }, [forget, navigate]);

  useEffect(() => {
    let stale = false;
    Promise.all([api.site(), api.session()]).then(
      ([site, session]) => { if (!stale) setStart({site, session}); },
      (reason: unknown) => { if (!stale) setProblem(reason instanceof Error ? reason : new Error(String(reason))); });
    return () => { stale = true; };
  }, [api, attempt]);

  const session = start?.session ?? null;
  const signedIn = useMemo(() => session && {api, session}, [api, session]);

  if (problem && !start) {
    const retry = () => {
      setProblem(null);
      setAttempt((count) => count + 1);
    };
    return <main className="page"><ErrorState problem={problem} onRetry={retry} /></main>;
  }
  if (!start) return <main className="page"><Loading what="Cathedra" /></main>;
  // even beside a session of somebody else: the link is for the person who holds it
  if (location === paths.join) {
    const join = (session: Session) => {
      enter(session);
      navigate('/', {replace: true});
    };
    return (
      <>
        {start.site.demo && <DemoBanner />}
        <Join api={api} present={session} onDone={join} />
      </>
    );
  }
  if (!signedIn) {
    return (
      <>
        {start.site.demo && <DemoBanner />}
        {start.site.needs_setup || location === paths.setup
          ? <Setup api={api} needed={start.site.needs_setup} onDone={enter} />
          : <SignIn api={api} site={start.site} onDone={enter} />}
      </>
    );
  }
  return (
    <SignedInContext value={signedIn}>
      <SignedInRoutes demo={start.site.demo} version={start.site.version} onSignedOut={leave} />
    </SignedInContext>
  );
}
