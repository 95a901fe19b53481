import {afterEach, beforeEach, expect, it, vi} from 'vitest';
import {RequestProblem} from '../../wire/api';
import type {CurriculumText} from '../../wire/types';
import {DraftSaver, unsavedCopy} from './draft_saver';

const answer = (yaml: string, by = 'Administrator'): CurriculumText => ({
  id: 'a', title: 'A', version: '1.0.0', status: 'draft', built_in: false, yaml, sha256: `sha of ${yaml}`, saved_utc: '2026-11-23T14:02:00Z',
  saved_by: by, check: {ok: true, errors: 0, warnings: 0, problems: [], sha256: '', outline: []},
});

const shelf = new Map<string, string>();
const store = {setItem: (key: string, value: string) => { shelf.set(key, value); }, removeItem: (key: string) => { shelf.delete(key); }};

beforeEach(() => { vi.useFakeTimers(); shelf.clear(); });
afterEach(() => { vi.useRealTimers(); });

it('saves once, two seconds after the last change, over what was there before', async () => {
  const save = vi.fn(({yaml}: {yaml: string}) => Promise.resolve(answer(yaml)));
  const saver = new DraftSaver({save, load: () => Promise.reject(new Error())}, store, 'key', answer('one'));
  saver.changed('two');
  await vi.advanceTimersByTimeAsync(1900);
  saver.changed('three');
  expect(shelf.get('key')).toContain('three');
  await vi.advanceTimersByTimeAsync(1900);
  expect(save).not.toHaveBeenCalled();
  await vi.advanceTimersByTimeAsync(200);
  expect(save.mock.calls).toEqual([[{yaml: 'three', replaces_sha256: 'sha of one'}]]);
  expect(saver.snapshot().kind).toBe('saved');
  expect(shelf.size).toBe(0);
});

it('keeps the text on a conflict, saves nothing more by itself, and overwrites only when told', async () => {
  const save = vi.fn<(body: {yaml: string; replaces_sha256: string}) => Promise<CurriculumText>>()
    .mockRejectedValueOnce(new RequestProblem(409, 'Somebody else saved.')).mockImplementation(({yaml}) => Promise.resolve(answer(yaml)));
  const saver = new DraftSaver({save, load: () => Promise.resolve(answer('theirs', 'Other'))}, store, 'key', answer('one'));
  saver.changed('mine');
  await vi.advanceTimersByTimeAsync(2000);
  expect(saver.snapshot()).toMatchObject({kind: 'conflict', theirs: {saved_by: 'Other'}});
  saver.changed('mine too');
  await vi.advanceTimersByTimeAsync(60_000);
  expect(save).toHaveBeenCalledTimes(1);
  expect(shelf.get('key')).toContain('mine too');
  await saver.overwrite(answer('theirs', 'Other'));
  expect(save.mock.calls[1]).toEqual([{yaml: 'mine too', replaces_sha256: 'sha of theirs'}]);
  expect(saver.isSaved).toBe(true);
});

it('tries again after a failure', async () => {
  const save = vi.fn<(body: {yaml: string}) => Promise<CurriculumText>>()
    .mockRejectedValueOnce(new RequestProblem(0, 'No answer.')).mockImplementation(({yaml}) => Promise.resolve(answer(yaml)));
  const saver = new DraftSaver({save, load: () => Promise.reject(new Error())}, store, 'key', answer('one'));
  saver.changed('two');
  await vi.advanceTimersByTimeAsync(2000);
  expect(saver.snapshot()).toEqual({kind: 'failed', sentence: 'No answer.'});
  await vi.advanceTimersByTimeAsync(10_000);
  expect(saver.isSaved).toBe(true);
});

it('finds what was never saved', () => {
  expect(unsavedCopy('{"text":"b","utc":"x"}', 'a')).toEqual({text: 'b', utc: 'x'});
  expect(unsavedCopy('{"text":"a","utc":"x"}', 'a')).toBeNull();
  expect(unsavedCopy('nonsense', 'a')).toBeNull();
});
