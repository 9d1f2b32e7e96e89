// Light, dark, or as the system is. Canvases that took colours from the page are told of a change.

import type { Store, Theme } from '../store';
import { button } from './controls';
import { replace } from './dom';
import { icon } from './icons';

const order: Theme[] = ['auto', 'light', 'dark'];
const icons = { auto: 'auto', light: 'sun', dark: 'moon' } as const;
const labels: Record<Theme, string> = { auto: "Colours: the system's", light: 'Colours: light', dark: 'Colours: dark' };
const key = 'campuswalk-theme';

export function useTheme(store: Store): void {
  const saved = stored();
  if (saved) store.set({ theme: saved });
  const system = matchMedia('(prefers-color-scheme: dark)');
  const apply = (): void => {
    const { theme } = store.state;
    const dark = theme === 'dark' || (theme === 'auto' && system.matches);
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    window.dispatchEvent(new Event('themechange'));
  };
  store.on(null, 'theme', (theme) => {
    apply();
    remember(theme);
  });
  system.addEventListener('change', apply);
}

export function themeButton(store: Store): HTMLButtonElement {
  const made = button({
    icon: 'auto',
    label: labels.auto,
    class: 'plain',
    act: () => store.set({ theme: order[(order.indexOf(store.state.theme) + 1) % order.length]! }),
  });
  store.on(null, 'theme', (theme) => {
    replace(made, icon(icons[theme]));
    made.title = labels[theme];
    made.setAttribute('aria-label', labels[theme]);
  });
  return made;
}

/** Pages from disk may be refused storage. */
function stored(): Theme | null {
  try {
    const value = localStorage.getItem(key);
    return order.find((theme) => theme === value) ?? null;
  } catch {
    return null;
  }
}

function remember(theme: Theme): void {
  try {
    if (theme === 'auto') localStorage.removeItem(key);
    else localStorage.setItem(key, theme);
  } catch {
    // Then it holds for this page only.
  }
}
