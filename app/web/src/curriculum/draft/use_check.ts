import {useEffect, useState} from 'react';
import {useSignedIn} from '../../parts/api';
import type {CurriculumCheck, CurriculumText} from '../../wire/types';
import type {TextDesk} from '../text/desk';

const wait_ms = 300;

export interface Checked {
  /** The newest answer, and the text it is about. */
  readonly text: string;
  readonly check: CurriculumCheck;
  readonly problem: string;
}

/** Has the text checked when one stops typing; an answer about another text than the one there is dropped. */
export function useCheck(desk: TextDesk, text: string, draft: CurriculumText): Checked {
  const {api} = useSignedIn();
  const [checked, setChecked] = useState<Checked>({text: draft.yaml, check: draft.check, problem: ''});
  const known = checked.text === text && checked.problem === '';
  useEffect(() => {
    if (known) return undefined;
    let stale = false;
    const ask = () => {
      api.checkCurriculum({yaml: text}).then(
        (check) => {
          if (stale) return;
          desk.setProblems(check.problems);
          setChecked({text, check, problem: ''});
        },
        (reason: unknown) => {
          if (!stale) setChecked((before) => ({...before, problem: reason instanceof Error ? reason.message : String(reason)}));
        });
    };
    const timer = setTimeout(ask, wait_ms);
    return () => {
      stale = true;
      clearTimeout(timer);
    };
  }, [api, desk, text, known]);
  return checked;
}
