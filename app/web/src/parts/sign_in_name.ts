// letters that do not fall apart into a plain one and a mark
const plain: Readonly<Record<string, string>> = {æ: 'ae', ø: 'o', œ: 'oe', ß: 'ss', ð: 'd', đ: 'd', þ: 'th', ł: 'l', ı: 'i'};

/** A sign-in name to begin with, in letters that every keyboard has: "José Ærø 3" -> "jose.aero.3". */
export function suggestedName(displayName: string): string {
  const letters = displayName.toLowerCase().normalize('NFKD').replace(/\p{M}|['’]/gu, '').replace(/[^\x00-\x7f]/gu, (letter) => plain[letter] ?? ' ');
  return letters.split(/[^a-z0-9]+/).filter((word) => word !== '').join('.').slice(0, 64);
}
