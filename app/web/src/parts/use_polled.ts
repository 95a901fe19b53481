import {useCallback, useEffect, useRef, useState} from 'react';
import type {Api} from '../wire/api';
import {useSignedIn} from './api';

export interface Polled<T> {
  /** The newest answer; what was there stays when an answer fails. */
  value: T | null;
  /** Why the newest question had no answer; null when it had. */
  problem: Error | null;
  /** Asks now, without waiting for the next round. */
  ask: () => void;
}

/** Asks again and again, quietly: nothing flickers, and a page nobody looks at asks nothing. */
export function usePolled<T>(load: (api: Api) => Promise<T>, interval_ms: number): Polled<T> {
  const {api} = useSignedIn();
  const [value, setValue] = useState<T | null>(null);
  const [problem, setProblem] = useState<Error | null>(null);
  const [round, setRound] = useState(0);
  const loader = useRef(load);
  useEffect(() => {
    loader.current = load;
  });
  useEffect(() => {
    let stale = false;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const next = () => {
      if (!stale && !document.hidden) timer = setTimeout(question, interval_ms);
    };
    const question = () => {
      loader.current(api).then(
        (answer) => {
          if (stale) return;
          setValue(answer);
          setProblem(null);
          next();
        },
        (reason: unknown) => {
          if (stale) return;
          setProblem(reason instanceof Error ? reason : new Error(String(reason)));
          next();
        });
    };
    const seen = () => {
      clearTimeout(timer);
      if (!document.hidden) question();
    };
    question();
    document.addEventListener('visibilitychange', seen);
    return () => {
      stale = true;
      clearTimeout(timer);
      document.removeEventListener('visibilitychange', seen);
    };
  }, [api, interval_ms, round]);
  const ask = useCallback(() => setRound((count) => count + 1), []);
  return {value, problem, ask};
}
