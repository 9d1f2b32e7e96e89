// Names what the pointer is on: the object, its building, what it did to the visitor.

import type { Vector3 } from 'three';
import { element, name, replace } from '../ui/dom';
import { deedsOf } from '../data/spans';
import type { Hit } from '../scene/picker';
import type { WalkContext } from './context';

export class HoverCard {
  readonly root = element('div', { class: 'hover-card' });
  /** Index of the object, or -1. */
  object = -1;

  constructor(private readonly context: WalkContext, private readonly triggersAt: (point: Vector3) => string[]) {
    this.root.hidden = true;
  }

  /** True if it is on another object than before. */
  show(hit: Hit | null, x: number, y: number, width: number): boolean {
    const object = hit ? (hit.piece.objects[0] ?? -1) : -1;
    const changed = object !== this.object;
    this.object = object;
    this.root.hidden = hit === null;
    if (!hit) return changed;
    this.fill(hit);
    const right = x > width - 300;
    this.root.style.transform = `translate(${x + (right ? -16 : 16)}px, ${y + 16}px) translateX(${right ? '-100%' : '0'})`;
    return changed;
  }

  hide(): void {
    this.root.hidden = true;
    this.object = -1;
  }

  private fill(hit: Hit): void {
    const { campus, data, spans, ticksPerSecond } = this.context;
    const objects = hit.piece.objects.map((index) => campus?.objects[index]).filter((each) => each !== undefined);
    const building = campus?.buildings[objects[0]?.building ?? -1];
    const deeds = objects.flatMap((object) => deedsOf(object.id, data.log, spans, ticksPerSecond));
    const within = this.triggersAt(hit.point);
    replace(
      this.root,
      element('div', { class: 'hover-id' }, objects.length > 0 ? name(objects.map((each) => each.id).join(', ')) : name(hit.piece.node || 'scenery')),
      element('div', { class: 'hover-sub' }, objects.length === 0 ? 'no collider' : building ? name(building.title) : '',
        hit.piece.node !== '' && objects.length > 0 ? name(` node ${hit.piece.node}`) : ''),
      ...deeds.map((deed) => element('div', { class: 'hover-deed', text: deed })),
      ...within.map((id) => element('div', { class: 'hover-deed' }, 'in trigger ', name(id))),
      element('div', { class: 'hover-point', text: `[${hit.point.toArray().map((value) => value.toFixed(2)).join(', ')}]` }),
    );
  }
}
