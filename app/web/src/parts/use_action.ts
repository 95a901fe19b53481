import {useCallback, useEffect, useRef, useState} from 'react';

export interface Action {
  busy: boolean;
  /** The server's sentence when the last try failed. */
  problem: string;
  run: <T>(work: () => Promise<T>, done: (value: T) => void) => void;
  forget: () => void;
}

/** A change that is sent to the server: one at a time, and its refusal is kept for the person to read. */
export function useAction(): Action {
  const [busy, setBusy] = useState(false);
  const [problem, setProblem] = useState('');
  const running = useRef(false);
  const gone = useRef(false);
  useEffect(() => {
    gone.current = false;
    return () => { gone.current = true; };
  }, []);
  const run = useCallback(<T>(work: () => Promise<T>, done: (value: T) => void) => {
    if (running.current) return;
    running.current = true;
    setBusy(true);
    setProblem('');
    const over = () => {
      running.current = false;
      if (!gone.current) setBusy(false);
    };
    work().then(
      (value) => {
        over();
        if (!gone.current) done(value);
      },
      (reason: unknown) => {
        over();
        if (!gone.current) setProblem(reason instanceof Error ? reason.message : String(reason));
      });
  }, []);
  const forget = useCallback(() => setProblem(''), []);
  return {busy, problem, run, forget};
}
