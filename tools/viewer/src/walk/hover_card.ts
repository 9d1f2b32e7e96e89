// Names what the pointer is on: the object, its building, what it did to the visitor.

import type { Vector3 } from 'three';
import { element, name, replace } from '../ui/dom';
import { deedsOf } from '../data/spans';
import type { Hit } from '../scene/picker';
import { contains } from '../scene/shapes';
import type { WalkContext } from './context';

export class HoverCard {
  readonly root = element('div', { class: 'hover-card' });
  /** Index of the object, or -1. */
  object = -1;

  constructor(
    private readonly context: WalkContext,
    private readonly triggersAt: (point: Vector3) => string[],
  ) {
    this.root.hidden = true;
  }

  /** True if it is on another object than before. */
  show(hit: Hit | null, x: number, y: number, width: number): boolean {
    const objects = hit ? this.objectsAt(hit) : [];
    const object = objects[0] ?? -1;
    const changed = object !== this.object;
    this.object = object;
    this.root.hidden = hit === null;
    if (!hit) return changed;
    this.fill(hit, objects);
    const right = x > width - 300;
    this.root.style.transform = `translate(${x + (right ? -16 : 16)}px, ${y + 16}px) translateX(${right ? '-100%' : '0'})`;
    return changed;
  }

  hide(): void {
    this.root.hidden = true;
    this.object = -1;
  }

  /** Those that the geometry is of, or whose shapes are there: not every collider has nodes of the model. */
  private objectsAt(hit: Hit): number[] {
    const shapes = (this.context.campus?.objects ?? []).flatMap((object, index) => {
      const isShape = object.shape !== 'mesh' && (object.modes.includes('solid') || object.modes.includes('ray'));
      return isShape && contains(object, hit.point, 0.08) ? [index] : [];
    });
    return [...new Set([...hit.piece.objects, ...(hit.piece.objects.length === 0 ? shapes : [])])];
  }

  private fill(hit: Hit, indexes: readonly number[]): void {
    const { campus, data, spans, ticksPerSecond } = this.context;
    const objects = indexes.map((index) => campus?.objects[index]).filter((each) => each !== undefined);
    const building = campus?.buildings[objects[0]?.building ?? -1];
    const deeds = objects.flatMap((object) => deedsOf(object.id, data.log, spans, ticksPerSecond));
    const within = this.triggersAt(hit.point);
    replace(
      this.root,
      element(
        'div',
        { class: 'hover-id' },
        objects.length > 0 ? name(objects.map((each) => each.id).join(', ')) : name(hit.piece.node || 'scenery'),
      ),
      element(
        'div',
        { class: 'hover-sub' },
        objects.length === 0 ? 'no collider' : building ? name(building.title) : '',
        hit.piece.node !== '' && objects.length > 0 ? name(` node ${hit.piece.node}`) : '',
      ),
      ...deeds.map((deed) => element('div', { class: 'hover-deed', text: deed })),
      ...within.map((id) => element('div', { class: 'hover-deed' }, 'in trigger ', name(id))),
      element('div', { class: 'hover-point', text: `[${[...hit.point].map((value) => value.toFixed(2)).join(', ')}]` }),
    );
  }
}
