// The log beside the scene: it follows the time, and a click on a line goes there.

import { element, name, Scope } from '../ui/dom';
import { emptyState } from '../ui/controls';
import { VirtualList } from '../ui/virtual_list';
import { groupOf } from '../data/spans';
import type { LogLine } from '../data/log';
import type { WalkContext } from './context';
import type { Player } from './player';

const lineHeight = 26;

export class LogPanel {
  readonly root: HTMLElement;
  private readonly list: VirtualList;
  private shown: LogLine[] = [];
  private query = '';
  private stays = false;
  private current = -1;

  constructor(
    private readonly context: WalkContext,
    private readonly player: Player,
    scope: Scope,
  ) {
    this.list = new VirtualList(scope, 'log');
    this.list.root.setAttribute('aria-label', 'Log');
    const search = element('input', {
      class: 'input small',
      attributes: {
        type: 'search',
        placeholder: 'Find in the log',
        'aria-label': 'Find in the log',
        spellcheck: 'false',
      },
      on: { input: () => this.refine({ query: search.value }) },
    });
    const stays = element('input', {
      attributes: { type: 'checkbox' },
      on: { change: () => this.refine({ stays: stays.checked }) },
    });
    this.root =
      context.data.log.length === 0
        ? emptyState('No log was kept.', element('p', { text: 'Record the walk with --record report.' }))
        : element(
            'div',
            { class: 'log-panel' },
            element(
              'div',
              { class: 'panel-bar' },
              search,
              element(
                'label',
                { class: 'check', title: 'The lines that only say that a contact goes on' },
                stays,
                element('span', { text: 'stay' }),
              ),
            ),
            this.list.root,
          );
    this.refine({});
    scope.resized(this.list.root, () => this.current >= 0 && this.list.reveal(this.current));
    context.store.on(scope, 'tick', (tick) => this.follow(this.lineAt(tick)));
  }

  private refine(changes: { query?: string; stays?: boolean }): void {
    this.query = (changes.query ?? this.query).toLowerCase();
    this.stays = changes.stays ?? this.stays;
    this.shown = this.context.data.log.filter(
      (line) => (this.stays || !line.kind.endsWith('.stay')) && line.text.toLowerCase().includes(this.query),
    );
    this.current = -1;
    this.list.show({
      count: this.shown.length,
      height: () => lineHeight,
      key: (row) => row,
      render: (row) => this.line(row),
    });
    this.follow(this.lineAt(this.context.store.state.tick));
  }

  /** The last line at or before the tick. */
  private lineAt(tick: number): number {
    let low = -1;
    let high = this.shown.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.shown[middle]!.tick <= tick + 1e-6) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  private follow(index: number): void {
    if (index === this.current) return;
    this.mark(this.current, false);
    this.current = index;
    if (index >= 0) this.list.reveal(index);
    this.mark(index, true);
  }

  private mark(row: number, current: boolean): void {
    this.list.visibleRows.get(row)?.firstElementChild?.classList.toggle('current', current);
  }

  private line(row: number): HTMLElement {
    const line = this.shown[row]!;
    const details = line.fields
      .filter((field) => field.name !== 'pos')
      .map((field) => `${field.name}=${field.value}`)
      .join(' ');
    const go = element(
      'button',
      {
        class: `log-line event-${groupOf(line.kind)} ${row === this.current ? 'current' : ''}`,
        title: line.text,
        attributes: { type: 'button', 'data-tick': line.tick },
        on: { click: () => this.player.goTo(line.tick) },
      },
      element('span', { class: 'log-time', text: line.seconds.toFixed(2) }),
      element('span', { class: 'log-kind', text: line.kind }),
      name(line.object, 'log-object'),
      element('span', { class: 'log-details', text: details }),
    );
    return element('div', {}, go);
  }
}
