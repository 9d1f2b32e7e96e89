// What authors draw on the campus: points for walk steps, a box for a trigger.

import {
  BoxGeometry,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  Points,
  PointsMaterial,
  type Vector3,
} from 'three';
import type { Point } from '../format';
import { boxBetween, coordinates, type DrawnBox } from '../data/snippets';
import type { Hit } from '../scene/picker';
import { edgesOf, facesOf } from '../scene/shapes';
import type { Stage } from '../scene/stage';
import { copyText } from '../ui/clipboard';
import type { Scope } from '../ui/dom';
import type { WalkContext } from './context';

const color = 0x8b5cf6;

export class AuthorMarks {
  points: Point[] = [];
  box: DrawnBox | null = null;
  height = 2.4;
  yaw = 0;
  /** Building of what the box was begun on. */
  building = '';
  /** Called after each change. */
  changed: () => void = () => {};
  private readonly root = new Group();
  private from: Point | null = null;
  private to: Point | null = null;
  private drawing = false;

  constructor(
    private readonly stage: Stage,
    private readonly context: WalkContext,
    scope: Scope,
  ) {
    stage.scene.add(this.root);
    scope.add(() => this.root.removeFromParent());
  }

  addPoint(hit: Hit | null): void {
    if (!hit) return;
    const point = rounded(hit.point);
    this.points = [...this.points, point];
    void copyText(coordinates(point), `Copied ${coordinates(point)}`);
    this.context.store.set({ tab: 'author' });
    this.redraw();
  }

  beginBox(hit: Hit | null): void {
    if (!hit) return;
    this.drawing = true;
    this.from = rounded(hit.point);
    this.to = null;
    this.box = null;
    const object = this.context.campus?.objects[hit.piece.objects[0] ?? -1];
    this.building = this.context.campus?.buildings[object?.building ?? -1]?.id ?? '';
  }

  stretchBox(hit: Hit | null): void {
    if (!hit || !this.drawing) return;
    this.to = rounded(hit.point);
    const object = this.context.campus?.objects[hit.piece.objects[0] ?? -1];
    this.building = this.context.campus?.buildings[object?.building ?? -1]?.id ?? this.building;
    this.rebuildBox();
  }

  endBox(): void {
    if (this.drawing && this.box) this.context.store.set({ tab: 'author' });
    this.drawing = false;
  }

  setBox(height: number, yaw: number): void {
    this.height = Math.max(0.1, height || 0.1);
    this.yaw = yaw || 0;
    this.rebuildBox();
  }

  removeLast(): void {
    this.points = this.points.slice(0, -1);
    this.redraw();
  }

  clear(): void {
    this.points = [];
    this.box = this.from = this.to = null;
    this.redraw();
  }

  private rebuildBox(): void {
    if (this.from && this.to) this.box = boxBetween(this.from, this.to, this.height, this.yaw);
    this.redraw();
  }

  private redraw(): void {
    this.root.clear();
    if (this.points.length > 0) {
      // As large from afar as from near, and never hidden.
      const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(this.points.flat(), 3));
      const look = { color, fog: false, depthTest: false, transparent: true, toneMapped: false };
      const marks = [
        new Line(geometry, new LineBasicMaterial(look)),
        new Points(geometry, new PointsMaterial({ ...look, color: 0xffffff, size: 13, sizeAttenuation: false })),
        new Points(geometry, new PointsMaterial({ ...look, size: 9, sizeAttenuation: false })),
      ];
      marks.forEach((mark, i) => (mark.renderOrder = 10 + i));
      this.root.add(...marks);
    }
    if (this.box) this.root.add(drawn(this.box));
    this.stage.invalidate();
    this.changed();
  }
}

function rounded(point: Vector3): Point {
  return point.toArray().map((value) => Math.round(value * 1000) / 1000) as Point;
}

function drawn(box: DrawnBox): Group {
  const root = new Group();
  const geometry = new BoxGeometry(Math.max(box.width, 0.02), box.height, Math.max(box.depth, 0.02));
  root.add(facesOf(geometry, color, 0.2), edgesOf(geometry, color, 1));
  root.position.set(box.base[0], box.base[1] + box.height / 2, box.base[2]);
  root.rotation.y = (box.yaw * Math.PI) / 180;
  return root;
}
