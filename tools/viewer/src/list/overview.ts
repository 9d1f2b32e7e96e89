// A plan of the campus with the paths of all walks that are listed; the one under the pointer can be opened.

import { element, Scope, setText } from '../ui/dom';
import { isBad } from '../data/groups';
import { formatLink } from '../data/link';
import { planPoints } from '../data/path';
import type { Report } from '../data/report';
import { channelsOf, Density } from '../plan/density';
import { colorsOf, fitted, PlanCanvas } from '../plan/plan';
import { plural } from '../data/text';
import { later } from '../ui/later';
import type { Campuses } from '../scene/campuses';

interface Track {
  walk: number;
  points: [number, number][];
}

const many = 200; // paths that are drawn as lines; more become an image

export class Overview {
  readonly root: HTMLElement;
  private readonly plan: PlanCanvas;
  private readonly caption = element('p', { class: 'overview-caption muted' });
  private readonly select: HTMLSelectElement;
  private readonly images = new Map<number, HTMLCanvasElement>();
  private campus = 0;
  private selected: readonly number[] = [];
  private tracks: Track[] = [];
  private pointed = -1;
  private pending = 0;
  private waiting = 0;
  private layer: PlanCanvas | null = null;
  /** Counts the drawings, so that an old one ends when a new one begins. */
  private round = 0;
  /** Whether it has the size of a picture that is taken, and not that of its place. */
  private isPosing = false;
  /** Called when all paths are drawn. */
  private complete: () => void = () => {};

  constructor(
    private readonly report: Report,
    private readonly campuses: Campuses,
    private readonly scope: Scope,
  ) {
    const canvas = element('canvas', {
      attributes: { role: 'img', 'aria-label': 'Plan of the campus with the paths of all listed walks' },
    });
    const names = report.index.campuses.map((campus) => campus.name);
    this.select = element('select', {
      class: 'select',
      attributes: { 'aria-label': 'Campus' },
      on: { change: () => this.choose(Number(this.select.value)) },
    });
    names.forEach((campus, index) =>
      this.select.append(element('option', { text: campus, attributes: { value: index } })),
    );
    this.root = element(
      'aside',
      { class: 'overview', attributes: { 'aria-label': 'Plan' } },
      element('div', { class: 'overview-head' }, element('h2', { text: 'All paths' }), names.length > 1 && this.select),
      element('div', { class: 'overview-plan' }, canvas),
      this.caption,
    );
    this.root.hidden = names.length === 0;
    this.plan = new PlanCanvas(canvas);
    const holder = canvas.parentElement!;
    scope.resized(holder, () => {
      if (this.isPosing) return;
      this.plan.resize(holder.clientWidth, holder.clientHeight);
      this.draw();
    });
    scope.listen(canvas, 'pointermove', (event) => this.point(this.nearest(event.offsetX, event.offsetY)));
    scope.listen(canvas, 'pointerleave', () => this.point(-1));
    scope.listen(canvas, 'click', () => {
      const row = report.index.walks[this.pointed];
      if (row) location.hash = formatLink({ walk: row.id });
    });
    scope.listen(window, 'themechange' as keyof WindowEventMap, () => this.draw());
    scope.add(() => (cancelAnimationFrame(this.pending), clearTimeout(this.waiting)));
    // When there is nothing else to do, the real campus is drawn under the paths.
    const later = setTimeout(() => void this.loadImage(), 150);
    scope.add(() => clearTimeout(later));
  }

  /** The plan in a size of its own, as a PNG's data: address. */
  async picture(width: number, height: number): Promise<string> {
    await this.loadImage();
    const holder = this.plan.canvas.parentElement!;
    this.isPosing = true;
    // What is listed belongs in it, even if the plan still waits for a pause in the typing.
    clearTimeout(this.waiting);
    this.collect();
    const completed = new Promise<void>((resolve) => (this.complete = resolve));
    this.plan.resize(width, height);
    this.draw();
    await completed;
    const address = this.plan.canvas.toDataURL('image/png');
    this.isPosing = false;
    this.plan.resize(holder.clientWidth, holder.clientHeight);
    this.draw();
    return address;
  }

  show(selected: readonly number[]): void {
    this.selected = selected;
    // Each key of a filter's word changes what is listed: the plan follows when the typing pauses.
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => {
      this.collect();
      this.draw();
    }, 60);
  }

  /** Emphasizes a walk; -1 ends that. */
  point(walk: number): void {
    if (walk === this.pointed) return;
    this.pointed = walk;
    this.schedule();
  }

  private choose(campus: number): void {
    this.campus = campus;
    this.collect();
    this.draw();
    void this.loadImage();
  }

  private async loadImage(): Promise<void> {
    if (this.root.offsetParent === null || this.images.has(this.campus)) return;
    const { campus } = this;
    const image = await this.campuses.plan(campus).catch(() => null);
    if (image) this.images.set(campus, image);
    if (!this.scope.isOver) this.draw();
  }

  private collect(): void {
    this.tracks = this.selected
      .map((walk) => ({ walk, row: this.report.index.walks[walk]! }))
      .filter(({ row }) => row.campus === this.campus && (row.plan?.length ?? 0) > 0)
      .map(({ walk, row }) => ({ walk, points: planPoints(row.plan) }));
  }

  private schedule(): void {
    this.pending ||= requestAnimationFrame(() => {
      this.pending = 0;
      this.compose();
    });
  }

  /** Draws campus and paths into a layer of their own, a few paths at a time. */
  private draw(): void {
    const campus = this.report.index.campuses[this.campus];
    if (!campus || this.plan.width < 2) return;
    const round = ++this.round;
    const layer = new PlanCanvas(document.createElement('canvas'));
    layer.resize(this.plan.width, this.plan.height);
    layer.view = this.plan.view = fitted(campus.min, campus.max, this.plan.width, this.plan.height);
    layer.drawCampus(campus, this.images.get(this.campus) ?? null, colorsOf(this.root));
    this.layer = layer;
    const { walks } = this.report.index;
    const bad = this.tracks.filter((track) => isBad(walks[track.walk]!.outcome));
    const good = this.tracks.filter((track) => !isBad(walks[track.walk]!.outcome));
    this.drawTracks(layer, round, good, '--trail', 1.5, good.length > 40 ? 0.6 : 0.9);
    this.drawTracks(layer, round, bad, '--failed', 2, 0.95);
    later(() => {
      if (round !== this.round || this.scope.isOver) return;
      for (const { points } of bad.slice(0, 500)) {
        layer.drawMark({ x: points.at(-1)![0], z: points.at(-1)![1], color: this.color('--failed') }, 3.5);
      }
      this.compose();
      this.complete();
    });
    this.compose();
  }

  private drawTracks(
    layer: PlanCanvas,
    round: number,
    tracks: Track[],
    color: string,
    width: number,
    opacity: number,
  ): void {
    const isCurrent = (): boolean => round === this.round && !this.scope.isOver;
    if (tracks.length <= many) {
      later(() => {
        if (!isCurrent()) return;
        const paths = tracks.map((track) => track.points);
        // Light edges, so that they are seen on a campus of any colour.
        layer.drawPaths(paths, '#ffffff', width + 2, 0.5);
        layer.drawPaths(paths, this.color(color), width, opacity);
        this.schedule();
      });
      return;
    }
    const density = new Density(Math.round(layer.width), Math.round(layer.height));
    for (let from = 0; from < tracks.length; from += many) {
      later(() => {
        if (!isCurrent()) return;
        for (const { points } of tracks.slice(from, from + many))
          density.add(points.map(([x, z]) => layer.toPixels(x, z)));
      });
    }
    later(() => {
      if (!isCurrent()) return;
      const image = document.createElement('canvas');
      image.width = Math.round(layer.width);
      image.height = Math.round(layer.height);
      image.getContext('2d')!.putImageData(density.image(channelsOf(this.color(color))), 0, 0);
      layer.context.drawImage(image, 0, 0, layer.width, layer.height);
      this.schedule();
    });
  }

  /** The layer, and over it the path that is pointed at. */
  private compose(): void {
    const campus = this.report.index.campuses[this.campus];
    if (!this.layer || !campus) return;
    const { walks } = this.report.index;
    this.plan.context.drawImage(this.layer.canvas, 0, 0, this.plan.width, this.plan.height);
    const pointed = this.tracks.find((track) => track.walk === this.pointed);
    if (pointed) {
      const isFailed = isBad(walks[pointed.walk]!.outcome);
      this.plan.drawPath(pointed.points, '#ffffff', 6);
      this.plan.drawPath(pointed.points, this.color(isFailed ? '--failed' : '--trail'), 3);
    }
    this.plan.canvas.style.cursor = pointed ? 'pointer' : '';
    setText(
      this.caption,
      pointed ? walks[pointed.walk]!.id : `${campus.name}: ${plural(this.tracks.length, 'path')}, north (−Z) up`,
    );
  }

  private color(name: string): string {
    return getComputedStyle(this.root).getPropertyValue(name).trim();
  }

  private nearest(x: number, y: number): number {
    let best = -1;
    let nearest = 8;
    for (const { walk, points } of this.tracks) {
      for (let i = 1; i < points.length; ++i) {
        const distance = toSegment(x, y, this.plan.toPixels(...points[i - 1]!), this.plan.toPixels(...points[i]!));
        if (distance < nearest) {
          nearest = distance;
          best = walk;
        }
      }
    }
    return best;
  }
}

function toSegment(x: number, y: number, [ax, ay]: [number, number], [bx, by]: [number, number]): number {
  const length = (bx - ax) ** 2 + (by - ay) ** 2;
  const share = length === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length));
  return Math.hypot(x - ax - share * (bx - ax), y - ay - share * (by - ay));
}
