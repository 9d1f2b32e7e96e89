// YAML that authors paste into walks and campus files.

import type { Point } from '../format';

/** Millimetres are more than anyone places by hand. */
export function coordinates(point: Point): string {
  return `[${point.map(decimal).join(', ')}]`;
}

export function walkToStep(point: Point): string {
  return `- walk_to: ${coordinates(point)}`;
}

export function followStep(points: readonly Point[]): string {
  return `- follow:\n${points.map((point) => `    - ${coordinates(point)}`).join('\n')}`;
}

/** A box whose bottom centre is `base`. */
export interface DrawnBox {
  base: Point;
  width: number;
  height: number;
  depth: number;
  /** Degrees about +Y, as the YAML's yaw_deg. */
  yaw: number;
}

export function triggerCollider(box: DrawnBox, id: string, building: string): string {
  const center: Point = [box.base[0], box.base[1] + box.height / 2, box.base[2]];
  return [
    `- id: ${id}`,
    ...(building === '' ? [] : [`  building: ${building}`]),
    '  mode: trigger',
    '  shape: box',
    `  center: ${coordinates(center)}`,
    `  size: ${coordinates([box.width, box.height, box.depth])}`,
    ...(box.yaw === 0 ? [] : [`  yaw_deg: ${decimal(box.yaw)}`]),
  ].join('\n');
}

/** The box over a rectangle between two points of the ground, turned by `yaw` degrees. */
export function boxBetween(from: Point, to: Point, height: number, yaw: number): DrawnBox {
  const angle = (yaw * Math.PI) / 180;
  const [dx, dz] = [to[0] - from[0], to[2] - from[2]];
  return {
    base: [(from[0] + to[0]) / 2, Math.min(from[1], to[1]), (from[2] + to[2]) / 2],
    width: Math.abs(dx * Math.cos(angle) - dz * Math.sin(angle)),
    height: height + Math.abs(from[1] - to[1]),
    depth: Math.abs(dx * Math.sin(angle) + dz * Math.cos(angle)),
    yaw,
  };
}

function decimal(value: number): string {
  const rounded = Math.round(value * 1000) / 1000;
  return String(rounded === 0 ? 0 : rounded);
}

/** The command that plays a walk again: {names} are replaced, [parts] without a value left out. */
export function replayCommand(template: string, values: Record<string, string>): string {
  const fill = (part: string): string => part.replace(/\{(\w+)\}/g, (_, name: string) => shellWord(values[name] ?? ''));
  const isEmpty = (part: string): boolean =>
    [...part.matchAll(/\{(\w+)\}/g)].some(([, name]) => (values[name ?? ''] ?? '') === '');
  return template
    .split(/\[([^\]]*)\]/)
    .map((part, i) => (i % 2 === 1 && isEmpty(part) ? '' : fill(part)))
    .join('')
    .trim();
}

/** In single quotes where a shell would read it otherwise. */
function shellWord(text: string): string {
  return /^[\w./:=@%+,-]+$/.test(text) || text === '' ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}
