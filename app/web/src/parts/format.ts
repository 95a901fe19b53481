// Values as words: every number with its unit, every time in the local time of the reader.

const minus = '\u2212';
const thin = '\u00a0'; // a unit never stands alone on the next line

/** 237.33 -> "237.33"; at most `digits` decimals, with a true minus sign. */
export function formatNumber(value: number, digits = 2): string {
  if (!Number.isFinite(value)) return 'not a number';
  const text = Number(value.toFixed(digits)).toString();
  const [whole = '0', fraction] = text.replace('-', '').split('.');
  const sign = text.startsWith('-') ? minus : '';
  return sign + whole + (fraction === undefined ? '' : `.${fraction}`);
}

/** Decimals worth reading at this size: 41.2 s, 1.62 N, 0.043 N. */
export function digitsFor(value: number, unit: string): number {
  if (unit === 's') return 1;
  const size = Math.abs(value);
  if (size >= 100) return 1;
  if (size >= 1) return 2;
  return 3;
}

const unitWords: Readonly<Record<string, string>> = {
  n: 'N', n_s: 'N s', n_mm: 'N mm', mm: 'mm', deg: '°', s: 's', count: '', '1': '', ratio: '', mm_s: 'mm/s', deg_s: '°/s',
};

export function unitWord(unit: string): string {
  return unitWords[unit.toLowerCase()] ?? unit;
}

/** As many decimals as it takes to see that a value is not its bound: rounding must not change a verdict. */
export function digitsToTellApart(value: number | null, bound: number, unit: string): number {
  let digits = digitsFor(bound, unit);
  if (value === null || value === bound) return digits;
  while (digits < 6 && formatNumber(value, digits) === formatNumber(bound, digits)) ++digits;
  return digits;
}

/** 1.62, "N" -> "1.62 N". */
export function formatValue(value: number | null, unit: string, digits?: number): string {
  if (value === null) return 'not measured';
  const word = unitWord(unit);
  const text = formatNumber(value, digits ?? digitsFor(value, unit));
  if (word === '') return text;
  return word === '°' ? `${text}°` : `${text}${thin}${word}`;
}

/** How far above (+) or below a bound: "+91 s". */
export function formatDifference(value: number, unit: string): string {
  return value > 0 ? `+${formatValue(value, unit)}` : formatValue(value, unit);
}

const signs: Readonly<Record<string, string>> = {'<=': '≤', '>=': '≥', '==': '=', '!=': '≠', le: '≤', ge: '≥', lt: '<', gt: '>', eq: '='};

/** "<=", 288.24, "s" -> "≤ 288.2 s". */
export function formatBound(op: string, value: number, unit: string, digits?: number): string {
  return `${signs[op] ?? op}${thin}${formatValue(value, unit, digits)}`;
}

/** 140.4 -> "2:20": a position on a time axis. */
export function formatClock(seconds: number): string {
  const whole = Math.floor(Math.max(0, seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

const sameDay = (a: Date, b: Date) =>
  a.getFullYear() === b.getFullYear() && a.getMonth() === b.getMonth() && a.getDate() === b.getDate();

/** "Today, 09:42", "20 Nov, 16:05", with the year when it is another one. */
export function formatWhen(utc: string | null, now: Date = new Date()): string {
  if (utc === null || utc === '') return 'never';
  const when = new Date(utc);
  if (Number.isNaN(when.getTime())) return utc;
  const time = when.toLocaleTimeString('en-GB', {hour: '2-digit', minute: '2-digit'});
  if (sameDay(when, now)) return `Today, ${time}`;
  const year = when.getFullYear() === now.getFullYear() ? {} : {year: 'numeric' as const};
  return `${when.toLocaleDateString('en-GB', {day: 'numeric', month: 'short', ...year})}, ${time}`;
}

/** 1, "trial" -> "1 trial"; 2 -> "2 trials". */
export function formatCount(count: number, word: string, plural = `${word}s`): string {
  return `${count}${thin}${count === 1 ? word : plural}`;
}

/** "Trainee 14" -> "T14", "Ada Lovelace" -> "AL". */
export function initialsOf(name: string): string {
  const words = name.split(/\s+/).filter((word) => word !== '');
  const letters = words.slice(0, 2).map((word) => (/^\d+$/.test(word) ? word : word[0] ?? ''));
  return letters.join('').slice(0, 3).toUpperCase();
}

/** 600 -> "10 minutes", 90 -> "1 minute 30 s", 45 -> "45 s". */
export function formatDuration(seconds: number): string {
  const whole = Math.round(seconds);
  const minutes = Math.floor(whole / 60);
  const rest = whole % 60;
  if (minutes === 0) return `${rest}${thin}s`;
  const words = formatCount(minutes, 'minute');
  return rest === 0 ? words : `${words} ${rest}${thin}s`;
}

/** "Linear: feed, retract, feed" -> "Linear": the name for lists, where the whole title has no room. */
export function shortTitle(title: string): string {
  return title.split(':', 1)[0] ?? title;
}

/** "Linear: last trial 32.9 s" under the heading "Linear" -> "Last trial 32.9 s". */
export function withoutTitle(sentence: string, title: string): string {
  if (!sentence.startsWith(`${title}: `)) return sentence;
  const rest = sentence.slice(title.length + 2);
  return rest.charAt(0).toUpperCase() + rest.slice(1);
}

/** 1234567 -> "1.2 MB": decimal units, as discs are sold. */
export function formatBytes(bytes: number): string {
  const units = ['bytes', 'kB', 'MB', 'GB', 'TB'];
  let value = bytes;
  let unit = 0;
  while (value >= 999.5 && unit < units.length - 1) {
    value /= 1000;
    ++unit;
  }
  return `${formatNumber(value, unit === 0 || value >= 99.95 ? 0 : 1)}${thin}${units[unit] ?? ''}`;
}
