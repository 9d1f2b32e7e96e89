// A bounding volume hierarchy over a mesh's triangles, for rays: built when a mesh is first asked for.

import type { BufferGeometry } from 'three';

const leafSize = 8;

export class TriangleTree {
  private readonly positions: Float32Array;
  /** Three vertices of each triangle. */
  private readonly vertices: Uint32Array;
  /** Triangles in the order of the leaves. */
  private readonly order: Uint32Array;
  private readonly bounds: number[] = [];
  /** Of each node: the first triangle and how many, or the index of its second child and 0. */
  private readonly first: number[] = [];
  private readonly count: number[] = [];

  constructor(geometry: BufferGeometry) {
    const position = geometry.getAttribute('position');
    this.positions = new Float32Array(position.count * 3);
    for (let i = 0; i < position.count; ++i) {
      this.positions[i * 3] = position.getX(i);
      this.positions[i * 3 + 1] = position.getY(i);
      this.positions[i * 3 + 2] = position.getZ(i);
    }
    const index = geometry.getIndex();
    const corners = index ? index.count : position.count;
    const triangles = Math.floor(corners / 3);
    this.vertices = new Uint32Array(triangles * 3);
    for (let i = 0; i < triangles * 3; ++i) this.vertices[i] = index ? index.getX(i) : i;
    this.order = new Uint32Array(triangles);
    const centers = new Float32Array(triangles * 3);
    for (let t = 0; t < triangles; ++t) {
      this.order[t] = t;
      for (let axis = 0; axis < 3; ++axis) centers[t * 3 + axis] = this.sumOf(t, axis);
    }
    this.build(0, triangles, centers);
  }

  /**
   * The nearest triangle hit before `limit`, from either side. Origin and direction are the mesh's own, and the distance
   * is in lengths of the direction.
   */
  cast(origin: readonly number[], direction: readonly number[], limit: number): { distance: number } | null {
    let nearest = limit;
    const stack = [0];
    while (stack.length > 0) {
      const node = stack.pop()!;
      if (!this.entersBox(node, origin, direction, nearest)) continue;
      const count = this.count[node]!;
      if (count === 0) {
        stack.push(this.first[node]!, node + 1);
        continue;
      }
      for (let i = this.first[node]!; i < this.first[node]! + count; ++i) {
        const distance = this.distanceTo(this.order[i]!, origin, direction);
        if (distance >= 0 && distance < nearest) nearest = distance;
      }
    }
    return nearest < limit ? { distance: nearest } : null;
  }

  private sumOf(triangle: number, axis: number): number {
    let sum = 0;
    for (let k = 0; k < 3; ++k) sum += this.positions[this.vertices[triangle * 3 + k]! * 3 + axis]!;
    return sum;
  }

  private build(from: number, to: number, centers: Float32Array): void {
    const node = this.count.length;
    this.first.push(from);
    this.count.push(to - from);
    this.bounds.push(...this.boundsOf(from, to));
    if (to - from <= leafSize) return;
    const base = node * 6;
    const extent = [0, 1, 2].map((axis) => this.bounds[base + 3 + axis]! - this.bounds[base + axis]!);
    const axis = extent.indexOf(Math.max(...extent));
    const middle = (this.bounds[base + axis]! + this.bounds[base + 3 + axis]!) * 1.5;
    let split = this.partition(from, to, (triangle) => centers[triangle * 3 + axis]! < middle);
    if (split === from || split === to) split = (from + to) >> 1;
    this.build(from, split, centers);
    this.first[node] = this.count.length;
    this.count[node] = 0;
    this.build(split, to, centers);
  }

  private partition(from: number, to: number, isLow: (triangle: number) => boolean): number {
    let split = from;
    for (let i = from; i < to; ++i) {
      const triangle = this.order[i]!;
      if (!isLow(triangle)) continue;
      this.order[i] = this.order[split]!;
      this.order[split++] = triangle;
    }
    return split;
  }

  private boundsOf(from: number, to: number): number[] {
    const bounds = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let i = from; i < to; ++i) {
      for (let k = 0; k < 3; ++k) {
        const vertex = this.vertices[this.order[i]! * 3 + k]! * 3;
        for (let axis = 0; axis < 3; ++axis) {
          const value = this.positions[vertex + axis]!;
          if (value < bounds[axis]!) bounds[axis] = value;
          if (value > bounds[axis + 3]!) bounds[axis + 3] = value;
        }
      }
    }
    return bounds;
  }

  private entersBox(node: number, origin: readonly number[], direction: readonly number[], limit: number): boolean {
    let enter = 0;
    let leave = limit;
    for (let axis = 0; axis < 3; ++axis) {
      const low = this.bounds[node * 6 + axis]! - origin[axis]!;
      const high = this.bounds[node * 6 + 3 + axis]! - origin[axis]!;
      const step = direction[axis]!;
      if (step === 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const [near, far] = step > 0 ? [low / step, high / step] : [high / step, low / step];
      if (near > enter) enter = near;
      if (far < leave) leave = far;
    }
    return enter <= leave;
  }

  /** Negative if the ray misses it (Möller and Trumbore's test). */
  private distanceTo(triangle: number, origin: readonly number[], direction: readonly number[]): number {
    const p = this.positions;
    const a = this.vertices[triangle * 3]! * 3;
    const b = this.vertices[triangle * 3 + 1]! * 3;
    const c = this.vertices[triangle * 3 + 2]! * 3;
    const [dx, dy, dz] = [direction[0]!, direction[1]!, direction[2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) return -1;
    const [tx, ty, tz] = [origin[0]! - p[a]!, origin[1]! - p[a + 1]!, origin[2]! - p[a + 2]!];
    const u = (tx * px + ty * py + tz * pz) / determinant;
    if (!(u >= 0 && u <= 1)) return -1;
    const [qx, qy, qz] = [ty * uz - tz * uy, tz * ux - tx * uz, tx * uy - ty * ux];
    const v = (dx * qx + dy * qy + dz * qz) / determinant;
    if (!(v >= 0 && u + v <= 1)) return -1;
    return (vx * qx + vy * qy + vz * qz) / determinant;
  }
}
