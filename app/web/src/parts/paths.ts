// The addresses of the views, in one place.
import type {Role} from '../wire/types';

const part = encodeURIComponent;

export const paths = {
  training: '/training',
  briefing: (exerciseId: string) => `/exercises/${part(exerciseId)}`,
  console: (trialId: string) => `/console/${part(trialId)}`,
  debrief: (trialId: string) => `/trials/${part(trialId)}`,
  progress: '/progress',
  people: '/people',
  person: (personId: string) => `/people/${part(personId)}`,
  compare: '/compare',
  comparison: (exerciseId: string, dataset: string) => `/compare?exercise=${part(exerciseId)}&dataset=${part(dataset)}`,
  controls: '/controls',
  help: '/help',
  setup: '/setup',
};

export interface NavEntry {
  path: string;
  label: string;
}

/** What a role finds in the bar; the first entry is its home. */
export function navigationOf(role: Role): NavEntry[] {
  if (role === 'trainee') {
    return [
      {path: paths.training, label: 'My training'},
      {path: paths.progress, label: 'My progress'},
      {path: paths.controls, label: 'Controls'},
      {path: paths.help, label: 'Help'},
    ];
  }
  const compare = [
    {path: paths.compare, label: 'Compare'},
    {path: paths.help, label: 'Help'},
  ];
  return role === 'researcher' ? compare : [{path: paths.people, label: 'People'}, ...compare];
}
