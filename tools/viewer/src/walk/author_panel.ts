// For authors: coordinates, walk steps and trigger colliders to paste, read off the campus.

import { button, copyable, segments } from '../ui/controls';
import { element, replace, Scope } from '../ui/dom';
import { coordinates, followStep, triggerCollider, walkToStep } from '../data/snippets';
import type { Tool } from '../store';
import type { WalkContext } from './context';
import type { Viewport } from './viewport';

export function authorPanel(context: WalkContext, viewport: Viewport | null, scope: Scope): HTMLElement {
  const { store } = context;
  if (!viewport) {
    return element(
      'div',
      { class: 'author' },
      element('p', { text: 'Coordinates are read off the campus in 3D, which this browser does not draw.' }),
      findings(context, null),
    );
  }
  const { marks } = viewport;
  const tools = segments<Tool>(
    'Tool',
    [
      { value: 'none', text: 'Look', label: 'Dragging turns the camera' },
      { value: 'point', text: 'Points', label: 'A click on the ground copies its coordinates', key: 'P' },
      { value: 'box', text: 'Box', label: 'Dragging on the ground draws a trigger', key: 'B' },
    ],
    (tool) => store.set({ tool }),
  );
  const hint = element('p', { class: 'note' });
  const results = element('div', { class: 'snippets' });
  store.on(scope, 'tool', (tool) => {
    tools.show(tool);
    hint.textContent = {
      none: 'Choose Points or Box, then click in the scene.',
      point: 'Click on the ground: its coordinates are copied. Several points make a path.',
      box: 'Drag over the ground around a door: from one corner to the other.',
    }[tool];
  });
  const setBox = (): void => marks.setBox(Number(height.input.value), Number(yaw.input.value));
  const height = numberInput('Height', marks.height, 'm', setBox);
  const yaw = numberInput('Turned', 0, '°', setBox);
  const boxFields = element('div', { class: 'fields' }, height.root, yaw.root);
  const show = (): void => {
    const { points, box } = marks;
    const last = points.at(-1);
    boxFields.hidden = box === null;
    replace(
      results,
      last &&
        section(
          'Last point',
          copyable(coordinates(last), 'Copy the coordinates'),
          copyable(walkToStep(last), 'Copy the step'),
        ),
      points.length > 1 &&
        section(
          `${points.length} points`,
          copyable(followStep(points), 'Copy the follow step'),
          copyable(points.map(walkToStep).join('\n'), 'Copy the steps'),
        ),
      box &&
        section(
          'Trigger',
          copyable(triggerCollider(box, `${marks.building || 'place'}/entrance`, marks.building), 'Copy the collider'),
        ),
      (points.length > 0 || box) &&
        element(
          'div',
          { class: 'row' },
          points.length > 0 &&
            button({
              label: 'Take the last point back',
              text: 'Take back',
              class: 'small',
              act: () => marks.removeLast(),
            }),
          button({ label: 'Remove all marks', text: 'Clear', class: 'small', act: () => marks.clear() }),
        ),
    );
  };
  marks.changed = show;
  show();
  return element('div', { class: 'author' }, tools.root, hint, boxFields, results, findings(context, viewport));
}

function section(title: string, ...children: HTMLElement[]): HTMLElement {
  return element('section', {}, element('h3', { text: title }), ...children);
}

function numberInput(
  label: string,
  value: number,
  unit: string,
  act: () => void,
): { root: HTMLElement; input: HTMLInputElement } {
  const input = element('input', {
    class: 'input small',
    attributes: { type: 'number', step: unit === 'm' ? 0.1 : 5, value },
    on: { input: act },
  });
  return {
    root: element(
      'label',
      { class: 'field' },
      element('span', { text: label }),
      input,
      element('span', { text: unit }),
    ),
    input,
  };
}

/** Findings of `campuswalk explore`, where the report has them. */
function findings(context: WalkContext, viewport: Viewport | null): HTMLElement | null {
  const own = (context.report.index.findings ?? []).filter((finding) => finding.campus === context.data.row.campus);
  if (own.length === 0) return null;
  return section(
    'Findings',
    element(
      'ol',
      { class: 'findings' },
      ...own.map(({ at, ...finding }) =>
        element(
          'li',
          { attributes: { value: finding.number } },
          viewport && at
            ? element('button', {
                class: 'link',
                text: finding.kind,
                title: 'Look at it',
                attributes: { type: 'button' },
                on: { click: () => viewport.lookAt(at) },
              })
            : element('strong', { text: finding.kind }),
          ' ',
          element('bdi', { text: finding.subject }),
          `: ${finding.text}`,
        ),
      ),
    ),
  );
}
