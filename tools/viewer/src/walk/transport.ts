// Play, pause, steps by tick and by event, speed, and the time in numbers.

import { button, setPressed } from '../ui/controls';
import { element, replace, Scope, setText } from '../ui/dom';
import { icon } from '../ui/icons';
import type { WalkContext } from './context';
import { speeds, type Player } from './player';

export function transport(context: WalkContext, player: Player, scope: Scope): HTMLElement {
  const { store } = context;
  const play = button({ icon: 'play', label: 'Play', key: 'Space', class: 'primary', act: () => player.toggle() });
  const time = element('output', { class: 'time', attributes: { 'aria-live': 'off' } });
  const tick = element('span', { class: 'tick' });
  const speed = element('select', {
    class: 'select',
    attributes: { 'aria-label': 'Speed' },
    on: { change: () => store.set({ speed: Number(speed.value) }) },
  });
  for (const each of speeds) speed.append(element('option', { text: `${each}×`, attributes: { value: each } }));

  store.on(scope, 'playing', (playing) => {
    replace(play, icon(playing ? 'pause' : 'play'));
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    setPressed(play, playing);
  });
  store.on(scope, 'speed', (value) => (speed.value = String(value)));
  store.on(scope, 'tick', (value) => {
    const whole = Math.round(value);
    setText(time, `${(whole / context.ticksPerSecond).toFixed(2)} s`);
    setText(tick, `tick ${whole} of ${context.lastTick}`);
  });

  return element(
    'div',
    { class: 'transport', attributes: { role: 'toolbar', 'aria-label': 'Playback' } },
    button({ icon: 'eventBack', label: 'Previous event', key: '[', act: () => player.stepEvent(-1) }),
    button({ icon: 'back', label: 'Back a tick', key: ',', act: () => player.step(-1) }),
    play,
    button({ icon: 'next', label: 'On a tick', key: '.', act: () => player.step(1) }),
    button({ icon: 'eventNext', label: 'Next event', key: ']', act: () => player.stepEvent(1) }),
    speed,
    time,
    tick,
  );
}
