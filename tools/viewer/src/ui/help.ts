// The keys, in a dialog.

import type { Store } from '../store';
import { button } from './controls';
import { element } from './dom';

const keys: [string, [string, string][]][] = [
  [
    'Time',
    [
      ['Space', 'play, pause'],
      [', .', 'a tick back, on'],
      ['[ ]', 'the event before, after'],
      ['← →', 'a second back, on'],
      ['Home End', 'start, end'],
      ['− +', 'slower, faster'],
    ],
  ],
  [
    'View',
    [
      ['1 – 5', 'eyes, behind, top, orbit, fly'],
      ['W A S D Q E', 'fly (Shift: faster)'],
      ['O', 'the whole path'],
      ['X', 'cut above the visitor'],
      ['T', 'trigger volumes'],
      ['M', 'minimap'],
      ['drag, wheel', 'turn, zoom; right button: move'],
    ],
  ],
  [
    'Walk',
    [
      ['F', 'show the failure'],
      ['L', 'log'],
      ['P B', 'points, box (for authors)'],
      ['C', 'compare'],
      ['J K', 'next, previous walk'],
      ['Esc', 'back to the list'],
    ],
  ],
  [
    'List',
    [
      ['/', 'filter'],
      ['s:failed', 'an outcome'],
      ['p:name', 'a project'],
      ['@tag', 'a tag'],
      ['f:folder/', 'a part of the file'],
      ['!word', 'without it'],
      ['"two words"', 'with the space'],
    ],
  ],
  ['Anywhere', [['?', 'this help']]],
];

export function helpDialog(store: Store): HTMLElement {
  const dialog = element(
    'dialog',
    {
      class: 'help',
      attributes: { 'aria-label': 'Keys and filters' },
      on: { close: () => store.set({ help: false }) },
    },
    element(
      'header',
      {},
      element('h2', { text: 'Keys and filters' }),
      button({ icon: 'close', label: 'Close', key: 'Esc', class: 'plain', act: () => dialog.close() }),
    ),
    element(
      'div',
      { class: 'help-groups' },
      ...keys.map(([title, list]) =>
        element(
          'section',
          {},
          element('h3', { text: title }),
          element(
            'dl',
            {},
            ...list.flatMap(([key, meaning]) => [
              element('dt', {}, element('kbd', { text: key })),
              element('dd', { text: meaning }),
            ]),
          ),
        ),
      ),
    ),
  );
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());
  store.on(null, 'help', (shown) => {
    if (shown && !dialog.open) dialog.showModal();
    if (!shown && dialog.open) dialog.close();
  });
  return dialog;
}
