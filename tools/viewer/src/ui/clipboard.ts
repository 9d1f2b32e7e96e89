// Copies text, also where a page from disk may not use the clipboard's own interface.

import { element } from './dom';

/** The last text that was copied; for tests. */
export let lastCopied = '';

export async function copyText(text: string, done: string): Promise<void> {
  lastCopied = text;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    if (!copyBySelection(text)) {
      notify(`Your browser doesn't allow copying; the text is: ${text}`);
      return;
    }
  }
  notify(done);
}

function copyBySelection(text: string): boolean {
  const area = element('textarea', { class: 'offscreen', attributes: { 'aria-hidden': 'true' } });
  area.value = text;
  document.body.append(area);
  area.select();
  // Deprecated, but all that is left when permission is refused.
  const copied = document.execCommand('copy');
  area.remove();
  return copied;
}

/** Says it for a moment, to screen readers too. */
function notify(message: string): void {
  let toast = document.querySelector<HTMLElement>('.toast');
  if (!toast) {
    toast = element('div', { class: 'toast', attributes: { role: 'status', 'aria-live': 'polite' } });
    document.body.append(toast);
  }
  const shown = element('span', { text: message });
  toast.replaceChildren(shown);
  setTimeout(() => shown.remove(), 2600);
}
