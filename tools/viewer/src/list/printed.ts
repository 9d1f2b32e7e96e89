// What is printed of a list: its failures in full, the rest in numbers. The list itself holds only the rows in view.

import { element, name } from '../ui/dom';
import { statusOf } from '../data/filter';
import { counted, isBad } from '../data/groups';
import type { Report } from '../data/report';
import { metres, outcomeNames, plural, seconds } from '../data/text';

const most = 400; // rows on paper

export function printedSummary(report: Report, selected: readonly number[]): HTMLElement {
  const { walks, title } = report.index;
  const counts = counted(walks, selected);
  const bad = selected.filter((index) => isBad(walks[index]!.outcome));
  const good = selected.filter((index) => !isBad(walks[index]!.outcome));
  const shown = [...bad, ...good].slice(0, most);
  return element(
    'div',
    {},
    element('h1', {}, name(title)),
    element(
      'p',
      {},
      `${plural(counts.total, 'walk')}: ${counts.failed} failed, ${counts.passed + counts.xfail} passed, ${counts.skipped} skipped; `,
      `${seconds(counts.seconds)} simulated, ${metres(counts.distance)} walked.`,
    ),
    element(
      'table',
      {},
      element(
        'thead',
        {},
        element('tr', {}, ...['outcome', 'walk', 'what came'].map((text) => element('th', { text }))),
      ),
      element(
        'tbody',
        {},
        ...shown.map((index) => {
          const row = walks[index]!;
          return element(
            'tr',
            {},
            element('td', { text: outcomeNames[statusOf(row)] ?? row.outcome }),
            element('td', {}, name(row.id)),
            element('td', {}, name(row.message ?? '')),
          );
        }),
      ),
    ),
    shown.length < selected.length &&
      element('p', { text: `and ${plural(selected.length - shown.length, 'walk')} more` }),
  );
}
