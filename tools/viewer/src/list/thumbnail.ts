// What a row shows of its walk: its picture, or a plan of its path.

import { element } from '../ui/dom';
import { later } from '../ui/later';
import { planPoints } from '../data/path';
import type { Report } from '../data/report';
import type { WalkRow } from '../format';
import { isBad } from '../data/groups';
import { boundsOf, colorsOf, fitted, PlanCanvas } from '../plan/plan';

const width = 88;
const height = 50;

export function thumbnail(report: Report, row: WalkRow): HTMLElement {
  const address = report.picture(row.thumbnail);
  if (address)
    return element('img', {
      class: 'thumbnail',
      attributes: { src: address, alt: '', loading: 'lazy', decoding: 'async' },
    });
  const points = planPoints(row.plan);
  if (points.length === 0) return element('span', { class: 'thumbnail blank' });
  const canvas = element('canvas', { class: 'thumbnail', attributes: { 'aria-hidden': 'true' } });
  later(() => canvas.isConnected && drawPlan(canvas, report, row, points));
  return canvas;
}

function drawPlan(canvas: HTMLCanvasElement, report: Report, row: WalkRow, points: readonly [number, number][]): void {
  const theme = document.documentElement;
  const plan = new PlanCanvas(canvas);
  const [low, high] = boundsOf(points, 0);
  const margin = Math.min(6, Math.max(1.5, 0.2 * Math.max(high[0]! - low[0]!, high[2]! - low[2]!)));
  const [min, max] = boundsOf(points, margin);
  plan.resize(width, height);
  plan.view = fitted(min, max, width, height, 3);
  plan.drawCampus(report.campusOf(row), null, colorsOf(theme));
  const style = getComputedStyle(theme);
  const color = style.getPropertyValue(isBad(row.outcome) ? '--failed' : '--trail').trim();
  plan.drawPath(points, color, 2);
  const [x, z] = points.at(-1)!;
  plan.drawMark({ x, z, color }, 2.5);
}
