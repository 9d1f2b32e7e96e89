// A walk's page: header, scene, time line, and panels beside it.

import { element, name, replace, Scope, type Child } from '../ui/dom';
import { button, emptyState, setPressed } from '../ui/controls';
import { statusIcon } from '../ui/icons';
import { isBad } from '../data/groups';
import { statusOf } from '../data/filter';
import { metres, outcomeNames, seconds } from '../data/text';
import type { CampusEntry, WalkRow } from '../format';
import type { Tab } from '../store';
import { authorPanel } from './author_panel';
import type { WalkContext } from './context';
import { failurePanel } from './failure_panel';
import { filePanel } from './file_panel';
import { LogPanel } from './log_panel';
import { walkPlan } from './minimap';
import { picturesPanel } from './pictures_panel';
import { Player } from './player';
import { popupWindow } from './popup_window';
import { stepsPanel } from './steps_panel';
import { Timeline } from './timeline';
import { transport } from './transport';
import { viewBar } from './view_bar';
import { Viewport } from './viewport';

interface Neighbours {
  previous: () => void;
  next: () => void;
  list: () => void;
}

export class WalkPage {
  readonly root: HTMLElement;
  readonly player: Player;
  viewport: Viewport | null = null;
  /** Fulfilled when the scene can be seen, or is known not to come. */
  readonly ready: Promise<void>;

  constructor(
    readonly context: WalkContext,
    neighbours: Neighbours,
    private readonly scope: Scope,
  ) {
    this.player = new Player(context, scope);
    const stage = element(
      'div',
      { class: 'viewport' },
      element('p', { class: 'loading', text: 'Unpacking the campus…' }),
    );
    const side = element('div', { class: 'side' });
    const hasRecording = context.data.path !== null;
    this.root = element(
      'main',
      { class: 'walk' },
      header(context, neighbours),
      stage,
      side,
      element(
        'div',
        { class: 'time-bar' },
        hasRecording && transport(context, this.player, scope),
        hasRecording && new Timeline(context, this.player, scope).root,
      ),
    );
    this.ready = this.fill(stage, side);
  }

  private async fill(stage: HTMLElement, side: HTMLElement): Promise<void> {
    const { context, scope } = this;
    const { campuses, data } = context;
    let note = '';
    if (context.campus && campuses.stage) {
      // Lets the page show itself before the geometry is unpacked.
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      try {
        const loaded = await campuses.show(data.row.campus);
        if (scope.isOver) return;
        this.viewport = new Viewport(context, campuses.stage, loaded, scope);
      } catch (error) {
        note = `The campus can't be shown: ${error instanceof Error ? error.message : String(error)}`;
      }
    } else {
      note = context.campus
        ? campuses.whyNot
        : data.row.outcome === 'skipped'
          ? 'This walk was skipped.'
          : 'There is no campus to show.';
    }
    if (scope.isOver) return;
    this.fillStage(stage, note);
    this.fillSide(side);
    if (this.viewport) {
      context.campuses.stage?.draw();
      if (
        isBad(data.row.outcome) &&
        context.failures.length > 0 &&
        context.store.state.tick === context.failures[0]!.failure.scene?.tick
      ) {
        this.viewport.showFailure(0);
      }
    }
  }

  private fillStage(stage: HTMLElement, note: string): void {
    const { context, scope, viewport } = this;
    if (!viewport) {
      replace(
        stage,
        element(
          'div',
          { class: 'flat' },
          element('p', { class: 'note banner', text: note, attributes: { role: 'note' } }),
          context.campus && walkPlan(context, scope, false),
          popupWindow(context, scope),
        ),
      );
      return;
    }
    const minimap = walkPlan(context, scope, true);
    context.store.on(scope, 'layers', ({ plan }) => (minimap.hidden = !plan));
    replace(
      stage,
      viewport.root,
      viewBar(context, context.campuses.stage!, () => viewport.overlook(), scope),
      popupWindow(context, scope),
      minimap,
      context.other ? legend(context) : geometryNote(context.campus),
    );
  }

  private fillSide(side: HTMLElement): void {
    const { context, scope, viewport } = this;
    const { details } = context.data;
    const problems = context.failures.length + details.result.complaints.length;
    const all: { id: Tab; text: string; count?: number; make: () => HTMLElement }[] = [
      {
        id: 'failure',
        text: problems > 1 ? 'Failures' : 'Failure',
        count: problems,
        make: () => failurePanel(context, this.player, (index) => this.showFailure(index)),
      },
      { id: 'log', text: 'Log', make: () => new LogPanel(context, this.player, scope).root },
      { id: 'steps', text: 'Steps', make: () => stepsPanel(context, this.player, scope) },
      {
        id: 'pictures',
        text: 'Pictures',
        count: Object.keys(details.pictures ?? {}).length,
        make: () => picturesPanel(context),
      },
      { id: 'file', text: 'File', make: () => filePanel(context) },
      { id: 'author', text: 'Author', make: () => authorPanel(context, viewport, scope) },
    ];
    const tabs = all.filter(({ id }) => id !== 'failure' || problems > 0);
    const panel = element('div', { class: 'panel', attributes: { role: 'tabpanel', tabindex: -1, id: 'panel' } });
    const made = new Map<Tab, HTMLElement>();
    const choose = (id: Tab): void => context.store.set({ tab: id });
    const heads = tabs.map((tab) =>
      element(
        'button',
        {
          class: 'tab',
          attributes: { type: 'button', role: 'tab', 'aria-controls': 'panel', 'data-tab': tab.id },
          on: { click: () => choose(tab.id) },
        },
        tab.text,
        tab.count ? element('span', { class: 'count', text: String(tab.count) }) : null,
      ),
    );
    const bar = element('div', { class: 'tabs', attributes: { role: 'tablist', 'aria-label': 'Panels' } }, ...heads);
    scope.listen(bar, 'keydown', (event) => {
      const move = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
      if (move === 0) return;
      event.stopPropagation();
      const next = (heads.findIndex((head) => head === document.activeElement) + move + heads.length) % heads.length;
      heads[next]?.focus();
      choose(tabs[next]!.id);
    });
    context.store.on(scope, 'tab', (id) => {
      const tab = tabs.find((each) => each.id === id) ?? tabs[0]!;
      heads.forEach((head, i) => {
        head.setAttribute('aria-selected', String(tabs[i] === tab));
        head.tabIndex = tabs[i] === tab ? 0 : -1;
      });
      const content = made.get(tab.id) ?? tab.make();
      made.set(tab.id, content);
      replace(panel, content);
      if (tab.id === 'file') content.querySelector('.marked')?.scrollIntoView({ block: 'center' });
    });
    replace(side, bar, panel);
  }

  /** Whether the other run has this walk, too. */
  get canCompare(): boolean {
    return comparable(this.context);
  }

  showFailure(index: number): void {
    if (this.viewport) this.viewport.showFailure(index);
    else this.player.goTo(this.context.failures[index]?.failure.scene?.tick ?? 0);
  }
}

function header(context: WalkContext, neighbours: Neighbours): HTMLElement {
  const { row, details } = context.data;
  const status = statusOf(row);
  return element(
    'header',
    { class: 'walk-header' },
    button({ icon: 'back', label: 'All walks', text: 'All walks', key: 'Esc', class: 'plain', act: neighbours.list }),
    element(
      'div',
      { class: 'walk-title' },
      element('h1', {}, statusIcon(status), name(row.name)),
      element('p', { class: 'walk-facts' }, ...facts(row, details.result.campus, outcomeNames[status] ?? status)),
    ),
    comparisonButton(context),
    button({ icon: 'back', label: 'Previous walk', key: 'K', class: 'plain', act: neighbours.previous }),
    button({ icon: 'next', label: 'Next walk', key: 'J', class: 'plain', act: neighbours.next }),
  );
}

function facts(row: WalkRow, campus: string, outcome: string): Child[] {
  return [
    element('span', { class: `outcome ${statusOf(row)}`, text: outcome }),
    element('span', {}, name(row.file)),
    campus !== '' && element('span', {}, 'campus ', name(campus)),
    row.project !== '' && element('span', { class: 'chip' }, name(row.project)),
    row.repetition > 0 && element('span', { text: `repetition ${row.repetition}` }),
    ...row.tags.map((tag) => element('span', { class: 'chip tag' }, name(`@${tag}`))),
    row.ticks > 0 && element('span', { text: seconds(row.seconds) }),
    row.ticks > 0 && element('span', { text: metres(row.distance) }),
  ];
}

function comparisonButton(context: WalkContext): Child {
  const { against } = context.report.index;
  if (!against || !comparable(context)) return null;
  const toggle = button({
    icon: 'compare',
    label: `Compare with ${against.name}`,
    text: 'Compare',
    key: 'C',
    class: 'small',
    act: () => context.store.set({ against: !context.store.state.against }),
  });
  setPressed(toggle, context.other !== null);
  return toggle;
}

function comparable(context: WalkContext): boolean {
  const index = context.store.state.walk;
  return context.report.index.against?.walks.some((row) => row.index === index) ?? false;
}

/** Where what is shown isn't the model itself. */
function geometryNote(campus: CampusEntry | null): HTMLElement | null {
  const note = (text: string): HTMLElement => element('p', { class: 'note corner', text });
  if (!campus) return null;
  const { geometry, objects } = campus;
  if (geometry?.kind === 'simplified') return note(`Geometry simplified to ${Math.round(geometry.error * 100)} cm`);
  if (geometry) return null;
  return note(objects.length > 0 ? 'Boxes stand in for the geometry.' : 'This report has no geometry.');
}

function legend(context: WalkContext): HTMLElement {
  const { other, data } = context;
  const outcome = (row: WalkRow): string => outcomeNames[statusOf(row)] ?? row.outcome;
  return element(
    'div',
    { class: 'legend' },
    element('div', { class: 'legend-row this' }, `this run: ${outcome(data.row)}`),
    element('div', { class: 'legend-row other' }, name(other?.name ?? ''), `: ${outcome(other?.data.row ?? data.row)}`),
  );
}

export function missingWalk(row: WalkRow, list: () => void): HTMLElement {
  return element(
    'main',
    { class: 'walk-missing' },
    button({ icon: 'back', label: 'All walks', text: 'All walks', class: 'plain', act: list }),
    emptyState(
      `${row.id}: ${outcomeNames[statusOf(row)] ?? row.outcome}`,
      row.status_reason ? element('p', { text: row.status_reason }) : null,
      row.message ? element('pre', { class: 'complaint', text: row.message }) : null,
      element('p', { text: 'The report holds nothing more of this walk.' }),
    ),
  );
}
