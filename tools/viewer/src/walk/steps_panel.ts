// The walk's steps with their times; the one that is played now is marked.

import { element, name, Scope } from '../ui/dom';
import { emptyState } from '../ui/controls';
import { isDuring } from '../data/spans';
import type { WalkContext } from './context';
import type { Player } from './player';

export function stepsPanel(context: WalkContext, player: Player, scope: Scope): HTMLElement {
  const steps = context.data.details.recording?.steps ?? [];
  if (steps.length === 0) return emptyState('No steps were recorded.');
  const failed = new Set(context.failures.map(({ failure }) => `${failure.file}:${failure.line}`));
  const rows = steps.map((step) =>
    element(
      'button',
      {
        class: `step ${failed.has(`${step.file}:${step.line}`) ? 'failed' : ''}`,
        title: `${step.file}:${step.line}`,
        attributes: { type: 'button' },
        on: { click: () => player.goTo(step.from) },
      },
      element('span', { class: 'step-time', text: (step.from / context.ticksPerSecond).toFixed(1) }),
      name(step.text, 'step-text'),
      element('span', { class: 'step-length', text: lengthOf(step.to - step.from, context.ticksPerSecond) }),
    ),
  );
  context.store.on(
    scope,
    (state) => steps.findLastIndex((step) => isDuring(step, Math.round(state.tick))),
    (index) => {
      rows.forEach((row, i) =>
        i === index ? row.setAttribute('aria-current', 'step') : row.removeAttribute('aria-current'),
      );
      rows[index]?.scrollIntoView({ block: 'nearest' });
    },
  );
  return element('div', { class: 'steps' }, ...rows);
}

/** Empty for what takes no time. */
function lengthOf(ticks: number, ticksPerSecond: number): string {
  return ticks > 1 ? `${(ticks / ticksPerSecond).toFixed(1)} s` : '';
}
