// The addresses of the views, in one place, and who finds which in the bar.
import type {Role} from '../wire/types';

const part = encodeURIComponent;

export const paths = {
  training: '/training',
  briefing: (exerciseId: string) => `/exercises/${part(exerciseId)}`,
  console: (trialId: string) => `/console/${part(trialId)}`,
  debrief: (trialId: string) => `/trials/${part(trialId)}`,
  progress: '/progress',
  settings: '/settings',
  controls: '/controls',
  cohort: '/cohort',
  cohortOf: (group: string) => `/cohort?group=${part(group)}`,
  live: '/live',
  people: '/people',
  person: (personId: string) => `/people/${part(personId)}`,
  personExercise: (personId: string, exerciseId: string) => `/people/${part(personId)}?exercise=${part(exerciseId)}`,
  importPeople: '/people/import',
  curricula: '/curricula',
  curriculum: (id: string, version = 'draft') => `/curricula/${part(id)}?version=${part(version)}`,
  curriculumDiff: (id: string, from: string, to: string) => `/curricula/${part(id)}/diff?from=${part(from)}&to=${part(to)}`,
  instruments: '/instruments',
  system: '/system',
  audit: '/system?show=audit',
  compare: '/compare',
  comparison: (exerciseId: string, dataset: string) => `/compare?exercise=${part(exerciseId)}&dataset=${part(dataset)}`,
  help: '/help',
  setup: '/setup',
  join: '/join',
};

export interface NavEntry {
  path: string;
  label: string;
}

const bars: Readonly<Record<Role, readonly NavEntry[]>> = {
  trainee: [
    {path: paths.training, label: 'My training'},
    {path: paths.progress, label: 'My progress'},
    {path: paths.controls, label: 'Controls'},
    {path: paths.help, label: 'Help'},
  ],
  instructor: [
    {path: paths.cohort, label: 'Cohort'},
    {path: paths.live, label: 'Live'},
    {path: paths.people, label: 'People'},
    {path: paths.compare, label: 'Compare'},
    {path: paths.help, label: 'Help'},
  ],
  administrator: [
    {path: paths.people, label: 'People'},
    {path: paths.curricula, label: 'Curricula'},
    {path: paths.instruments, label: 'Instruments'},
    {path: paths.system, label: 'System'},
    {path: paths.cohort, label: 'Cohort'},
    {path: paths.live, label: 'Live'},
    {path: paths.compare, label: 'Compare'},
    {path: paths.help, label: 'Help'},
  ],
  researcher: [
    {path: paths.compare, label: 'Compare'},
    {path: paths.help, label: 'Help'},
  ],
};

// a page takes itself out of this list when it comes
const to_come: readonly string[] = [
  paths.settings, paths.cohort, paths.live, paths.curricula, paths.instruments,
];

export function isThere(path: string): boolean {
  return !to_come.includes(path);
}

/** What a role finds in the bar; the first entry is its home. Settings are behind the own name, for every role. */
export function navigationOf(role: Role): NavEntry[] {
  return bars[role].filter((entry) => isThere(entry.path));
}
