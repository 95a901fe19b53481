import {createContext, useCallback, useContext, useEffect, useRef, useState} from 'react';
import type {Api} from '../wire/api';
import type {Session} from '../wire/types';

export interface SignedIn {
  api: Api;
  session: Session;
}

export const SignedInContext = createContext<SignedIn | null>(null);

/** The person signed in and the way to the server. Only below the sign-in. */
export function useSignedIn(): SignedIn {
  const value = useContext(SignedInContext);
  if (!value) throw new Error('useSignedIn is used outside of the signed-in pages');
  return value;
}

export type Resource<T> =
  | {state: 'loading'}
  | {state: 'failed'; problem: Error; retry: () => void}
  | {state: 'ready'; value: T; retry: () => void};

type Outcome<T> = {key: string; value: T} | {key: string; problem: Error};

/** Loads once per key and keeps the last answer only while the key stays the same. */
export function useResource<T>(key: string, load: (api: Api) => Promise<T>): Resource<T> {
  const {api} = useSignedIn();
  const [attempt, setAttempt] = useState(0);
  const [outcome, setOutcome] = useState<Outcome<T> | null>(null);
  const loader = useRef(load);
  const wanted = `${key}#${attempt}`;
  useEffect(() => {
    loader.current = load;
  });
  useEffect(() => {
    let stale = false;
    loader.current(api).then(
      (value) => { if (!stale) setOutcome({key: wanted, value}); },
      (problem: unknown) => {
        if (!stale) setOutcome({key: wanted, problem: problem instanceof Error ? problem : new Error(String(problem))});
      });
    return () => { stale = true; };
  }, [api, wanted]);
  const retry = useCallback(() => setAttempt((count) => count + 1), []);
  if (outcome === null || outcome.key !== wanted) return {state: 'loading'};
  if ('problem' in outcome) return {state: 'failed', problem: outcome.problem, retry};
  return {state: 'ready', value: outcome.value, retry};
}
