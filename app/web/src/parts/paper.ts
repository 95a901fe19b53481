// On which paper this person prints: remembered in this browser, guessed from its language at first.
import type {ReportKind} from '../wire/downloads';

export type Paper = 'a4' | 'letter';

export const papers: readonly {id: Paper; label: string}[] = [
  {id: 'a4', label: 'A4'},
  {id: 'letter', label: 'Letter'},
];

const key = 'cathedra.paper';

// where Letter is what lies in the printer
const letterRegions = new Set(['US', 'CA', 'MX', 'PH', 'CL', 'CO', 'CR', 'GT', 'PA', 'VE', 'PR', 'DO', 'SV', 'NI']);

export function usualPaper(language: string): Paper {
  const region = /-([A-Za-z]{2})\b/.exec(language)?.[1]?.toUpperCase() ?? '';
  return letterRegions.has(region) ? 'letter' : 'a4';
}

export function rememberedPaper(): Paper {
  try {
    const kept = localStorage.getItem(key);
    if (kept === 'a4' || kept === 'letter') return kept;
  } catch {
    // a browser that keeps nothing
  }
  return usualPaper(navigator.language);
}

export function rememberPaper(paper: Paper): void {
  try {
    localStorage.setItem(key, paper);
  } catch {
    // a browser that keeps nothing
  }
}

/** Only a PDF has a size of paper. */
export function withPaper(href: string, kind: ReportKind, paper: Paper): string {
  if (kind !== 'pdf') return href;
  return `${href}${href.includes('?') ? '&' : '?'}paper=${paper}`;
}
