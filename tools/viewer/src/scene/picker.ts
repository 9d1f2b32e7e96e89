// Rays against the campus: what is under the pointer, what hides something from a camera.

import { Box3, Matrix3, Matrix4, Ray, Vector3, type Mesh } from 'three';
import { kept } from '../data/kept';
import type { CampusModel, Piece } from './campus_model';
import { TriangleTree } from './triangle_tree';

export interface Hit {
  point: Vector3;
  distance: number;
  piece: Piece;
}

export class Picker {
  private readonly trees = new WeakMap<Mesh['geometry'], TriangleTree>();
  private readonly inverses = new Map<Mesh, Matrix4>();

  constructor(private readonly model: CampusModel) {}

  /** The nearest hit before `limit` metres, below what is cut away. `direction` has unit length. */
  cast(origin: Vector3, direction: Vector3, limit = Infinity, accepts?: (piece: Piece) => boolean): Hit | null {
    let best: Hit | null = null;
    const start = this.belowCut(origin, direction);
    if (start === null) return null;
    const from = origin.clone().addScaledVector(direction, start);
    let nearest = limit - start;
    const ray = new Ray(from, direction);
    const entries: { piece: Piece; at: number }[] = [];
    for (const piece of this.model.pieces) {
      const at = entryOf(ray, piece.bounds);
      if (at < nearest && piece.mesh.visible && (accepts?.(piece) ?? true)) entries.push({ piece, at });
    }
    entries.sort((a, b) => a.at - b.at);
    for (const { piece, at } of entries) {
      if (at >= nearest) break;
      const inverse = this.inverseOf(piece.mesh);
      const local = from.clone().applyMatrix4(inverse);
      // Not normalized: distances stay those of the world.
      const along = direction.clone().applyMatrix3(new Matrix3().setFromMatrix4(inverse));
      const hit = this.treeOf(piece.mesh).cast(local.toArray(), along.toArray(), nearest);
      if (hit && !this.isCutAway(from.y + direction.y * hit.distance)) {
        nearest = hit.distance;
        best = { point: ray.at(hit.distance, new Vector3()), distance: hit.distance + start, piece };
      }
    }
    return best;
  }

  /** Whether nothing is between two points, apart from what is within a hand's breadth of them. */
  sees(from: Vector3, to: Vector3): boolean {
    const direction = to.clone().sub(from);
    const distance = direction.length();
    return this.cast(from, direction.divideScalar(distance), distance - 0.12, isOpaque) === null;
  }

  /** How far one gets from a point before something is in the way. */
  clearance(from: Vector3, direction: Vector3, limit: number): number {
    return this.cast(from, direction, limit, isOpaque)?.distance ?? limit;
  }

  /** Where the ray gets below what is cut away; null if it never does. */
  private belowCut(origin: Vector3, direction: Vector3): number | null {
    const height = this.model.cutHeight;
    if (height === null || origin.y <= height) return 0;
    return direction.y < 0 ? (height - origin.y) / direction.y + 1e-6 : null;
  }

  private isCutAway(y: number): boolean {
    const height = this.model.cutHeight;
    return height !== null && y > height;
  }

  private treeOf(mesh: Mesh): TriangleTree {
    return kept(this.trees, mesh.geometry, () => new TriangleTree(mesh.geometry));
  }

  private inverseOf(mesh: Mesh): Matrix4 {
    return kept(this.inverses, mesh, () => mesh.matrixWorld.clone().invert());
  }
}

function isOpaque(piece: Piece): boolean {
  return !piece.material.transparent;
}

const point = new Vector3();

/** Distance at which the ray enters the box, 0 inside it, infinite past it. */
function entryOf(ray: Ray, box: Box3): number {
  if (box.containsPoint(ray.origin)) return 0;
  return ray.intersectBox(box, point) ? point.distanceTo(ray.origin) : Infinity;
}
