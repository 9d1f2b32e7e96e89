// The path on the ground: a line as wide on every screen, strong up to the visitor and pale ahead.

import { Group, Vector2 } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import type { Path } from '../data/path';

const above = 0.06; // metres over the ground, so that it isn't drawn in it

interface TrailStyle {
  color: number;
  width: number;
  /** Metres added to the height, where two lie over each other. */
  lift: number;
}

export class Trail {
  readonly root = new Group();
  private readonly lines: LineSegments2[] = [];
  private readonly past: LineSegmentsGeometry;
  /** From the last key frame to the visitor. */
  private readonly tip: LineSegmentsGeometry;
  /** For each key frame, how many segments lie before it. */
  private readonly before: Uint32Array;
  private readonly height: number;

  constructor(
    private readonly path: Path,
    private readonly style: TrailStyle,
  ) {
    this.height = above + style.lift;
    this.before = new Uint32Array(path.length);
    const positions = this.segments();
    const all = new LineSegmentsGeometry();
    all.setPositions(positions);
    this.past = new LineSegmentsGeometry();
    this.past.setPositions(positions);
    this.tip = new LineSegmentsGeometry();
    this.tip.setPositions(new Float32Array(6));
    // What walls hide is hinted at.
    this.addLine(all, style.width, 0.16, false);
    this.addLine(all, style.width, 0.38, true);
    this.addLine(this.past, style.width + 1, 1, true);
    this.addLine(this.tip, style.width + 1, 1, true);
  }

  setTick(tick: number): void {
    const { key, share } = this.path.locate(tick);
    this.past.instanceCount = this.before[key] ?? 0;
    const from = this.pointAt(key);
    const pose = this.path.at(tick);
    this.tip.setPositions([...from, ...(share > 0 ? [pose.x, pose.y + this.height, pose.z] : from)]);
  }

  resize(width: number, height: number): void {
    for (const line of this.lines) line.material.resolution = new Vector2(width, height);
  }

  dispose(): void {
    this.root.removeFromParent();
    for (const line of this.lines) {
      line.geometry.dispose();
      line.material.dispose();
    }
  }

  private pointAt(key: number): [number, number, number] {
    return [this.path.x[key] ?? 0, (this.path.y[key] ?? 0) + this.height, this.path.z[key] ?? 0];
  }

  private segments(): Float32Array {
    const positions: number[] = [];
    for (let key = 0; key < this.path.length; ++key) {
      if (key > 0 && !this.path.isJump(key)) positions.push(...this.pointAt(key - 1), ...this.pointAt(key));
      this.before[key] = positions.length / 6;
    }
    return positions.length > 0 ? new Float32Array(positions) : new Float32Array(6);
  }

  private addLine(geometry: LineSegmentsGeometry, width: number, opacity: number, depthTest: boolean): void {
    const material = new LineMaterial({
      color: this.style.color,
      linewidth: width,
      opacity,
      transparent: opacity < 1,
      depthTest,
      depthWrite: false,
      fog: false,
      toneMapped: false,
    });
    const line = new LineSegments2(geometry, material);
    line.frustumCulled = false;
    line.renderOrder = depthTest ? 4 : 3;
    this.lines.push(line);
    this.root.add(line);
  }
}
