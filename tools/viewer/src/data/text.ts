// Numbers and times as people read them.

export function seconds(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value < 60) return `${value.toFixed(1)} s`;
  const minutes = Math.floor(value / 60);
  const rest = Math.floor(value % 60);
  return minutes < 60
    ? `${minutes}:${String(rest).padStart(2, '0')} min`
    : `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')} h`;
}

export function metres(value: number | string): string {
  const metres = Number(value);
  if (!Number.isFinite(metres)) return '–';
  if (metres < 100) return `${metres.toFixed(1)} m`;
  return metres < 10_000 ? `${Math.round(metres)} m` : `${(metres / 1000).toFixed(1)} km`;
}

/** "1 walk", "2,000 walks". */
export function plural(count: number, one: string): string {
  return `${count.toLocaleString('en')} ${one}${count === 1 ? '' : 's'}`;
}

/**
 * A character that nobody sees, or that changes how others are shown: all that scene::is_unseen names. Spaces, tabs
 * and line ends are the layout's, and signs that are drawn around numbers are seen.
 */
const unseen =
  /(?![ \t\n\u0600-\u0605\u06dd\u070f\u0890\u0891\u08e2\u{110bd}\u{110cd}])[\p{Cc}\p{Cf}\p{Cs}\p{Z}\p{Default_Ignorable_Code_Point}\p{Noncharacter_Code_Point}\u2800]/gu;

/** The text with each unseen character as an escape. */
export function visible(text: string): string {
  return text.replace(unseen, (c) => `\\u{${(c.codePointAt(0) ?? 0).toString(16)}}`);
}

export const outcomeNames: Record<string, string> = {
  passed: 'passed',
  xfail: 'failed as expected',
  failed: 'failed',
  skipped: 'skipped',
  bad_input: 'bad input',
  broken: 'broken',
  interrupted: 'interrupted',
};
