// What may be written of a trial, checked before it is sent: the server has the last word and the same limits.

/** The server counts bytes, as it stores them. */
const bytesOf = (text: string) => new TextEncoder().encode(text).length;

const shortestReason = 10;
const longestReason = 500;
const longestComment = 2000;

/** What is wrong with a reason for voiding; '' when nothing is. */
export function reasonProblem(reason: string): string {
  const text = reason.trim();
  if ([...text].length < shortestReason) return `Say in at least ${shortestReason} characters why the trial should not count.`;
  if (bytesOf(text) > longestReason) return `Say it in at most ${longestReason} characters; this is too long.`;
  return '';
}

/** What is wrong with the words of a comment; '' when nothing is. */
export function commentProblem(comment: string): string {
  const text = comment.trim();
  if (text === '') return 'Write something before you send it.';
  if (bytesOf(text) > longestComment) return `Say it in at most ${longestComment} characters, or write two comments.`;
  return '';
}

export type TrialTime = {time_s: number | null} | {problem: string};

/** "1:23", "1:23.5" or "83" seconds into the trial; nothing written is the whole trial. last_s: the trial's end, if known. */
export function readTrialTime(written: string, last_s: number | null): TrialTime {
  const text = written.trim().replace(',', '.');
  if (text === '') return {time_s: null};
  const found = /^(?:(\d{1,4}):(?=\d\d(?:\.|$)))?(\d{1,5}(?:\.\d+)?)$/.exec(text);
  const minutes = Number(found?.[1] ?? 0);
  const seconds = Number(found?.[2]);
  if (!found || (found[1] !== undefined && seconds >= 60)) {
    return {problem: 'Write the time as minutes and seconds, as in 1:23, or leave it empty for the whole trial.'};
  }
  const time_s = minutes * 60 + seconds;
  if (last_s !== null && time_s > Math.ceil(last_s)) {
    return {problem: 'The trial was over by then. Give a time within it, or leave it empty for the whole trial.'};
  }
  return {time_s};
}

/** When the trial was over; null when its debrief does not tell, as of one that ended early. */
export function lastMoment(time_s: number | null, events: readonly {time_s: number}[]): number | null {
  return time_s === null ? null : Math.max(time_s, ...events.map((event) => event.time_s));
}
