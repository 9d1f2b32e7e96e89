// The page's state, and the only place that changes it: views read it, and are called when what they read changes.

export type CameraMode = 'first' | 'third' | 'top' | 'orbit' | 'free';
export type Tab = 'failure' | 'log' | 'steps' | 'pictures' | 'file' | 'author';
export type Tool = 'none' | 'point' | 'box';
export type Theme = 'auto' | 'light' | 'dark';

export interface Layers {
  trail: boolean;
  triggers: boolean;
  contacts: boolean;
  gaze: boolean;
  capsule: boolean;
  findings: boolean;
  plan: boolean;
}

export interface State {
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

export const initialState: State = {
  page: 'list',
  walk: -1,
  against: false,
  query: '',
  tick: 0,
  playing: false,
  speed: 1,
  camera: 'third',
  tab: 'log',
  layers: {
    trail: true,
    triggers: true,
    contacts: true,
    gaze: true,
    capsule: false,
    findings: true,
    plan: true,
  },
  cut: null,
  tool: 'none',
  theme: 'auto',
  help: false,
};

type Listener = () => void;

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

  /** Calls `act` at once and whenever what `select` yields has changed. Returns what ends that. */
  on<Value>(select: (state: Readonly<State>) => Value, act: (value: Value) => void): () => void {
    let seen = select(this.current);
    const listener = (): void => {
      const value = select(this.current);
      if (Object.is(value, seen)) return;
      seen = value;
      act(value);
    };
    this.listeners.add(listener);
    act(seen);
    return () => this.listeners.delete(listener);
  }
}
