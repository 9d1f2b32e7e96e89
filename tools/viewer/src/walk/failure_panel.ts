// What went wrong: expected and came, where, in numbers, and the command that plays it again.

import { button, copyable } from '../ui/controls';
import { element, name, type Child } from '../ui/dom';
import type { Measure } from '../data/obstacle';
import { parseLogLine } from '../data/log';
import { replayCommand } from '../data/snippets';
import type { Complaint } from '../format';
import type { WalkContext } from './context';
import { markedFile } from './file_panel';
import type { Player } from './player';

export function failurePanel(context: WalkContext, player: Player, show: (failure: number) => void): HTMLElement {
  const { result } = context.data.details;
  const { row } = context.data;
  return element(
    'div',
    { class: 'failures' },
    row.expected_to_fail &&
      element(
        'p',
        { class: 'note' },
        'This walk is expected to fail',
        result.status_reason ? `: ${result.status_reason}` : '',
        '.',
      ),
    ...result.complaints.map((complaint) => complaintCard(context, complaint)),
    ...context.failures.map((_, index) => failureCard(context, player, index, show)),
    replay(context),
  );
}

function complaintCard(context: WalkContext, { code, message, file, line }: Complaint): HTMLElement {
  return element(
    'section',
    { class: 'failure', attributes: { 'aria-label': 'Error in a file' } },
    element('header', {}, element('span', { class: 'code', text: code })),
    element('p', { class: 'message', text: message, attributes: { dir: 'auto' } }),
    file !== '' && markedFile(context, file, line, 3),
  );
}

function failureCard(
  context: WalkContext,
  player: Player,
  index: number,
  show: (failure: number) => void,
): HTMLElement {
  const { failure, obstacle } = context.failures[index]!;
  const { scene } = failure;
  return element(
    'section',
    { class: 'failure', attributes: { 'aria-label': `Failure ${index + 1}` } },
    element(
      'header',
      {},
      element('span', { class: 'code', text: failure.code }),
      scene &&
        element('button', {
          class: 'link',
          text: `${scene.time.toFixed(2)} s`,
          attributes: { type: 'button' },
          on: { click: () => player.goTo(scene.tick) },
        }),
      button({ icon: 'search', label: 'Show where', text: 'Show where', class: 'small', act: () => show(index) }),
    ),
    element('p', { class: 'message', text: failure.message, attributes: { dir: 'auto' } }),
    failure.expected !== undefined &&
      element(
        'dl',
        { class: 'expected' },
        element('dt', { text: 'expected' }),
        element('dd', { text: failure.expected }),
        element('dt', { text: 'came' }),
        element('dd', { text: failure.actual }),
      ),
    obstacle.measure && measureBar(obstacle.measure),
    scene &&
      facts([
        ['where', scene.position.map((value) => value.toFixed(2)).join(', ')],
        ['object', obstacle.object],
        ['in or near', scene.building],
        ['nearest', scene.nearest ? `${scene.nearest}, ${scene.nearest_distance.toFixed(2)} m` : ''],
      ]),
    failure.file !== '' && markedFile(context, failure.file, failure.line, 3),
    scene && scene.last_events.length > 0 && lastEvents(scene.last_events, player),
  );
}

function facts(rows: [string, string][]): HTMLElement {
  const shown = rows.filter(([, value]) => value !== '');
  return element(
    'dl',
    { class: 'facts' },
    ...shown.flatMap(([key, value]): Child[] => [element('dt', { text: key }), element('dd', {}, name(value))]),
  );
}

/** What was measured, beside what the body manages or needs. */
function measureBar({ kind, measured, allowed, unit }: Measure): HTMLElement {
  const most = Math.max(measured, allowed ?? 0);
  const needs = kind === 'headroom' || kind === 'opening';
  const bar = (label: string, value: number, className: string): HTMLElement => {
    const fill = element('span', { class: `bar ${className}` });
    fill.style.width = `${(value / most) * 100}%`;
    return element(
      'div',
      { class: 'measure-row' },
      element('span', { class: 'measure-label', text: label }),
      element('span', { class: 'bar-track' }, fill),
      element('span', { class: 'measure-value', text: `${value.toFixed(unit === 'm' ? 2 : 1)} ${unit}` }),
    );
  };
  return element(
    'div',
    { class: 'measure', attributes: { role: 'group', 'aria-label': `${kind} in numbers` } },
    bar(kind, measured, 'bad'),
    allowed !== null && bar(needs ? 'needed' : 'possible', allowed, 'good'),
  );
}

function lastEvents(lines: readonly string[], player: Player): HTMLElement {
  return element(
    'details',
    { class: 'last-events' },
    element('summary', { text: 'The events just before' }),
    ...lines.map((text) => {
      const line = parseLogLine(text);
      return element(
        'button',
        {
          class: 'log-line',
          attributes: { type: 'button', disabled: line === null },
          on: { click: () => line && player.goTo(line.tick) },
        },
        element('span', { class: 'log-time', text: line ? line.seconds.toFixed(2) : '' }),
        element('span', { class: 'log-kind', text: line?.kind ?? text }),
        name(line?.object ?? '', 'log-object'),
      );
    }),
  );
}

function replay(context: WalkContext): Child {
  const template = context.report.index.replay ?? 'campuswalk run {file}[ --project {project}]';
  const { result } = context.data.details;
  const command = replayCommand(template, {
    file: result.file,
    project: result.project,
    config: result.config ?? '',
    name: result.name,
  });
  return element(
    'section',
    { class: 'replay' },
    element('h3', { text: 'Play it again' }),
    copyable(command, 'Copy the command'),
  );
}
