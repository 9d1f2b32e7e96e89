// All walks of a run: counts, filter, rows, and a plan with all paths.

import { button, emptyState, segments } from '../ui/controls';
import { element, name, replace, Scope, setText } from '../ui/dom';
import { VirtualList } from '../ui/virtual_list';
import { icon } from '../ui/icons';
import { has, parseFilter, quoted, searchable, statusOf, toggled, type SearchableRow } from '../data/filter';
import { counted, grouped, type Counts, type Group } from '../data/groups';
import type { Report } from '../data/report';
import { metres, plural, seconds } from '../data/text';
import type { Campuses } from '../scene/campuses';
import type { Store } from '../store';
import { Overview } from './overview';
import { printedSummary } from './printed';
import { againstRow, groupHead, headHeight, rowHeight, walkRow } from './rows';

type Row = { head: Group } | { walk: number; inGroup: boolean };

export class ListPage {
  readonly root: HTMLElement;
  readonly filterBox: HTMLInputElement;
  private readonly rows: SearchableRow[];
  private readonly list: VirtualList;
  private readonly counts = element('div', {
    class: 'counts',
    attributes: { role: 'group', 'aria-label': 'Outcomes' },
  });
  private readonly totals = element('p', { class: 'totals', attributes: { role: 'status' } });
  private readonly empty = element('div', { class: 'list-empty' });
  private readonly printed = element('div', { class: 'printed' });
  readonly overview: Overview;
  private selected: number[] = [];
  /** Of all walks. */
  private readonly total: Counts;
  private mode: 'walks' | 'against' = 'walks';
  /** Milliseconds that the last filtering took; for tests. */
  filterTime = 0;

  constructor(
    private readonly report: Report,
    private readonly store: Store,
    campuses: Campuses,
    scope: Scope,
  ) {
    const { walks } = report.index;
    this.rows = walks.map((row) => searchable(row, report.campusOf(row)?.name ?? ''));
    this.total = counted(walks, [...walks.keys()]);
    this.list = new VirtualList(scope, 'walks');
    this.list.root.setAttribute('aria-label', 'Walks');
    this.filterBox = element('input', {
      class: 'input filter-box',
      attributes: {
        type: 'search',
        placeholder: 'Filter: s:failed  @tag  p:project  text',
        'aria-label': 'Filter',
        'aria-keyshortcuts': '/',
        spellcheck: 'false',
      },
      on: { input: () => store.set({ query: this.filterBox.value }) },
    });
    this.overview = new Overview(report, campuses, scope);
    this.root = element(
      'main',
      { class: 'list' },
      this.banners(),
      element(
        'div',
        { class: 'list-top' },
        this.counts,
        element('div', { class: 'filter' }, icon('search'), this.filterBox),
        this.modeSwitch(),
      ),
      this.totals,
      element(
        'div',
        { class: 'list-body' },
        element('div', { class: 'list-main' }, this.list.root, this.empty),
        this.overview.root,
      ),
      this.printed,
    );
    store.on(scope, 'query', (query) => this.filter(query));
    scope.listen(window, 'themechange' as keyof WindowEventMap, () => this.showRows());
    scope.listen(window, 'beforeprint', () => replace(this.printed, printedSummary(report, this.selected)));
  }

  private banners(): HTMLElement {
    const { complete, problems } = this.report.index;
    return element(
      'div',
      { class: 'banners' },
      !complete &&
        element(
          'p',
          { class: 'note banner warn' },
          icon('warning'),
          'This run is not complete: some planned walks are missing.',
        ),
      ...(problems ?? []).map((problem) => element('p', { class: 'note banner warn' }, icon('warning'), problem)),
    );
  }

  private modeSwitch(): HTMLElement | null {
    const { against } = this.report.index;
    if (!against) return null;
    const changed = against.walks.filter((row) => {
      const own = this.report.index.walks[row.index];
      return !own || statusOf(own) !== statusOf(row);
    }).length;
    const modes = segments<'walks' | 'against'>(
      'What is listed',
      [
        { value: 'walks', text: 'Walks', label: 'All walks of this run' },
        {
          value: 'against',
          text: `Against ${against.name}: ${changed} changed`,
          label: `What differs from ${against.name}`,
        },
      ],
      (mode) => {
        this.mode = mode;
        modes.show(mode);
        this.showRows();
      },
    );
    modes.show('walks');
    return modes.root;
  }

  private filter(query: string): void {
    const start = performance.now();
    if (this.filterBox.value !== query) this.filterBox.value = query;
    const filter = parseFilter(query);
    this.selected = [];
    this.rows.forEach((row, index) => filter.matches(row) && this.selected.push(index));
    const counts = counted(this.report.index.walks, this.selected);
    this.showCounts(counts, query);
    this.showRows();
    this.filterTime = performance.now() - start;
    this.overview.show(this.selected);
  }

  private showCounts(counts: Counts, query: string): void {
    const all = this.report.index.walks.length;
    const { total } = this;
    const chip = (status: string, label: string, count: number): HTMLElement | null =>
      count === 0
        ? null
        : element(
            'button',
            {
              class: `count-chip ${status}`,
              attributes: { type: 'button', 'aria-pressed': String(has(query, `s:${status}`)) },
              on: { click: () => this.store.set({ query: toggled(this.store.state.query, `s:${status}`) }) },
            },
            element('strong', { text: count.toLocaleString('en') }),
            element('span', { text: label }),
          );
    const unfinished = (['bad_input', 'broken', 'interrupted'] as const).map((outcome) =>
      chip(outcome, outcome.replace('_', ' '), total[outcome]),
    );
    replace(
      this.counts,
      chip('failed', 'failed', total.failed),
      ...unfinished,
      chip('passed', 'passed', total.passed),
      chip('xfail', 'failed as expected', total.xfail),
      chip('skipped', 'skipped', total.skipped),
    );
    const shown =
      counts.total === all ? plural(all, 'walk') : `${counts.total.toLocaleString('en')} of ${plural(all, 'walk')}`;
    setText(this.totals, `${shown} · ${seconds(counts.seconds)} simulated · ${metres(counts.distance)} walked`);
  }

  private showRows(): void {
    if (this.mode === 'against') return this.showAgainst();
    const rows: Row[] = [];
    for (const group of grouped(this.report.index.walks, this.selected)) {
      const inGroup = group.walks.length > 1;
      if (inGroup) rows.push({ head: group });
      for (const walk of group.walks) rows.push({ walk, inGroup });
    }
    this.showEmpty(rows.length === 0);
    this.list.show({
      count: rows.length,
      height: (i) => ('head' in rows[i]! ? headHeight : rowHeight),
      key: (i) => i,
      render: (i) => this.row(rows[i]!),
    });
  }

  private row(row: Row): HTMLElement {
    if ('head' in row) return groupHead(row.head);
    return walkRow(this.report, this.report.index.walks[row.walk]!, {
      inGroup: row.inGroup,
      addTag: (tag) => this.store.set({ query: toggled(this.store.state.query, quoted(`@${tag}`)) }),
      hover: (inside) => this.overview.point(inside ? row.walk : -1),
    });
  }

  private showAgainst(): void {
    const all = this.report.index.against?.walks ?? [];
    const own = new Set(this.selected);
    const isAll = this.selected.length === this.rows.length;
    const rows = all.filter((row) => isAll || own.has(row.index));
    this.showEmpty(rows.length === 0);
    this.list.show({
      count: rows.length,
      height: () => rowHeight,
      key: (i) => `against ${i}`,
      render: (i) => againstRow(this.report, rows[i]!),
    });
  }

  private showEmpty(isEmpty: boolean): void {
    this.empty.hidden = !isEmpty;
    if (!isEmpty) return;
    const { query } = this.store.state;
    replace(
      this.empty,
      query === ''
        ? emptyState(this.mode === 'against' ? 'Nothing differs.' : 'This run has no walks.')
        : emptyState(
            'No walk matches.',
            element('p', {}, 'The filter is ', name(query), '.'),
            button({
              label: 'Remove the filter',
              text: 'Remove the filter',
              class: 'small',
              act: () => this.store.set({ query: '' }),
            }),
          ),
    );
  }
}
