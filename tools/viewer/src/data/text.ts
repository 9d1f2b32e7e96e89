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
export function plural(count: number, one: string, many = `${one}s`): string {
  return `${count.toLocaleString('en')} ${count === 1 ? one : many}`;
}

/** Whether a character could control how others are shown: then it is shown as an escape itself. */
const controls = /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff]/g;

export function visible(text: string): string {
  return text.replace(controls, (c) => `\\u{${c.charCodeAt(0).toString(16)}}`);
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
