// The walk's pictures. Of one that should look like another: expected, actual and difference, and a slider between.

import { element, name, type Child } from '../ui/dom';
import { emptyState, segments } from '../ui/controls';
import type { WalkContext } from './context';

interface Picture {
  name: string;
  address: string;
}

export function picturesPanel(context: WalkContext): HTMLElement {
  const pictures = picturesOf(context);
  if (pictures.length === 0) {
    return emptyState(
      'No pictures.',
      element('p', { text: 'A snapshot step takes one; a failure takes three where pictures are drawn.' }),
    );
  }
  const compared = new Map<string, { expected?: Picture; actual?: Picture; diff?: Picture }>();
  const single: Picture[] = [];
  for (const picture of pictures) {
    const match = /^(.*)-(expected|actual|diff)$/.exec(picture.name);
    if (!match) {
      single.push(picture);
      continue;
    }
    const set = compared.get(match[1]!) ?? {};
    set[match[2] as 'expected' | 'actual' | 'diff'] = picture;
    compared.set(match[1]!, set);
  }
  return element(
    'div',
    { class: 'pictures' },
    ...[...compared].map(([title, set]) => comparison(title, set)),
    ...single.map((picture) => element('figure', {}, image(picture), element('figcaption', {}, name(picture.name)))),
  );
}

function picturesOf(context: WalkContext): Picture[] {
  const { result, pictures } = context.data.details;
  return Object.entries(pictures ?? {}).flatMap(([path, chunk]) => {
    const address = context.report.picture(chunk);
    const file = path.split('/').at(-1) ?? path;
    const title = result.artifacts.find((artifact) => artifact.path === path)?.name || file;
    // "door-actual.png" says more than the artifact's name does where that is the same for all three.
    const stem = file.replace(/\.\w+$/, '');
    return address ? [{ name: /-(expected|actual|diff)$/.test(stem) ? stem : title, address }] : [];
  });
}

function image(picture: Picture): HTMLImageElement {
  return element('img', { attributes: { src: picture.address, alt: picture.name, loading: 'lazy' } });
}

function comparison(title: string, set: { expected?: Picture; actual?: Picture; diff?: Picture }): HTMLElement {
  const { expected, actual, diff } = set;
  const stage = element('div', { class: 'comparison-stage' });
  type Mode = 'slider' | 'expected' | 'actual' | 'diff';
  const show = (mode: Mode): void => {
    modes.show(mode);
    const one = mode === 'slider' ? null : set[mode];
    stage.replaceChildren(...(one ? [image(one)] : expected && actual ? [slider(expected, actual)] : []));
  };
  const choices = [
    ...(expected && actual ? [{ value: 'slider' as Mode, text: 'Slider', label: 'Both, with a slider' }] : []),
    ...(expected ? [{ value: 'expected' as Mode, text: 'Expected', label: 'What was expected' }] : []),
    ...(actual ? [{ value: 'actual' as Mode, text: 'Actual', label: 'What came' }] : []),
    ...(diff ? [{ value: 'diff' as Mode, text: 'Difference', label: 'Where they differ' }] : []),
  ];
  const modes = segments<Mode>('How to compare', choices, show);
  show(choices[0]!.value);
  const caption: Child = name(title);
  return element('figure', { class: 'comparison' }, element('figcaption', {}, caption, modes.root), stage);
}

/** The actual picture over the expected one, up to where the slider is. */
function slider(expected: Picture, actual: Picture): HTMLElement {
  const over = element('div', { class: 'slider-over' }, image(actual));
  const handle = element('div', { class: 'slider-handle' });
  const input = element('input', {
    class: 'slider-input',
    attributes: {
      type: 'range',
      min: 0,
      max: 1000,
      value: 500,
      'aria-label': 'Expected to the left, actual to the right',
    },
    on: { input: () => move() },
  });
  const move = (): void => {
    const share = Number(input.value) / 10;
    over.style.clipPath = `inset(0 0 0 ${share}%)`;
    handle.style.left = `${share}%`;
  };
  move();
  return element(
    'div',
    { class: 'slider' },
    image(expected),
    over,
    handle,
    input,
    element('span', { class: 'slider-tag left', text: 'expected' }),
    element('span', { class: 'slider-tag right', text: 'actual' }),
  );
}
