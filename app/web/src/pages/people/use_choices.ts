import {useEffect, useState} from 'react';
import {useSignedIn} from '../../parts/api';
import {isThere, paths} from '../../parts/paths';

export interface Choice {
  value: string;
  label: string;
}

/** The curricula that a person can be given; only the default of the site until they are known. */
export function useCurriculumChoices(): Choice[] {
  const {api} = useSignedIn();
  const [choices, setChoices] = useState<Choice[]>([]);
  useEffect(() => {
    if (!isThere(paths.curricula)) return;
    let stale = false;
    api.curricula().then(({curricula}) => {
      if (stale) return;
      setChoices(curricula.filter((one) => one.published_version !== null).map((one) => ({
        value: one.id, label: `${one.title}${one.is_default ? ' (now the default)' : ''}`,
      })));
    }, () => { /* the person can be assigned one later; the default stays to be chosen */ });
    return () => { stale = true; };
  }, [api]);
  return [{value: '', label: 'Default of the site'}, ...choices];
}

/** The groups that exist, for suggestions. */
export function useGroupNames(): string[] {
  const {api} = useSignedIn();
  const [names, setNames] = useState<string[]>([]);
  useEffect(() => {
    let stale = false;
    api.groups().then(({groups}) => { if (!stale) setNames(groups.map(({name}) => name)); }, () => { /* any name can be typed */ });
    return () => { stale = true; };
  }, [api]);
  return names;
}
