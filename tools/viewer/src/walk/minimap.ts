// The campus from above with the visitor: a small round map in the scene, or all there is to see without 3D.

import { element, Scope } from '../ui/dom';
import { planPoints } from '../data/path';
import { colorsOf, fitted, PlanCanvas, type PlanView } from '../plan/plan';
import type { WalkData } from '../data/report';
import type { WalkContext } from './context';

/** `follows`: shows the surroundings of the visitor instead of all of the campus. */
export function walkPlan(context: WalkContext, scope: Scope, follows: boolean): HTMLElement {
  const canvas = element('canvas', { attributes: { role: 'img', 'aria-label': 'Plan with the visitor' } });
  const root = element('div', { class: follows ? 'minimap' : 'walk-plan' }, canvas);
  if (follows)
    root.append(element('span', { class: 'minimap-north', text: 'N', attributes: { 'aria-hidden': 'true' } }));
  const plan = new PlanCanvas(canvas);
  let image: HTMLCanvasElement | null = null;
  const draw = (): void => {
    if (plan.width === 0) return;
    const tick = context.store.state.tick;
    const pose = context.data.path?.at(tick) ?? null;
    plan.view = viewOf(context, plan, follows && pose !== null, pose);
    plan.drawCampus(context.campus, image, colorsOf(root));
    const style = getComputedStyle(root);
    if (context.other) drawTrack(plan, context.other.data, style.getPropertyValue('--other'), follows ? 1.5 : 2.5);
    drawTrack(plan, context.data, style.getPropertyValue('--trail'), follows ? 1.5 : 2.5);
    for (const { obstacle, failure } of context.failures) {
      const at = obstacle.at ?? failure.scene?.position;
      if (at) plan.drawMark({ x: at[0], z: at[2], color: style.getPropertyValue('--failed') }, 4);
    }
    if (pose) plan.drawMark({ ...pose, color: '#ff4a2e' }, follows ? 6 : 8);
  };
  scope.resized(root, () => {
    plan.resize(root.clientWidth, root.clientHeight);
    draw();
  });
  context.store.on(scope, (state) => Math.floor(state.tick), draw);
  scope.listen(window, 'themechange' as keyof WindowEventMap, draw);
  void context.campuses.plan(context.data.row.campus).then((made) => {
    image = made;
    if (!scope.isOver) draw();
  });
  return root;
}

function viewOf(
  context: WalkContext,
  plan: PlanCanvas,
  follows: boolean,
  pose: { x: number; z: number } | null,
): PlanView {
  if (follows && pose) return { centerX: pose.x, centerZ: pose.z, pixelsPerMetre: plan.width / 90 };
  const { campus } = context;
  return campus
    ? fitted(campus.min, campus.max, plan.width, plan.height)
    : { centerX: 0, centerZ: 0, pixelsPerMetre: 4 };
}

function drawTrack(plan: PlanCanvas, data: WalkData, color: string, width: number): void {
  const { path } = data;
  if (!path) {
    plan.drawPath(planPoints(data.row.plan), color, width);
    return;
  }
  for (const [first, last] of path.pieces()) {
    const points: [number, number][] = [];
    for (let i = first; i <= last; ++i) points.push([path.x[i]!, path.z[i]!]);
    plan.drawPath(points, color, width);
  }
}
