// The checker's messages as sentences, and the signs that go with them.

/** "'goal' needs a language: add it" -> "'goal' needs a language: add it." */
export function sentenceOf(message: string): string {
  const text = message.charAt(0).toUpperCase() + message.slice(1);
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

export function signPath(severity: 'error' | 'warning'): string {
  return severity === 'error'
    ? 'M5.5 2h5L14 5.5v5L10.5 14h-5L2 10.5v-5zM8 5v4M8 11v.2'
    : 'M8 2.5l6 11H2zM8 7v3M8 11.8v.2';
}
