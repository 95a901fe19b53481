// The one place that speaks HTTP to the server. Every failure becomes a RequestProblem whose message
// is a sentence for the person in front of the screen.
import type {
  BegunTrial, BeginTrial, Briefing, CompareOptions, Comparison, Debrief, LiveMine, People, ProgressReport, Session,
  Setup, SignIn, Site, Training,
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
  training(): Promise<Training>;
  briefing(exerciseId: string): Promise<Briefing>;
  beginTrial(body: BeginTrial): Promise<BegunTrial>;
  liveMine(): Promise<LiveMine>;
  trial(trialId: string): Promise<Debrief>;
  progress(personId: string): Promise<ProgressReport>;
  people(): Promise<People>;
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

  function remember(session: Session): Session {
    csrf = session.csrf;
    return session;
  }

  const get = <T>(path: string) => ask<T>('GET', path);
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
    training: () => get('/api/training'),
    briefing: (exerciseId) => get(`/api/exercises/${part(exerciseId)}`),
    beginTrial: (body) => ask('POST', '/api/trials', body),
    liveMine: () => get('/api/live/mine'),
    trial: (trialId) => get(`/api/trials/${part(trialId)}`),
    progress: (personId) => get(`/api/people/${part(personId)}/progress`),
    people: () => get('/api/people'),
    compareOptions: () => get('/api/compare'),
    comparison: (exerciseId, dataset) => get(`/api/compare/${part(exerciseId)}?dataset=${part(dataset)}`),
  };
}
