// Over the scene: cameras, what is shown, and where the campus is cut.

import { button, checkbox, segments, setPressed } from '../ui/controls';
import { element, Scope } from '../ui/dom';
import type { Stage } from '../scene/stage';
import type { CameraMode, Layers } from '../store';
import type { WalkContext } from './context';

export const cameras: { value: CameraMode; text: string; label: string; key: string }[] = [
  { value: 'first', text: 'Eyes', label: "First person: from the visitor's eyes", key: '1' },
  { value: 'third', text: 'Behind', label: 'Third person: from behind the visitor', key: '2' },
  { value: 'top', text: 'Top', label: 'From above', key: '3' },
  { value: 'orbit', text: 'Orbit', label: 'Around the visitor', key: '4' },
  { value: 'free', text: 'Fly', label: 'Free flight: W A S D, Q E down and up, Shift faster', key: '5' },
];

const layerNames: [keyof Layers, string][] = [
  ['trail', 'Trail'],
  ['triggers', 'Trigger volumes'],
  ['contacts', 'Contact points'],
  ['gaze', 'Gaze'],
  ['capsule', "The body's capsule"],
  ['plan', 'Minimap'],
  ['findings', 'Findings'],
];

export function viewBar(context: WalkContext, stage: Stage, overlook: () => void, scope: Scope): HTMLElement {
  const { store } = context;
  const modes = segments<CameraMode>('Camera', cameras, (camera) => store.set({ camera }));
  store.on(scope, 'camera', (camera) => modes.show(camera));
  return element(
    'div',
    { class: 'view-bar', attributes: { role: 'toolbar', 'aria-label': 'View' } },
    modes.root,
    button({ icon: 'expand', label: 'Look at the whole path', key: 'O', class: 'floating', act: overlook }),
    menu('cut', 'Storeys', 'Cut away storeys', cutMenu(context, scope), scope),
    menu('layers', 'Show', 'What is shown', layersMenu(context, stage, scope), scope),
  );
}

function layersMenu(context: WalkContext, stage: Stage, scope: Scope): HTMLElement {
  const { store } = context;
  const hasFindings = (context.report.index.findings ?? []).length > 0;
  const boxes = layerNames
    .filter(([layer]) => layer !== 'findings' || hasFindings)
    .map(([layer, label]) => {
      const box = checkbox(label, (shown) => store.setLayer(layer, shown));
      store.on(scope, 'layers', (layers) => (box.input.checked = layers[layer]));
      return box.root;
    });
  const shadows = checkbox('Shadows', (drawn) => stage.setShadows(drawn));
  shadows.input.checked = stage.renderer.shadowMap.enabled;
  return element('div', {}, ...boxes, shadows.root);
}

function cutMenu(context: WalkContext, scope: Scope): HTMLElement {
  const { store, campus } = context;
  const storeys = campus?.storeys ?? [];
  const lowest = (storeys[0] ?? campus?.min[1] ?? 0) + 0.5;
  const highest = campus?.max[1] ?? lowest + 10;
  const height = element('input', {
    attributes: {
      type: 'range',
      min: lowest,
      max: highest,
      step: 0.05,
      'aria-label': 'Height above which nothing is drawn',
    },
    on: { input: () => store.set({ cut: Number(height.value) >= highest - 0.05 ? null : Number(height.value) }) },
  });
  const value = element('output', {});
  const choices = element(
    'div',
    { class: 'cut-storeys' },
    choice('All', null),
    ...storeys.slice(0, -1).map((y, i) => choice(`${i}: ${y.toFixed(1)} m`, (storeys[i + 1] ?? y + 3) - 0.35)),
    storeys.length > 0
      ? choice(
          `${storeys.length - 1}: ${storeys[storeys.length - 1]!.toFixed(1)} m`,
          storeys[storeys.length - 1]! + 2.2,
        )
      : null,
  );
  store.on(scope, 'cut', (cut) => {
    height.value = String(cut ?? highest);
    value.textContent = cut === null ? 'nothing cut' : `above ${cut.toFixed(1)} m`;
    for (const each of choices.querySelectorAll<HTMLElement>('button'))
      setPressed(each, each.dataset.cut === String(cut));
  });
  const here = button({
    label: "Cut just above the visitor's head",
    text: 'Above the visitor',
    class: 'small',
    key: 'X',
    act: () => store.set({ cut: cutAtVisitor(context) }),
  });
  return element('div', { class: 'cut-menu' }, choices, here, height, value);

  function choice(text: string, cut: number | null): HTMLElement {
    return element('button', {
      class: 'segment',
      text,
      attributes: {
        type: 'button',
        'data-cut': String(cut),
        'aria-label': cut === null ? 'All storeys' : `Up to storey ${text}`,
      },
      on: { click: () => store.set({ cut }) },
    });
  }
}

/** A little above the visitor's head: the storey that it is on stays. */
export function cutAtVisitor(context: WalkContext): number {
  const y = context.data.path?.at(context.store.state.tick).y ?? 0;
  const height = context.data.details.recording?.avatar.height ?? 1.8;
  return Math.round((y + height + 0.3) * 20) / 20;
}

function menu(of: 'cut' | 'layers', text: string, label: string, content: HTMLElement, scope: Scope): HTMLElement {
  const body = element('div', { class: 'menu-body' }, element('h3', { text: label }), content);
  const show = (open: boolean): void => {
    body.hidden = !open;
    opener.setAttribute('aria-expanded', String(open));
  };
  const opener = button({ icon: of, label, text, class: 'floating', act: () => show(body.hidden) });
  const root = element('div', { class: 'menu' }, opener, body);
  show(false);
  scope.listen(document, 'pointerdown', (event) => {
    if (!body.hidden && event.target instanceof Node && !root.contains(event.target)) show(false);
  });
  scope.listen(root, 'keydown', (event) => {
    if (event.key !== 'Escape' || body.hidden) return;
    event.stopPropagation();
    show(false);
    opener.focus();
  });
  return root;
}
