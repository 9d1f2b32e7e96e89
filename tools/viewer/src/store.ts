// The page's state, and the only place that changes it: views read it, and are called when what they read changes.

import type { Scope } from './ui/dom';

export type CameraMode = 'first' | 'third' | 'top' | 'orbit' | 'free';
export type Tab = 'failure' | 'log' | 'steps' | 'pictures' | 'file' | 'author';
export type Tool = 'none' | 'point' | 'box';
export type Theme = 'auto' | 'light' | 'dark';

const layers = { trail: true, triggers: true, contacts: true, gaze: true, capsule: false, findings: true, plan: true };

export type Layers = typeof layers;

interface State {
  page: 'list' | 'walk';
  /** Index of a row of the run, or -1. */
  walk: number;
  /** Whether the same walk of the other run is shown beside it. */
  against: boolean;
  query: string;
  /** May lie between two ticks while it plays. */
  tick: number;
  playing: boolean;
  speed: number;
  camera: CameraMode;
  tab: Tab;
  layers: Layers;
  /** What is above this height isn't drawn. */
  cut: number | null;
  tool: Tool;
  theme: Theme;
  help: boolean;
}

const initialState: State = {
  page: 'list',
  walk: -1,
  against: false,
  query: '',
  tick: 0,
  playing: false,
  speed: 1,
  camera: 'third',
  tab: 'log',
  layers,
  cut: null,
  tool: 'none',
  theme: 'auto',
  help: false,
};

type Listener = () => void;
type Selector<Value> = (state: Readonly<State>) => Value;

export class Store {
  private current: State = initialState;
  private readonly listeners = new Set<Listener>();
  private notifying = false;
  private again = false;

  get state(): Readonly<State> {
    return this.current;
  }

  set(changes: Partial<State>): void {
    this.current = { ...this.current, ...changes };
    // A listener that changes the state is not run inside itself, but all are run again.
    this.again = true;
    if (this.notifying) return;
    this.notifying = true;
    try {
      while (this.again) {
        this.again = false;
        for (const listener of [...this.listeners]) listener();
      }
    } finally {
      this.notifying = false;
    }
  }

  setLayer(layer: keyof Layers, shown: boolean): void {
    this.set({ layers: { ...this.current.layers, [layer]: shown } });
  }

  /**
   * Calls `act` at once, and whenever a member of the state, or what a function selects from it, has changed. The calls
   * end with the scope; without one, they go on as long as the page.
   */
  on<Key extends keyof State>(scope: Scope | null, of: Key, act: (value: State[Key]) => void): void;
  on<Value>(scope: Scope | null, of: Selector<Value>, act: (value: Value) => void): void;
  on(scope: Scope | null, of: keyof State | Selector<unknown>, act: (value: never) => void): void {
    const selected = (): unknown => (typeof of === 'function' ? of(this.current) : this.current[of]);
    let seen = selected();
    const listener = (): void => {
      const value = selected();
      if (Object.is(value, seen)) return;
      seen = value;
      act(value as never);
    };
    this.listeners.add(listener);
    act(seen as never);
    scope?.add(() => this.listeners.delete(listener));
  }
}
