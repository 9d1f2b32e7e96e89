// The page: which of its views is shown, and its address.

import { button, emptyState } from './ui/controls';
import { append, element, name, replace, Scope } from './ui/dom';
import { helpDialog } from './ui/help';
import { useKeyboard } from './ui/keyboard';
import { themeButton, useTheme } from './ui/theme';
import { formatLink, parseLink } from './data/link';
import { grouped, isBad } from './data/groups';
import { parseFilter, searchable } from './data/filter';
import { BadReport } from './data/chunks';
import type { Report } from './data/report';
import type { AgainstRow } from './format';
import { ListPage } from './list/list_page';
import { Campuses } from './scene/campuses';
import type { Store, CameraMode } from './store';
import { contextOf } from './walk/context';
import { missingWalk, WalkPage } from './walk/walk_page';

function partingTick(row: AgainstRow): number | null {
  return row.parts_at === null || row.parts_at < 0 ? null : row.parts_at;
}

export class App {
  readonly campuses: Campuses;
  list: ListPage | null = null;
  walk: WalkPage | null = null;
  /** Fulfilled when what is shown is complete. */
  ready: Promise<void> = Promise.resolve();
  private scope = new Scope();
  private readonly body = element('div', { class: 'page' });
  /** The address that this page wrote last: not to be read again. */
  private written = '';

  constructor(
    readonly report: Report,
    readonly store: Store,
    root: HTMLElement,
  ) {
    this.campuses = new Campuses(report);
    document.title = report.index.title || 'campuswalk report';
    useTheme(store);
    replace(root, this.topBar(), this.body);
    append(document.body, helpDialog(store));
    useKeyboard(store, {
      page: () => this.walk,
      list: () => this.openList(),
      go: (direction) => this.go(direction),
      focusFilter: () => this.list?.filterBox.focus(),
    });
    window.addEventListener('hashchange', () => location.hash !== this.written && this.follow());
    this.follow();
    this.keepAddress();
  }

  private openList(): void {
    location.hash = formatLink({ query: this.store.state.query });
  }

  private topBar(): HTMLElement {
    const { title, generator } = this.report.index;
    return element(
      'header',
      { class: 'top-bar' },
      element(
        'a',
        { class: 'brand', attributes: { href: '#' } },
        element('span', { class: 'brand-mark', attributes: { 'aria-hidden': 'true' } }),
        name(title || 'campuswalk'),
      ),
      element('span', { class: 'generator muted', text: generator }),
      themeButton(this.store),
      button({
        icon: 'help',
        label: 'Keys and filters',
        key: '?',
        class: 'plain',
        act: () => this.store.set({ help: true }),
      }),
    );
  }

  /** Shows what the address says. */
  private follow(): void {
    const link = parseLink(location.hash);
    this.written = location.hash;
    if (link.walk === undefined) {
      this.store.set({ page: 'list', walk: -1, against: false, playing: false, query: link.query ?? '' });
      this.showList();
      return;
    }
    const index = this.report.index.walks.findIndex((row) => row.id === link.walk);
    if (index < 0) {
      this.showNoWalk('This report has no such walk.', link.walk);
      return;
    }
    this.ready = this.showWalk(index, link.time, link.against ?? false, link.camera).catch((error: unknown) => {
      const why = error instanceof BadReport ? error.message : 'This report is damaged: this walk is not readable.';
      this.showNoWalk(why, link.walk!);
    });
  }

  private showNoWalk(why: string, walk: string): void {
    this.end();
    this.store.set({ page: 'walk', walk: -1, against: false, playing: false });
    replace(
      this.body,
      element(
        'main',
        { class: 'walk-missing', attributes: { role: 'alert' } },
        button({ icon: 'back', label: 'All walks', text: 'All walks', class: 'plain', act: () => this.openList() }),
        emptyState(why, element('p', {}, name(walk))),
      ),
    );
  }

  private end(): void {
    this.scope.end();
    this.scope = new Scope();
    this.list = null;
    this.walk = null;
  }

  private showList(): void {
    this.end();
    this.list = new ListPage(this.report, this.store, this.campuses, this.scope);
    replace(this.body, this.list.root);
    this.ready = Promise.resolve();
  }

  private async showWalk(
    index: number,
    time: number | undefined,
    against: boolean,
    camera: string | undefined,
  ): Promise<void> {
    const row = this.report.index.walks[index]!;
    const same = this.walk?.context.data.row === row && (this.walk.context.other !== null) === against;
    if (same && time !== undefined) {
      this.walk!.player.goTo(time * this.walk!.context.ticksPerSecond);
      return;
    }
    this.end();
    const { scope } = this;
    const data = await this.report.walk(row);
    const otherRow = against ? this.report.index.against?.walks.find((each) => each.index === index) : undefined;
    const otherData = otherRow ? await this.report.walk(otherRow) : null;
    if (scope.isOver) return;
    if (!data) {
      this.store.set({ page: 'walk', walk: index, playing: false });
      replace(
        this.body,
        missingWalk(row, () => this.openList()),
      );
      return;
    }
    const other =
      otherRow && otherData
        ? { data: otherData, name: this.report.index.against?.name ?? '', partsAt: partingTick(otherRow) }
        : null;
    const context = contextOf(this.report, this.store, this.campuses, data, other);
    const failedAt = context.failures[0]?.failure.scene?.tick;
    const start =
      time !== undefined
        ? Math.round(time * context.ticksPerSecond)
        : (other?.partsAt ?? (isBad(row.outcome) ? failedAt : undefined) ?? 0);
    const modes: CameraMode[] = ['first', 'third', 'top', 'orbit', 'free'];
    this.store.set({
      page: 'walk',
      walk: index,
      against: other !== null,
      tick: Math.min(start, context.lastTick),
      playing: false,
      cut: null,
      tool: 'none',
      camera: modes.find((mode) => mode === camera) ?? 'third',
      tab: context.failures.length + data.details.result.complaints.length > 0 ? 'failure' : 'log',
    });
    this.walk = new WalkPage(
      context,
      { previous: () => this.go(-1), next: () => this.go(1), list: () => this.openList() },
      scope,
    );
    replace(this.body, this.walk.root);
    this.store.on(scope, 'against', (shown) => {
      if (shown !== (other !== null)) location.hash = formatLink({ walk: row.id, against: shown });
    });
    await this.walk.ready;
  }

  /** To the next walk of those that the filter leaves, in the list's order. */
  private go(direction: 1 | -1): void {
    const { walks } = this.report.index;
    const filter = parseFilter(this.store.state.query);
    const selected = walks.flatMap((row, index) =>
      filter.isEmpty || filter.matches(searchable(row, this.report.campusOf(row)?.name ?? '')) ? [index] : [],
    );
    const order = grouped(walks, selected).flatMap((group) => group.walks);
    const at = order.indexOf(this.store.state.walk);
    const row = walks[order[(at + direction + order.length) % order.length] ?? -1];
    if (row) location.hash = formatLink({ walk: row.id });
  }

  /** Keeps time and filter in the address, so that it can be sent to someone. */
  private keepAddress(): void {
    let waiting = 0;
    const write = (): void => {
      waiting = 0;
      // Someone has gone elsewhere, and `follow` is about to be told: that address mustn't be lost.
      if (location.hash !== this.written) return;
      const { page, walk, tick, playing, query, against, camera } = this.store.state;
      const row = this.report.index.walks[walk];
      if (playing || (page === 'walk' && (!row || !this.walk))) return;
      const time = tick / (this.walk?.context.ticksPerSecond ?? 60);
      const link =
        page === 'list'
          ? formatLink({ query })
          : formatLink({ walk: row!.id, time, against, ...(camera === 'third' ? {} : { camera }) });
      if (link === location.hash || (link === '#' && location.hash === '')) return;
      try {
        history.replaceState(null, '', link);
        this.written = location.hash;
      } catch {
        // Some browsers refuse it to pages from disk; links then lack the time.
      }
    };
    const schedule = (): void => void (waiting ||= window.setTimeout(write, 200));
    for (const each of ['tick', 'playing', 'camera', 'query'] as const) this.store.on(null, each, schedule);
  }
}
