// Rows of the list.

import { element, name, type Child } from '../ui/dom';
import { statusIcon } from '../ui/icons';
import { statusOf } from '../data/filter';
import type { Group } from '../data/groups';
import type { Report } from '../data/report';
import { metres, outcomeNames, plural, seconds } from '../data/text';
import type { AgainstRow, WalkRow } from '../format';
import { formatLink } from '../data/link';
import { thumbnail } from './thumbnail';

export const rowHeight = 66;
export const headHeight = 40;

export function groupHead(group: Group): HTMLElement {
  return element(
    'div',
    { class: 'group-head' },
    element('h3', {}, name(group.file)),
    element('span', { class: 'muted', text: plural(group.walks.length, 'walk') }),
    group.failed > 0 && element('span', { class: 'outcome failed', text: `${group.failed} failed` }),
  );
}

interface RowOptions {
  inGroup: boolean;
  addTag: (tag: string) => void;
  hover: (inside: boolean) => void;
}

export function walkRow(report: Report, row: WalkRow, options: RowOptions): HTMLElement {
  const status = statusOf(row);
  const tagButton = (tag: string): HTMLElement =>
    element(
      'button',
      {
        class: 'chip tag',
        attributes: { type: 'button', 'aria-label': `Filter by tag ${tag}` },
        on: { click: () => options.addTag(tag) },
      },
      name(`@${tag}`),
    );
  const made = rowOf(
    report,
    row,
    `${status} ${options.inGroup ? 'in-group' : ''}`,
    linkTo(row, false),
    [row.repetition > 0 && element('span', { class: 'chip', text: `#${row.repetition}` }), ...row.tags.map(tagButton)],
    [secondLine(row, status), element('span', { class: 'visually-hidden', text: outcomeNames[status] ?? status })],
    [
      element('span', { text: row.ticks > 0 ? seconds(row.seconds) : '' }),
      element('span', { class: 'muted', text: row.ticks > 0 ? metres(row.distance) : '' }),
    ],
  );
  made.addEventListener('mouseenter', () => options.hover(true));
  made.addEventListener('mouseleave', () => options.hover(false));
  return made;
}

function linkTo(row: WalkRow, against: boolean): HTMLElement {
  const href = formatLink({ walk: row.id, against });
  return element('a', { class: 'walk-link', attributes: { href } }, name(row.name));
}

/** What all rows have: a picture, the outcome, the walk's title and project, what follows them, and numbers. */
function rowOf(
  report: Report,
  row: WalkRow,
  className: string,
  title: HTMLElement,
  chips: Child[],
  below: Child[],
  numbers: Child[],
): HTMLElement {
  const project = row.project !== '' && element('span', { class: 'chip' }, name(row.project));
  return element(
    'div',
    { class: `walk-row ${className}` },
    thumbnail(report, row),
    statusIcon(statusOf(row)),
    element('div', { class: 'walk-main' }, element('div', { class: 'walk-line' }, title, project, ...chips), ...below),
    element('div', { class: 'walk-numbers' }, ...numbers),
  );
}

function secondLine(row: WalkRow, status: string): HTMLElement {
  if (row.message) {
    return element(
      'div',
      { class: `walk-message ${status}`, title: row.message },
      row.code ? element('span', { class: 'code', text: row.code }) : null,
      name(row.message),
    );
  }
  return element('div', { class: 'walk-message muted' }, name(row.status_reason || row.file));
}

function howPathsDiffer(own: WalkRow, other: AgainstRow): string {
  if (other.parts_at === null) return 'the same path';
  if (other.parts_at < 0 || own.ticks === 0) return 'not recorded';
  return `paths part at ${(other.parts_at / (own.ticks / Math.max(own.seconds, 1e-9))).toFixed(2)} s`;
}

/** A walk that ended otherwise, or walked elsewhere, in the other run. */
export function againstRow(report: Report, other: AgainstRow): HTMLElement {
  const own = report.index.walks[other.index];
  const row = own ?? other;
  const changed = !own || statusOf(own) !== statusOf(other);
  const verdict = (each: WalkRow | undefined): HTMLElement =>
    element('span', {
      class: `outcome ${each ? statusOf(each) : 'skipped'}`,
      text: each ? (outcomeNames[statusOf(each)] ?? each.outcome) : 'not in this run',
    });
  const outcomes = element(
    'div',
    { class: 'walk-message' },
    verdict(other),
    element('span', { class: 'arrow', text: '→' }),
    verdict(own),
    own && element('span', { class: 'muted', text: howPathsDiffer(own, other) }),
  );
  const title = own ? linkTo(row, true) : name(row.name);
  return rowOf(report, row, changed ? 'changed' : '', title, [], [outcomes], []);
}
