import {useState} from 'react';
import {useLocation} from 'wouter';
import {useSignedIn} from './api';
import {paths} from './paths';

export interface BeginTrial {
  begin: (exerciseId: string) => void;
  busy: boolean;
  problem: Error | null;
}

/** Asks the server for a new trial and opens the console on it. */
export function useBeginTrial(): BeginTrial {
  const {api} = useSignedIn();
  const [, navigate] = useLocation();
  const [busy, setBusy] = useState(false);
  const [problem, setProblem] = useState<Error | null>(null);
  const begin = (exerciseId: string) => {
    setBusy(true);
    setProblem(null);
    api.beginTrial({exercise_id: exerciseId, device: 'keyboard'}).then(
      (begun) => navigate(paths.console(begun.trial_id)),
      (reason: unknown) => {
        setProblem(reason instanceof Error ? reason : new Error(String(reason)));
        setBusy(false);
      });
  };
  return {begin, busy, problem};
}
