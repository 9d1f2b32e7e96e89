// The walk's file, with the lines that failed marked.

import { element, type Child } from '../ui/dom';
import { emptyState } from '../ui/controls';
import type { WalkContext } from './context';

/** A file's lines around one, or all with `around` infinite. */
export function markedFile(context: WalkContext, file: string, line: number, around: number): HTMLElement {
  const title = element('div', { class: 'file-name' }, element('bdi', { text: line > 0 ? `${file}:${line}` : file }));
  const text = context.data.details.source?.[file];
  if (text === undefined) return element('div', { class: 'file' }, title);
  const { failures, complaints } = context.data.details.result;
  const marked = new Set([...failures, ...complaints].filter((each) => each.file === file).map((each) => each.line));
  const lines = text.replace(/\r?\n$/, '').split(/\r?\n/);
  const rows: Child[] = lines.map((content, i) => {
    const number = i + 1;
    if (Math.abs(number - line) > around) return null;
    return element(
      'div',
      { class: `code-line ${marked.has(number) ? 'marked' : ''}`, attributes: { 'data-line': number } },
      element('span', { class: 'line-number', text: String(number), attributes: { 'aria-hidden': 'true' } }),
      element('code', { text: content === '' ? ' ' : content }),
    );
  });
  return element(
    'div',
    { class: 'file' },
    title,
    element('div', { class: 'code-lines', attributes: { tabindex: 0 } }, ...rows),
  );
}

export function filePanel(context: WalkContext): HTMLElement {
  const files = Object.keys(context.data.details.source ?? {});
  if (files.length === 0)
    return emptyState(
      "The walk's file isn't in this report.",
      element('p', {}, element('code', { text: context.data.row.file })),
    );
  return element('div', { class: 'files' }, ...files.map((file) => markedFile(context, file, 0, Infinity)));
}
