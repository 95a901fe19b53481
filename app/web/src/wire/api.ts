// The one place that speaks HTTP to the server. Every failure becomes a RequestProblem whose message
// is a sentence for the person in front of the screen.
import type {
  AcceptInvitation, AuditLog, BackupRow, BeginPractice, BegunTrial, BeginTrial, Briefing, Catalogue, ChangePassword,
  ChangePerson, CheckCurriculum, Cohort, Comment, CompareOptions, Comparison, CopyCurriculum, Curricula,
  CurriculumCheck, CurriculumDiff, CurriculumText, Debrief, DryRun, Groups, ImportPeople, ImportPreview, ImportResult,
  Instruments, Invitation, InvitationGreeting, InvitePerson, LiveList, LiveMine, Metrics, People, PersonDetail,
  PracticeResult, ProgressReport, PublishDraft, SaveDraft, Session, Settings, Setup, SignIn, Site, System, Training,
  VoidTrial, WriteComment,
} from './types';

export class RequestProblem extends Error {
  /** HTTP status; 0 when no answer came. */
  readonly status: number;
  readonly code: string;

  constructor(status: number, message: string, code = '') {
    super(message);
    this.status = status;
    this.code = code;
  }
}

export interface Api {
  site(): Promise<Site>;
  /** The person signed in in this browser, or null. */
  session(): Promise<Session | null>;
  signIn(body: SignIn): Promise<Session>;
  signOut(): Promise<void>;
  setUp(body: Setup): Promise<Session>;
  invitation(token: string): Promise<InvitationGreeting>;
  acceptInvitation(body: AcceptInvitation): Promise<Session>;

  // one's own
  training(): Promise<Training>;
  briefing(exerciseId: string): Promise<Briefing>;
  beginTrial(body: BeginTrial): Promise<BegunTrial>;
  liveMine(): Promise<LiveMine>;
  beginPractice(body: BeginPractice): Promise<BegunTrial>;
  practiceResult(practiceId: string): Promise<PracticeResult>;
  metrics(): Promise<Metrics>;
  settings(): Promise<Settings>;
  saveSettings(body: Settings): Promise<Settings>;
  changePassword(body: ChangePassword): Promise<void>;

  // trials
  trial(trialId: string): Promise<Debrief>;
  voidTrial(trialId: string, body: VoidTrial): Promise<Debrief>;
  comment(trialId: string, body: WriteComment): Promise<Comment>;
  withdrawComment(trialId: string, commentId: string): Promise<void>;
  /** Running trials that the caller may watch. */
  live(): Promise<LiveList>;

  // people
  people(): Promise<People>;
  progress(personId: string): Promise<ProgressReport>;
  person(personId: string): Promise<PersonDetail>;
  invitePerson(body: InvitePerson): Promise<Invitation>;
  changePerson(personId: string, body: ChangePerson): Promise<PersonDetail>;
  /** A new one-time link; the ones before end. */
  inviteAgain(personId: string): Promise<Invitation>;
  groups(): Promise<Groups>;
  previewImport(body: ImportPeople): Promise<ImportPreview>;
  importPeople(body: ImportPeople): Promise<ImportResult>;
  /** group: all one's groups when empty. */
  cohort(group: string): Promise<Cohort>;

  // curricula, instruments
  curricula(): Promise<Curricula>;
  /** version "draft" is the draft. */
  curriculum(id: string, version: string): Promise<CurriculumText>;
  checkCurriculum(body: CheckCurriculum): Promise<CurriculumCheck>;
  copyCurriculum(body: CopyCurriculum): Promise<CurriculumText>;
  saveDraft(id: string, body: SaveDraft): Promise<CurriculumText>;
  deleteDraft(id: string): Promise<void>;
  publishDraft(id: string, body: PublishDraft): Promise<CurriculumText>;
  retireCurriculum(id: string, version: string): Promise<Curricula>;
  setDefaultCurriculum(id: string): Promise<Curricula>;
  curriculumDiff(id: string, from: string, to: string): Promise<CurriculumDiff>;
  startDryRun(body: CheckCurriculum): Promise<DryRun>;
  dryRun(id: string): Promise<DryRun>;
  cancelDryRun(id: string): Promise<void>;
  catalogue(): Promise<Catalogue>;
  instruments(): Promise<Instruments>;

  // the system
  system(): Promise<System>;
  makeBackup(): Promise<BackupRow>;
  /** before: rows older than this number; the newest when null. */
  audit(before: number | null): Promise<AuditLog>;

  // reports
  compareOptions(): Promise<CompareOptions>;
  comparison(exerciseId: string, dataset: string): Promise<Comparison>;
}

function sentenceOf(body: string, status: number): {error: string; code: string} {
  try {
    const parsed: unknown = JSON.parse(body);
    if (typeof parsed === 'object' && parsed !== null && 'error' in parsed && typeof parsed.error === 'string') {
      return {error: parsed.error, code: 'code' in parsed && typeof parsed.code === 'string' ? parsed.code : ''};
    }
  } catch {
    // not JSON: an answer of something between the browser and the server
  }
  return {error: `The server answered with status ${status}. Try again; tell your administrator if it stays.`, code: ''};
}

/** onSignedOut is called when the server no longer knows the session. */
export function createApi(onSignedOut: () => void): Api {
  let csrf = '';

  async function send(method: string, path: string, body?: object): Promise<string> {
    const headers: Record<string, string> = {Accept: 'application/json'};
    if (body !== undefined) headers['Content-Type'] = 'application/json';
    if (method !== 'GET' && csrf !== '') headers['X-CSRF-Token'] = csrf;
    let answer: Response;
    try {
      const text = body === undefined ? undefined : JSON.stringify(body);
      answer = await fetch(path, {method, headers, body: text, credentials: 'same-origin'});
    } catch {
      throw new RequestProblem(0, 'The server does not answer. Check that it runs and that you are connected.');
    }
    const text = await answer.text();
    if (answer.ok) return text;
    const {error, code} = sentenceOf(text, answer.status);
    throw new RequestProblem(answer.status, error, code);
  }

  async function ask<T>(method: string, path: string, body?: object): Promise<T> {
    try {
      return JSON.parse(await send(method, path, body)) as T;
    } catch (problem) {
      if (problem instanceof RequestProblem && problem.status === 401) onSignedOut();
      throw problem;
    }
  }

  // a change whose answer holds nothing
  async function tell(method: string, path: string, body?: object): Promise<void> {
    try {
      await send(method, path, body);
    } catch (problem) {
      if (problem instanceof RequestProblem && problem.status === 401) onSignedOut();
      throw problem;
    }
  }

  function remember(session: Session): Session {
    csrf = session.csrf;
    return session;
  }

  const get = <T>(path: string) => ask<T>('GET', path);
  const post = <T>(path: string, body?: object) => ask<T>('POST', path, body);
  const put = <T>(path: string, body: object) => ask<T>('PUT', path, body);
  const part = encodeURIComponent;

  return {
    site: () => get('/api/site'),
    session: async () => {
      try {
        return remember(JSON.parse(await send('GET', '/api/session')) as Session);
      } catch (problem) {
        if (problem instanceof RequestProblem && problem.status === 401) return null;
        throw problem;
      }
    },
    signIn: async (body) => remember(JSON.parse(await send('POST', '/api/session', body)) as Session),
    signOut: async () => {
      await send('DELETE', '/api/session');
      csrf = '';
    },
    setUp: async (body) => remember(JSON.parse(await send('POST', '/api/setup', body)) as Session),
    // with a wrong or used link nobody is signed out
    invitation: async (token) => JSON.parse(await send('POST', '/api/invitation/look', {token})) as InvitationGreeting,
    acceptInvitation: async (body) => remember(JSON.parse(await send('POST', '/api/invitation', body)) as Session),

    training: () => get('/api/training'),
    briefing: (exerciseId) => get(`/api/exercises/${part(exerciseId)}`),
    beginTrial: (body) => post('/api/trials', body),
    liveMine: () => get('/api/live/mine'),
    beginPractice: (body) => post('/api/practice', body),
    practiceResult: (practiceId) => get(`/api/practice/${part(practiceId)}/result`),
    metrics: () => get('/api/metrics'),
    settings: () => get('/api/me/settings'),
    saveSettings: (body) => put('/api/me/settings', body),
    changePassword: (body) => tell('POST', '/api/me/password', body),

    trial: (trialId) => get(`/api/trials/${part(trialId)}`),
    voidTrial: (trialId, body) => post(`/api/trials/${part(trialId)}/void`, body),
    comment: (trialId, body) => post(`/api/trials/${part(trialId)}/comments`, body),
    withdrawComment: (trialId, commentId) => tell('DELETE', `/api/trials/${part(trialId)}/comments/${part(commentId)}`),
    live: () => get('/api/live'),

    people: () => get('/api/people'),
    progress: (personId) => get(`/api/people/${part(personId)}/progress`),
    person: (personId) => get(`/api/people/${part(personId)}`),
    invitePerson: (body) => post('/api/people', body),
    changePerson: (personId, body) => put(`/api/people/${part(personId)}`, body),
    inviteAgain: (personId) => post(`/api/people/${part(personId)}/invitation`, {}),
    groups: () => get('/api/groups'),
    previewImport: (body) => post('/api/people/import/preview', body),
    importPeople: (body) => post('/api/people/import', body),
    cohort: (group) => get(group === '' ? '/api/cohort' : `/api/cohort?group=${part(group)}`),

    curricula: () => get('/api/curricula'),
    curriculum: (id, version) => get(`/api/curricula/${part(id)}/versions/${part(version)}`),
    checkCurriculum: (body) => post('/api/curricula/check', body),
    copyCurriculum: (body) => post('/api/curricula', body),
    saveDraft: (id, body) => put(`/api/curricula/${part(id)}/draft`, body),
    deleteDraft: (id) => tell('DELETE', `/api/curricula/${part(id)}/draft`),
    publishDraft: (id, body) => post(`/api/curricula/${part(id)}/publish`, body),
    retireCurriculum: (id, version) => post(`/api/curricula/${part(id)}/retire`, {version}),
    setDefaultCurriculum: (id) => put('/api/curricula/default', {curriculum_id: id}),
    curriculumDiff: (id, from, to) => get(`/api/curricula/${part(id)}/diff?from=${part(from)}&to=${part(to)}`),
    startDryRun: (body) => post('/api/dry-runs', body),
    dryRun: (id) => get(`/api/dry-runs/${part(id)}`),
    cancelDryRun: (id) => tell('DELETE', `/api/dry-runs/${part(id)}`),
    catalogue: () => get('/api/catalogue'),
    instruments: () => get('/api/instruments'),

    system: () => get('/api/system'),
    makeBackup: () => post('/api/system/backups', {}),
    audit: (before) => get(before === null ? '/api/audit' : `/api/audit?before=${before}`),

    compareOptions: () => get('/api/compare'),
    comparison: (exerciseId, dataset) => get(`/api/compare/${part(exerciseId)}?dataset=${part(dataset)}`),
  };
}
