// The clock of a walk: plays, steps, and stays within it.

import type { Scope } from '../ui/dom';
import type { Store } from '../store';
import type { WalkContext } from './context';

export const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 25, 50];

export class Player {
  private readonly store: Store;
  private readonly eventTicks: number[];
  private lastTime = 0;
  private pending = 0;

  constructor(
    private readonly context: WalkContext,
    scope: Scope,
  ) {
    this.store = context.store;
    this.eventTicks = [...new Set([0, ...context.events.map((event) => event.tick), context.lastTick])].sort(
      (a, b) => a - b,
    );
    this.store.on(scope, 'playing', (playing) => (playing ? this.start() : this.stop()));
    scope.add(() => this.stop());
  }

  toggle(): void {
    const { playing, tick } = this.store.state;
    const atEnd = tick >= this.context.lastTick;
    this.store.set(playing ? { playing: false, tick: Math.round(tick) } : { playing: true, tick: atEnd ? 0 : tick });
  }

  /** Stops there. */
  goTo(tick: number): void {
    this.store.set({ tick: this.clamped(Math.round(tick)), playing: false });
  }

  step(ticks: number): void {
    this.goTo(Math.round(this.store.state.tick) + ticks);
  }

  stepSeconds(seconds: number): void {
    this.step(Math.round(seconds * this.context.ticksPerSecond));
  }

  stepEvent(direction: 1 | -1): void {
    const { tick } = this.store.state;
    const found =
      direction > 0
        ? this.eventTicks.find((each) => each > tick)
        : this.eventTicks.findLast((each) => each < Math.ceil(tick));
    if (found !== undefined) this.goTo(found);
  }

  changeSpeed(direction: 1 | -1): void {
    const { speed } = this.store.state;
    const next = direction > 0 ? speeds.find((each) => each > speed) : speeds.findLast((each) => each < speed);
    if (next !== undefined) this.store.set({ speed: next });
  }

  private clamped(tick: number): number {
    return Math.min(Math.max(0, tick), this.context.lastTick);
  }

  private start(): void {
    this.lastTime = 0;
    this.pending = requestAnimationFrame((time) => this.advance(time));
  }

  private stop(): void {
    cancelAnimationFrame(this.pending);
  }

  private advance(time: number): void {
    const seconds = this.lastTime === 0 ? 0 : Math.min(0.5, (time - this.lastTime) / 1000);
    this.lastTime = time;
    const { tick, speed } = this.store.state;
    const next = this.clamped(tick + seconds * speed * this.context.ticksPerSecond);
    const ended = next >= this.context.lastTick;
    this.store.set(ended ? { tick: next, playing: false } : { tick: next });
    if (!ended) this.pending = requestAnimationFrame((later) => this.advance(later));
  }
}
