// The recorded path of the visitor's foot point: where it is at any tick.

import type { KeyFrames } from '../format';

export interface Pose {
  x: number;
  y: number;
  z: number;
  /** Radians; yaw 0 looks along -Z, positive turns left. */
  yaw: number;
  pitch: number;
}

const radians = Math.PI / 180;

export class Path {
  readonly length: number;
  readonly ticks: Float64Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  private readonly yaw: Float64Array;
  private readonly pitch: Float64Array;
  /** Metres from the start to each key frame; jumps count nothing. */
  private readonly covered: Float64Array;
  private readonly jumps: Set<number>;

  constructor(frames: KeyFrames) {
    this.length = frames.tick.length;
    this.ticks = summed(frames.tick, 1);
    this.x = summed(frames.x, 1000);
    this.y = summed(frames.y, 1000);
    this.z = summed(frames.z, 1000);
    this.yaw = summed(frames.yaw, 10);
    this.pitch = summed(frames.pitch, 10);
    this.jumps = new Set(frames.cut ?? []);
    this.covered = new Float64Array(this.length);
    for (let i = 1; i < this.length; ++i) {
      const step = Math.hypot(this.x[i]! - this.x[i - 1]!, this.z[i]! - this.z[i - 1]!);
      this.covered[i] = this.covered[i - 1]! + (this.jumps.has(i) ? 0 : step);
    }
  }

  get lastTick(): number {
    return this.length > 0 ? this.ticks[this.length - 1]! : 0;
  }

  isJump(key: number): boolean {
    return this.jumps.has(key);
  }

  /** The last key frame at or before the tick, and how far it is to the next, 0 to 1. */
  locate(tick: number): { key: number; share: number } {
    let low = 0;
    let high = this.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.ticks[middle]! <= tick) low = middle;
      else high = middle - 1;
    }
    const next = low + 1;
    if (next >= this.length || this.jumps.has(next) || tick <= this.ticks[low]!) return { key: low, share: 0 };
    return { key: low, share: (tick - this.ticks[low]!) / (this.ticks[next]! - this.ticks[low]!) };
  }

  at(tick: number): Pose {
    const { key, share } = this.locate(tick);
    const between = (values: Float64Array): number => {
      const from = values[key] ?? 0;
      return share === 0 ? from : from + (values[key + 1]! - from) * share;
    };
    return {
      x: between(this.x),
      y: between(this.y),
      z: between(this.z),
      yaw: between(this.yaw) * radians,
      pitch: between(this.pitch) * radians,
    };
  }

  /** Metres walked until then, horizontally. */
  distanceAt(tick: number): number {
    const { key, share } = this.locate(tick);
    const from = this.covered[key] ?? 0;
    return share === 0 ? from : from + (this.covered[key + 1]! - from) * share;
  }

  /** Metres a tick. */
  speedAt(tick: number): number {
    return this.distanceAt(tick + 0.5) - this.distanceAt(tick - 0.5);
  }

  /** Runs of key frames without a jump, as [first, last]. */
  pieces(): [number, number][] {
    const pieces: [number, number][] = [];
    let first = 0;
    for (let i = 1; i <= this.length; ++i) {
      if (i === this.length || this.jumps.has(i)) {
        pieces.push([first, i - 1]);
        first = i;
      }
    }
    return this.length > 0 ? pieces : [];
  }
}

/** Undoes delta coding. */
function summed(differences: readonly number[], unit: number): Float64Array {
  const values = new Float64Array(differences.length);
  let sum = 0;
  differences.forEach((difference, i) => {
    sum += difference;
    values[i] = sum / unit;
  });
  return values;
}

/** The points of a row's plan, metres: [x, z]. */
export function planPoints(plan: readonly number[] | undefined): [number, number][] {
  const points: [number, number][] = [];
  let x = 0;
  let z = 0;
  for (let i = 0; i + 1 < (plan?.length ?? 0); i += 2) {
    x += plan![i]!;
    z += plan![i + 1]!;
    points.push([x / 10, z / 10]);
  }
  return points;
}
