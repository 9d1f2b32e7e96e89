// Icons drawn on a grid of 16 by 16, as paths.

const paths = {
  passed: 'M3 8.5 6.5 12 13 4.5',
  failed: 'M4 4l8 8M12 4l-8 8',
  skipped: 'M4 8h8',
  xfail: 'M3 9.5 6 12.5 9 8.5M9.5 3.5l4 4M13.5 3.5l-4 4',
  bad_input: 'M8 3.5v5.5M8 12v.5',
  broken: 'M8 3.5v5.5M8 12v.5',
  interrupted: 'M6 4v8M10 4v8',
  play: 'M5 3.2v9.6L12.6 8z',
  pause: 'M5 3.5v9M11 3.5v9',
  back: 'M10 3.5 5.5 8 10 12.5',
  next: 'M6 3.5 10.5 8 6 12.5',
  eventBack: 'M11.5 3.5 7 8l4.5 4.5M4.5 3.5v9',
  eventNext: 'M4.5 3.5 9 8l-4.5 4.5M11.5 3.5v9',
  sun: 'M8 5.2a2.8 2.8 0 1 1 0 5.6a2.8 2.8 0 0 1 0-5.6M8 1.5v1.5M8 13v1.5M1.5 8H3M13 8h1.5M3.4 3.4l1.1 1.1M11.5 11.5l1.1 1.1M12.6 3.4l-1.1 1.1M4.5 11.5l-1.1 1.1',
  moon: 'M13.2 9.8A5.7 5.7 0 0 1 6.2 2.8a5.7 5.7 0 1 0 7 7z',
  auto: 'M8 2.5a5.5 5.5 0 1 0 0 11z M8 2.5a5.5 5.5 0 0 1 0 11',
  help: 'M5.8 6.2a2.2 2.2 0 1 1 3.3 1.9c-.8.5-1.1.9-1.1 1.7M8 12.2v.3',
  copy: 'M6 5.5h6.5V13H6zM3.5 10.5V3H10',
  search: 'M7 3a4 4 0 1 1 0 8a4 4 0 0 1 0-8M10 10l3.5 3.5',
  layers: 'M8 2.5 14 6 8 9.5 2 6zM2.5 9.2 8 12.5l5.5-3.3',
  cut: 'M2.5 13h11M2.5 9.2h11M2.5 5.2h1.6M7.2 5.2h1.6M11.9 5.2h1.6M8 2v0',
  expand: 'M3 6V3h3M10 3h3v3M13 10v3h-3M6 13H3v-3',
  box: 'M2.5 5.2 8 2.5l5.5 2.7v5.6L8 13.5l-5.5-2.7zM2.5 5.2 8 8l5.5-2.8M8 8v5.5',
  close: 'M4 4l8 8M12 4l-8 8',
  compare: 'M5 13V8c0-2 3-2 3-5M11 13V8c0-2-3-2-3-5',
  warning: 'M8 2.5 14.5 13.5h-13zM8 6.5v3.5M8 11.7v.3',
} as const;

export type IconName = keyof typeof paths;

export function icon(of: IconName): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', paths[of]);
  if (of === 'play') path.setAttribute('class', 'filled');
  svg.append(path);
  return svg;
}

export function statusIcon(status: string): HTMLElement {
  const holder = document.createElement('span');
  holder.className = `status ${status}`;
  holder.append(icon((status in paths ? status : 'failed') as IconName));
  return holder;
}
