// Texts at points of the scene, as elements over the canvas.

import { Vector3, type PerspectiveCamera } from 'three';
import { element } from '../ui/dom';

/** On which side of its point a label is. */
type Side = 'above' | 'below' | 'left' | 'right';

const shifts: Record<Side, string> = {
  above: 'translate(-50%, -100%)',
  below: 'translate(-50%, 35%)',
  left: 'translate(calc(-100% - 10px), -50%)',
  right: 'translate(10px, -50%)',
};

export interface Label {
  root: HTMLElement;
  point: Vector3;
  side: Side;
  /** Smaller than this many metres away it is shown. */
  within: number;
}

export class Labels {
  readonly root = element('div', { class: 'labels', attributes: { 'aria-hidden': 'true' } });
  private readonly labels = new Set<Label>();
  private readonly projected = new Vector3();

  add(text: string, point: Vector3, className: string, within = Infinity, side: Side = 'above'): Label {
    const label = { root: element('div', { class: `label ${className}`, text }), point, within, side };
    this.labels.add(label);
    this.root.append(label.root);
    return label;
  }

  remove(label: Label): void {
    this.labels.delete(label);
    label.root.remove();
  }

  place(camera: PerspectiveCamera, width: number, height: number): void {
    for (const { root, point, within, side } of this.labels) {
      this.projected.copy(point).project(camera);
      const isSeen = this.projected.z < 1 && Math.abs(this.projected.x) < 1.1 && Math.abs(this.projected.y) < 1.1;
      root.hidden = !isSeen || camera.position.distanceTo(point) > within;
      if (root.hidden) continue;
      const x = ((this.projected.x + 1) / 2) * width;
      const y = ((1 - this.projected.y) / 2) * height;
      root.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) ${shifts[side]}`;
    }
  }
}
