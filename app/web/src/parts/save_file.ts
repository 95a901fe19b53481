// Fetches a file and hands it to the browser to keep. A plain link could not say that it is being
// made, nor why there is none.
import {RequestProblem} from '../wire/api';

/** The name the server gave the file, or the last part of its address. */
export function fileNameOf(disposition: string | null, href: string): string {
  const star = /filename\*=UTF-8''([^;]+)/i.exec(disposition ?? '')?.[1];
  if (star !== undefined) {
    try {
      return decodeURIComponent(star);
    } catch {
      // not encoded as it should be: the plain name will do
    }
  }
  const plain = /filename="?([^";]+)"?/i.exec(disposition ?? '')?.[1];
  return plain ?? href.split('?', 1)[0]?.split('/').pop() ?? 'report';
}

async function sentenceOf(answer: Response): Promise<string> {
  try {
    const body: unknown = await answer.json();
    if (typeof body === 'object' && body !== null && 'error' in body && typeof body.error === 'string') return body.error;
  } catch {
    // not the server's own words
  }
  return `The file could not be made (status ${answer.status}). Try again.`;
}

/** Throws a RequestProblem with a sentence when there is no file. */
export async function saveFile(href: string): Promise<void> {
  let answer: Response;
  try {
    answer = await fetch(href, {credentials: 'same-origin'});
  } catch {
    throw new RequestProblem(0, 'The server does not answer. Check that it runs and that you are connected.');
  }
  if (!answer.ok) throw new RequestProblem(answer.status, await sentenceOf(answer));
  const address = URL.createObjectURL(await answer.blob());
  const link = document.createElement('a');
  link.href = address;
  link.download = fileNameOf(answer.headers.get('Content-Disposition'), href);
  link.click();
  // the browser has begun to read it by then
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
