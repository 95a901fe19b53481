// Addresses of what the server gives as a file: links, not requests.
const part = encodeURIComponent;

export type ReportKind = 'html' | 'pdf' | 'csv';

export const downloads = {
  progress: (personId: string, kind: ReportKind) => `/api/people/${part(personId)}/progress.${kind}`,
  trial: (trialId: string, kind: ReportKind) => `/api/trials/${part(trialId)}.${kind}`,
  cohort: (group: string, kind: ReportKind) => `/api/cohort.${kind}${group === '' ? '' : `?group=${part(group)}`}`,
  comparison: (exerciseId: string, dataset: string, kind: ReportKind) =>
    `/api/compare/${part(exerciseId)}.${kind}?dataset=${part(dataset)}`,
  backup: (name: string) => `/api/system/backups/${part(name)}`,
};
