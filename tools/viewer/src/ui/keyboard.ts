// The keys of the page. What is typed into a field isn't a command.

import type { Layers, Store } from '../store';
import { cameras, cutAtVisitor } from '../walk/view_bar';
import type { WalkPage } from '../walk/walk_page';

interface Commands {
  page: () => WalkPage | null;
  list: () => void;
  go: (direction: 1 | -1) => void;
  focusFilter: () => void;
}

export function useKeyboard(store: Store, commands: Commands): void {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || isTyping(event)) return;
    if (handle(event.key, event.target, store, commands)) event.preventDefault();
  });
}

function isTyping(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (target instanceof HTMLInputElement && !/^(checkbox|range|button)$/.test(target.type)) {
    if (key === 'Escape') target.blur();
    return true;
  }
  return target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
}

function handle(key: string, target: EventTarget | null, store: Store, commands: Commands): boolean {
  if (key === '?') {
    store.set({ help: !store.state.help });
    return true;
  }
  if (store.state.help) {
    if (key === 'Escape') store.set({ help: false });
    return key === 'Escape';
  }
  const page = commands.page();
  if (store.state.page === 'list' || !page) return listKey(key, commands);
  // A button's own keys stay its own.
  if (target instanceof HTMLButtonElement && (key === ' ' || key === 'Enter')) return false;
  return walkKey(key, store, commands, page);
}

function listKey(key: string, commands: Commands): boolean {
  if (key !== '/') return false;
  commands.focusFilter();
  return true;
}

function walkKey(key: string, store: Store, commands: Commands, page: WalkPage): boolean {
  const { player, viewport } = page;
  const toggle = (layer: keyof Layers): void => store.setLayer(layer, !store.state.layers[layer]);
  const camera = cameras.find((each) => each.key === key);
  if (camera) {
    store.set({ camera: camera.value });
    return true;
  }
  const actions: Record<string, () => unknown> = {
    ' ': () => player.toggle(),
    ',': () => player.step(-1),
    '.': () => player.step(1),
    '[': () => player.stepEvent(-1),
    ']': () => player.stepEvent(1),
    ArrowLeft: () => player.stepSeconds(-1),
    ArrowRight: () => player.stepSeconds(1),
    Home: () => player.goTo(0),
    End: () => player.goTo(page.context.lastTick),
    '-': () => player.changeSpeed(-1),
    '+': () => player.changeSpeed(1),
    '=': () => player.changeSpeed(1),
    o: () => viewport?.overlook(),
    x: () => store.set({ cut: store.state.cut === null ? cutAtVisitor(page.context) : null }),
    t: () => toggle('triggers'),
    m: () => toggle('plan'),
    f: () => (store.set({ tab: 'failure' }), page.showFailure(0)),
    l: () => store.set({ tab: 'log' }),
    p: () => store.set({ tool: store.state.tool === 'point' ? 'none' : 'point', tab: 'author' }),
    b: () => store.set({ tool: store.state.tool === 'box' ? 'none' : 'box', tab: 'author' }),
    c: () => page.canCompare && store.set({ against: !store.state.against }),
    j: () => commands.go(1),
    k: () => commands.go(-1),
    Escape: () => commands.list(),
  };
  const action = actions[key.length === 1 ? key.toLowerCase() : key];
  action?.();
  return action !== undefined;
}
