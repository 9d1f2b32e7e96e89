// The time line: steps and pop-ups as bands, every event as a mark, failures in red; a slider for hand and keys.

import { element, Scope, setText } from '../ui/dom';
import { groupOf, isDuring, type EventGroup } from '../data/spans';
import type { WalkContext } from './context';
import type { Player } from './player';

interface Mark {
  tick: number;
  row: number;
  group: EventGroup;
  text: string;
}

const rows = { steps: 20, popups: 9, events: 26 };
const top = { steps: 4, popups: 27, events: 39 };
const height = 70;
/** Where the events' marks are, from above. */
const eventRows: Record<EventGroup, number> = {
  trigger: 0,
  gaze: 1,
  contact: 2,
  body: 3,
  picture: 3,
  popup: 0,
  walk: 3,
  failure: 2,
};

export class Timeline {
  readonly root: HTMLElement;
  private readonly canvas = element('canvas', { attributes: { 'aria-hidden': 'true' } });
  private readonly cursor = element('div', { class: 'timeline-cursor' });
  private readonly tip = element('div', { class: 'timeline-tip', attributes: { role: 'status' } });
  private readonly slider: HTMLElement;
  private readonly marks: Mark[];
  private width = 0;

  constructor(
    private readonly context: WalkContext,
    private readonly player: Player,
    scope: Scope,
  ) {
    this.marks = context.events
      .filter((event) => event.group !== 'popup')
      .map((event) => ({ ...event, row: eventRows[event.group] }));
    this.slider = element(
      'div',
      {
        class: 'timeline-track',
        attributes: {
          role: 'slider',
          tabindex: 0,
          'aria-label': 'Time',
          'aria-valuemin': 0,
          'aria-valuemax': context.lastTick,
          'aria-orientation': 'horizontal',
        },
      },
      this.canvas,
      this.cursor,
      this.tip,
    );
    this.root = element('div', { class: 'timeline' }, this.slider);
    this.tip.hidden = true;
    this.listen(scope);
    scope.resized(this.slider, () => this.resize());
    context.store.on(scope, 'tick', (tick) => this.setTick(tick));
    scope.listen(window, 'themechange' as keyof WindowEventMap, () => this.draw());
  }

  private listen(scope: Scope): void {
    const { slider } = this;
    scope.listen(slider, 'pointerdown', (event) => {
      slider.setPointerCapture(event.pointerId);
      const near = this.markAt(event);
      this.player.goTo(near ? near.tick : this.tickAt(event));
    });
    scope.listen(slider, 'pointermove', (event) => {
      if (event.buttons & 1) this.player.goTo(this.tickAt(event));
      this.showTip(event);
    });
    scope.listen(slider, 'pointerleave', () => (this.tip.hidden = true));
    scope.listen(slider, 'keydown', (event) => {
      const second = this.context.ticksPerSecond;
      const moves: Record<string, number> = {
        ArrowLeft: -second,
        ArrowRight: second,
        ArrowDown: -1,
        ArrowUp: 1,
        PageDown: -10 * second,
        PageUp: 10 * second,
        Home: -Infinity,
        End: Infinity,
      };
      const move = moves[event.key];
      if (move === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      this.player.goTo(Math.min(Math.max(this.context.store.state.tick + move, 0), this.context.lastTick));
    });
  }

  private setTick(tick: number): void {
    this.cursor.style.transform = `translateX(${this.pixelsOf(tick)}px)`;
    const whole = Math.round(tick);
    const step = this.context.data.details.recording?.steps?.find((each) => isDuring(each, whole));
    this.slider.setAttribute('aria-valuenow', String(whole));
    this.slider.setAttribute(
      'aria-valuetext',
      `${(whole / this.context.ticksPerSecond).toFixed(2)} seconds, tick ${whole}${step ? `, ${step.text}` : ''}`,
    );
  }

  private resize(): void {
    this.width = this.slider.clientWidth;
    const ratio = Math.min(devicePixelRatio, 2);
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = height * ratio;
    this.draw();
    this.setTick(this.context.store.state.tick);
  }

  private pixelsOf(tick: number): number {
    return (tick / Math.max(1, this.context.lastTick)) * this.width;
  }

  private tickAt(event: PointerEvent): number {
    const { left } = this.slider.getBoundingClientRect();
    const share = (event.clientX - left) / Math.max(1, this.width);
    return Math.min(Math.max(share, 0), 1) * this.context.lastTick;
  }

  private markAt(event: PointerEvent): Mark | null {
    const { left, top: upper } = this.slider.getBoundingClientRect();
    const x = event.clientX - left;
    const y = event.clientY - upper - top.events;
    if (y < -3) return null;
    const row = Math.min(3, Math.max(0, Math.floor(y / (rows.events / 4))));
    const near = this.marks.filter((mark) => Math.abs(this.pixelsOf(mark.tick) - x) <= 4);
    const distance = (mark: Mark): number => Math.abs(mark.row - row) * 10 + Math.abs(this.pixelsOf(mark.tick) - x);
    return near.sort((a, b) => distance(a) - distance(b))[0] ?? null;
  }

  private showTip(event: PointerEvent): void {
    const { left, top: upper } = this.slider.getBoundingClientRect();
    const y = event.clientY - upper;
    const tick = this.tickAt(event);
    const recording = this.context.data.details.recording;
    const mark = this.markAt(event);
    let text = mark?.text;
    if (!text && y < top.popups) text = recording?.steps?.find((step) => isDuring(step, tick))?.text;
    if (!text && y < top.events) {
      const popup = recording?.popups?.find((each) => isDuring(each, tick));
      text = popup && `pop-up ${popup.building}`;
    }
    const time = ((mark?.tick ?? tick) / this.context.ticksPerSecond).toFixed(2);
    setText(this.tip, text ? `${time} s  ${text}` : `${time} s`);
    this.tip.hidden = false;
    const x = Math.min(Math.max(event.clientX - left, 60), Math.max(60, this.width - 60));
    this.tip.style.transform = `translateX(${x}px) translateX(-50%)`;
  }

  private draw(): void {
    const canvas = this.canvas.getContext('2d');
    if (!canvas || this.width === 0) return;
    const style = getComputedStyle(this.root);
    const color = (name: string): string => style.getPropertyValue(`--${name}`).trim();
    canvas.setTransform(this.canvas.width / this.width, 0, 0, this.canvas.height / height, 0, 0);
    canvas.clearRect(0, 0, this.width, height);
    this.drawSteps(canvas, color);
    for (const popup of this.context.data.details.recording?.popups ?? []) {
      this.band(canvas, popup, top.popups, rows.popups, color('event-popup'), 0.75);
    }
    const rowHeight = rows.events / 4;
    for (const span of this.context.spans) {
      const group = groupOf(span.kind);
      const y = top.events + eventRows[group] * rowHeight + 1;
      this.band(canvas, span, y, rowHeight - 2, color(`event-${group}`), 0.3);
    }
    for (const mark of this.marks) {
      if (mark.group === 'failure') continue;
      canvas.fillStyle = color(`event-${mark.group}`);
      canvas.fillRect(Math.round(this.pixelsOf(mark.tick)) - 1, top.events + mark.row * rowHeight, 2, rowHeight - 1);
    }
    for (const mark of this.marks) if (mark.group === 'failure') this.drawFailure(canvas, mark.tick, color('failed'));
  }

  private drawSteps(canvas: CanvasRenderingContext2D, color: (name: string) => string): void {
    canvas.font = '11px system-ui, sans-serif';
    canvas.textBaseline = 'middle';
    const steps = this.context.data.details.recording?.steps ?? [];
    const failedLines = new Set(this.context.failures.map(({ failure }) => `${failure.file}:${failure.line}`));
    steps
      .filter((step) => step.to > step.from)
      .forEach((step, i) => {
        const x = this.pixelsOf(step.from);
        const width = this.pixelsOf(step.to) - x;
        const failed = failedLines.has(`${step.file}:${step.line}`);
        this.band(canvas, step, top.steps, rows.steps, color(failed ? 'failed' : 'step'), i % 2 ? 1 : 0.72);
        if (width < 56) return;
        canvas.save();
        canvas.beginPath();
        canvas.rect(x, 0, width - 4, height);
        canvas.clip();
        canvas.fillStyle = failed ? '#ffffff' : color('step-text');
        canvas.fillText(step.text, x + 6, top.steps + rows.steps / 2 + 0.5);
        canvas.restore();
      });
  }

  private band(
    canvas: CanvasRenderingContext2D,
    { from, to }: { from: number; to: number },
    y: number,
    tall: number,
    color: string,
    opacity: number,
  ): void {
    const x = this.pixelsOf(from);
    canvas.globalAlpha = opacity;
    canvas.fillStyle = color;
    canvas.fillRect(x, y, Math.max(1, this.pixelsOf(to) - x - 1), tall);
    canvas.globalAlpha = 1;
  }

  private drawFailure(canvas: CanvasRenderingContext2D, tick: number, color: string): void {
    const x = this.pixelsOf(tick);
    canvas.fillStyle = color;
    canvas.fillRect(x - 1, 0, 2, height);
    canvas.beginPath();
    canvas.moveTo(x - 6, 0);
    canvas.lineTo(x + 6, 0);
    canvas.lineTo(x, 8);
    canvas.fill();
  }
}
