// A plan of a campus, seen from above with -Z up: its objects or its image, and paths on it.

import type { CampusEntry } from '../format';

/** Metres: x, z. */
type PlanPoints = readonly (readonly [number, number])[];

interface PlanMark {
  x: number;
  z: number;
  color: string;
  /** Radians; none: a dot. */
  yaw?: number;
}

/** From metres to pixels. */
export interface PlanView {
  centerX: number;
  centerZ: number;
  pixelsPerMetre: number;
}

interface PlanColors {
  ground: string;
  building: string;
  edge: string;
}

export function colorsOf(element: Element): PlanColors {
  const style = getComputedStyle(element);
  const color = (name: string): string => style.getPropertyValue(name).trim();
  return { ground: color('--plan-ground'), building: color('--plan-building'), edge: color('--plan-edge') };
}

/** The view that shows a region in a canvas of so many pixels. */
export function fitted(
  min: readonly number[],
  max: readonly number[],
  width: number,
  height: number,
  margin = 8,
): PlanView {
  const across = Math.max(max[0]! - min[0]!, 4);
  const deep = Math.max(max[2]! - min[2]!, 4);
  return {
    centerX: (min[0]! + max[0]!) / 2,
    centerZ: (min[2]! + max[2]!) / 2,
    pixelsPerMetre: Math.min((width - 2 * margin) / across, (height - 2 * margin) / deep),
  };
}

/** The bounds of points, with a margin, in the form that `fitted` takes. */
export function boundsOf(points: PlanPoints, margin: number): [number[], number[]] {
  const xs = points.map((point) => point[0]);
  const zs = points.map((point) => point[1]);
  const [minX, maxX] = [Math.min(...xs), Math.max(...xs)];
  const [minZ, maxZ] = [Math.min(...zs), Math.max(...zs)];
  return [
    [minX - margin, 0, minZ - margin],
    [maxX + margin, 0, maxZ + margin],
  ];
}

export class PlanCanvas {
  readonly context: CanvasRenderingContext2D;
  view: PlanView = { centerX: 0, centerZ: 0, pixelsPerMetre: 1 };
  width = 0;
  height = 0;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext('2d')!;
  }

  resize(width: number, height: number): void {
    const ratio = Math.min(devicePixelRatio, 2);
    this.width = width;
    this.height = height;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  toPixels(x: number, z: number): [number, number] {
    const { centerX, centerZ, pixelsPerMetre } = this.view;
    return [this.width / 2 + (x - centerX) * pixelsPerMetre, this.height / 2 + (z - centerZ) * pixelsPerMetre];
  }

  drawCampus(campus: CampusEntry | null, image: CanvasImageSource | null, colors: PlanColors): void {
    const { context } = this;
    context.globalAlpha = 1;
    context.fillStyle = colors.ground;
    context.fillRect(0, 0, this.width, this.height);
    if (!campus) return;
    if (image) {
      const [left, top] = this.toPixels(campus.min[0], campus.min[2]);
      const [right, bottom] = this.toPixels(campus.max[0], campus.max[2]);
      context.drawImage(image, left, top, right - left, bottom - top);
      return;
    }
    for (const { min, max, modes, building } of campus.objects) {
      const isGround = max[0] - min[0] > 60 && max[2] - min[2] > 60;
      if (!modes.includes('solid') || isGround) continue;
      const [left, top] = this.toPixels(min[0], min[2]);
      const [right, bottom] = this.toPixels(max[0], max[2]);
      if (right < 0 || bottom < 0 || left > this.width || top > this.height) continue;
      context.fillStyle = building >= 0 ? colors.building : colors.edge;
      context.globalAlpha = building >= 0 ? 1 : 0.45;
      context.fillRect(left, top, Math.max(right - left, 1), Math.max(bottom - top, 1));
    }
    context.globalAlpha = 1;
  }

  drawPath(points: PlanPoints, color: string, width: number): void {
    Object.assign(this.context, { lineJoin: 'round', lineCap: 'round' });
    this.stroke([points], color, width, 1);
  }

  /** Many at once, in one colour. */
  drawPaths(paths: readonly PlanPoints[], color: string, width: number, opacity: number): void {
    Object.assign(this.context, { lineJoin: 'bevel', lineCap: 'butt' });
    this.stroke(paths, color, width, opacity);
  }

  private stroke(paths: readonly PlanPoints[], color: string, width: number, opacity: number): void {
    const { context } = this;
    context.globalAlpha = opacity;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.beginPath();
    for (const points of paths) {
      points.forEach(([x, z], i) => {
        const [px, py] = this.toPixels(x, z);
        if (i === 0) context.moveTo(px, py);
        else context.lineTo(px, py);
      });
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  drawMark(mark: PlanMark, size: number): void {
    const { context } = this;
    const [x, y] = this.toPixels(mark.x, mark.z);
    context.save();
    context.translate(x, y);
    context.beginPath();
    if (mark.yaw === undefined) {
      context.arc(0, 0, size, 0, Math.PI * 2);
    } else {
      context.rotate(-mark.yaw);
      context.moveTo(0, -size * 1.5);
      context.lineTo(size, size);
      context.lineTo(0, size * 0.45);
      context.lineTo(-size, size);
      context.closePath();
    }
    context.fillStyle = mark.color;
    context.strokeStyle = '#ffffff';
    context.lineWidth = 1.5;
    context.fill();
    context.stroke();
    context.restore();
  }
}
