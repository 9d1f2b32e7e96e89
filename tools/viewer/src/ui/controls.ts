// Buttons and the like, each with a name for screen readers and its key in the tool tip.

import { copyText } from './clipboard';
import { element, type Child } from './dom';
import { icon, type IconName } from './icons';

interface ButtonOptions {
  icon?: IconName;
  label: string;
  /** Shown beside the icon, too. */
  text?: string;
  key?: string;
  class?: string;
  act: (event: MouseEvent) => void;
}

export function button(options: ButtonOptions): HTMLButtonElement {
  return element(
    'button',
    {
      class: `button ${options.class ?? ''}`,
      title: options.key ? `${options.label} (${options.key})` : options.label,
      attributes: {
        type: 'button',
        'aria-label': options.text === undefined ? options.label : null,
        'aria-keyshortcuts': options.key ?? null,
      },
      on: { click: options.act },
    },
    options.icon && icon(options.icon),
    options.text !== undefined && element('span', { text: options.text }),
  );
}

export function setPressed(toggle: HTMLElement, pressed: boolean): void {
  toggle.setAttribute('aria-pressed', String(pressed));
}

interface Choice<Value extends string> {
  value: Value;
  text: string;
  label: string;
  key?: string;
}

/** One of several, side by side. Returns the element and how to show what is chosen. */
export function segments<Value extends string>(
  label: string,
  choices: readonly Choice<Value>[],
  choose: (value: Value) => void,
): { root: HTMLElement; show: (value: Value) => void } {
  const buttons = choices.map((choice) =>
    element('button', {
      class: 'segment',
      text: choice.text,
      title: choice.key ? `${choice.label} (${choice.key})` : choice.label,
      attributes: { type: 'button', 'data-value': choice.value, 'aria-keyshortcuts': choice.key ?? null },
      on: { click: () => choose(choice.value) },
    }),
  );
  const root = element('div', { class: 'segments', attributes: { role: 'group', 'aria-label': label } }, ...buttons);
  return { root, show: (value) => buttons.forEach((each) => setPressed(each, each.dataset.value === value)) };
}

export function checkbox(
  label: string,
  act: (checked: boolean) => void,
): { root: HTMLElement; input: HTMLInputElement } {
  const input = element('input', { attributes: { type: 'checkbox' }, on: { change: () => act(input.checked) } });
  return { root: element('label', { class: 'check' }, input, element('span', { text: label })), input };
}

/** A text to copy, with its button. */
export function copyable(text: string, label: string): HTMLElement {
  return element(
    'div',
    { class: 'copyable' },
    element('pre', { text, attributes: { tabindex: 0 } }),
    button({ icon: 'copy', label, act: () => void copyText(text, label.replace(/^Copy/, 'Copied')) }),
  );
}

export function emptyState(title: string, ...more: Child[]): HTMLElement {
  return element('div', { class: 'empty' }, element('p', { class: 'empty-title', text: title }), ...more);
}
