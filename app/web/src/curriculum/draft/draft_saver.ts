// Keeps the draft saved: two seconds after the last change, and never over somebody else's work. What
// could not be saved stays in this browser until it is.
import {RequestProblem} from '../../wire/api';
import type {CurriculumText, SaveDraft} from '../../wire/types';

export type Saving =
  | {kind: 'saved'; utc: string | null}
  | {kind: 'unsaved'}
  | {kind: 'saving'}
  | {kind: 'failed'; sentence: string}
  | {kind: 'conflict'; theirs: CurriculumText | null};

export interface SaverServer {
  save: (body: SaveDraft) => Promise<CurriculumText>;
  load: () => Promise<CurriculumText>;
}

export interface Shelf {
  setItem: (key: string, value: string) => void;
  removeItem: (key: string) => void;
}

const wait_ms = 2000;
const again_ms = 10_000;

export class DraftSaver {
  private text: string;
  private saved: string;
  private sha256: string;
  private status: Saving;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private running: Promise<void> | null = null;
  private readonly listeners = new Set<() => void>();

  constructor(private readonly server: SaverServer, private readonly shelf: Shelf | null, private readonly key: string, draft: CurriculumText) {
    this.text = draft.yaml;
    this.saved = draft.yaml;
    this.sha256 = draft.sha256;
    this.status = {kind: 'saved', utc: draft.saved_utc};
  }

  readonly snapshot = (): Saving => this.status;

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  /** The hash of the newest text that is saved. */
  get savedSha256(): string {
    return this.sha256;
  }

  get isSaved(): boolean {
    return this.text === this.saved;
  }

  changed(text: string): void {
    if (text === this.text) return;
    this.text = text;
    this.keep();
    if (this.status.kind === 'conflict') return;
    if (this.running === null) this.set(this.isSaved ? {kind: 'saved', utc: null} : {kind: 'unsaved'});
    this.later(wait_ms);
  }

  /** Saves what there is now; resolves when it was tried. */
  async saveNow(): Promise<void> {
    clearTimeout(this.timer);
    if (this.running) await this.running;
    if (this.isSaved || this.status.kind === 'conflict') return;
    this.running = this.save().finally(() => { this.running = null; });
    await this.running;
  }

  /** After a conflict: one's own text replaces what the other one saved. */
  async overwrite(theirs: CurriculumText): Promise<void> {
    this.accept(theirs);
    await this.saveNow();
  }

  /** What somebody else saved becomes what one's next change replaces. */
  accept(theirs: CurriculumText): void {
    this.sha256 = theirs.sha256;
    this.saved = theirs.yaml;
    this.set(this.isSaved ? {kind: 'saved', utc: theirs.saved_utc} : {kind: 'unsaved'});
    if (this.isSaved) this.shelf?.removeItem(this.key);
  }

  stop(): void {
    clearTimeout(this.timer);
    if (!this.isSaved) void this.saveNow();
  }

  private async save(): Promise<void> {
    const yaml = this.text;
    this.set({kind: 'saving'});
    try {
      const answer = await this.server.save({yaml, replaces_sha256: this.sha256});
      this.sha256 = answer.sha256;
      this.saved = yaml;
      if (this.isSaved) this.shelf?.removeItem(this.key);
      else this.later(wait_ms);
      this.set(this.isSaved ? {kind: 'saved', utc: answer.saved_utc} : {kind: 'unsaved'});
    } catch (reason) {
      if (reason instanceof RequestProblem && reason.status === 409) {
        const theirs = await this.server.load().catch(() => null);
        this.set({kind: 'conflict', theirs});
        return;
      }
      this.set({kind: 'failed', sentence: reason instanceof Error ? reason.message : String(reason)});
      this.later(again_ms);
    }
  }

  private later(wait: number): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.saveNow(), wait);
  }

  private keep(): void {
    try {
      if (this.isSaved) this.shelf?.removeItem(this.key);
      else this.shelf?.setItem(this.key, JSON.stringify({text: this.text, utc: new Date().toISOString()}));
    } catch {
      // a full shelf: the server is where it belongs anyway
    }
  }

  private set(status: Saving): void {
    this.status = status;
    this.listeners.forEach((listener) => listener());
  }
}

/** What was typed and never saved the last time, when it is not what the server has. */
export function unsavedCopy(stored: string | null, yaml: string): {text: string; utc: string} | null {
  if (stored === null) return null;
  try {
    const copy = JSON.parse(stored) as {text?: unknown; utc?: unknown};
    if (typeof copy.text !== 'string' || typeof copy.utc !== 'string' || copy.text === yaml) return null;
    return {text: copy.text, utc: copy.utc};
  } catch {
    return null;
  }
}
