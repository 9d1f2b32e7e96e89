// Work that may wait: done bit by bit between frames, so that nothing that moves has to wait for it.

const budget = 6; // milliseconds of each frame

const queue: (() => void)[] = [];
let pending = 0;

export function later(act: () => void): void {
  queue.push(act);
  pending ||= requestAnimationFrame(run);
}

function run(): void {
  const end = performance.now() + budget;
  while (queue.length > 0 && performance.now() < end) queue.shift()!();
  pending = queue.length > 0 ? requestAnimationFrame(run) : 0;
}
