// The cameras: from the visitor's eyes, behind it, from above, around it, and flying freely. Each keeps what the
// pointer has changed: turn, tilt, distance, place.

import { MathUtils, Vector3, type PerspectiveCamera } from 'three';
import type { Pose } from '../data/path';
import type { CameraMode } from '../store';
import type { Picker } from './picker';
import type { View } from './sightline';

export interface Visitor {
  pose: Pose;
  /** Metres above the foot point. */
  eyeHeight: number;
  height: number;
}

const up = new Vector3(0, 1, 0);
const tiltLimit = Math.PI / 2 - 0.01;

export class CameraRig {
  mode: CameraMode = 'third';
  /** Offsets to the visitor's direction, radians, and how far behind. */
  private readonly first = { turn: 0, tilt: 0 };
  private readonly third = { turn: 0, tilt: 0.22, distance: 4 };
  private readonly top = { height: 40, x: 0, z: 0 };
  private readonly orbit = { turn: 0.6, tilt: 0.42, distance: 8, target: null as Vector3 | null };
  private readonly free = { position: new Vector3(0, 10, 20), turn: 0, tilt: -0.3, placed: false };

  constructor(private readonly camera: PerspectiveCamera) {}

  setMode(mode: CameraMode): void {
    if (mode === 'free' && this.mode !== 'free') this.startFlight();
    if (mode !== this.mode) this.orbit.target = null;
    this.mode = mode;
    if (mode === 'third') Object.assign(this.third, { turn: 0, tilt: 0.22 });
    if (mode === 'first') Object.assign(this.first, { turn: 0, tilt: 0 });
    if (mode === 'top') Object.assign(this.top, { x: 0, z: 0 });
  }

  /** Around a fixed point, as placed by `viewOf`. */
  lookFrom(view: View): void {
    this.mode = 'orbit';
    const offset = view.position.clone().sub(view.target);
    this.orbit.target = view.target.clone();
    this.orbit.distance = offset.length();
    this.orbit.turn = Math.atan2(offset.x, offset.z);
    this.orbit.tilt = Math.asin(offset.y / this.orbit.distance);
  }

  /** High enough to see a whole region. */
  overlook(center: Vector3, size: number): void {
    this.mode = 'orbit';
    Object.assign(this.orbit, { target: center.clone(), distance: size, turn: 0.6, tilt: 0.85 });
  }

  drag(dx: number, dy: number): void {
    const turn = -dx * 0.005;
    const tilt = dy * 0.005;
    switch (this.mode) {
      case 'first':
        this.first.turn += turn * 0.7;
        this.first.tilt = MathUtils.clamp(this.first.tilt - tilt * 0.7, -1.4, 1.4);
        break;
      case 'third':
        this.third.turn += turn;
        this.third.tilt = MathUtils.clamp(this.third.tilt + tilt, -0.4, 1.3);
        break;
      case 'orbit':
        this.orbit.turn += turn;
        this.orbit.tilt = MathUtils.clamp(this.orbit.tilt + tilt, -0.3, 1.5);
        break;
      case 'free':
        this.free.turn += turn * 0.7;
        this.free.tilt = MathUtils.clamp(this.free.tilt - tilt * 0.7, -tiltLimit, tiltLimit);
        break;
      case 'top':
        this.pan(dx, dy);
    }
  }

  /** With the other button: moves what is looked at. */
  pan(dx: number, dy: number): void {
    if (this.mode === 'top') {
      const metres = (this.top.height * 2 * Math.tan(MathUtils.degToRad(this.camera.fov / 2))) / this.viewHeight;
      this.top.x -= dx * metres;
      this.top.z -= dy * metres;
      return;
    }
    if (this.mode !== 'orbit') return this.drag(dx, dy);
    const metres = this.orbit.distance * 0.0015;
    const right = new Vector3(Math.cos(this.orbit.turn), 0, -Math.sin(this.orbit.turn));
    const ahead = new Vector3(-Math.sin(this.orbit.turn), 0, -Math.cos(this.orbit.turn));
    this.orbit.target ??= this.lastCenter.clone();
    this.orbit.target.addScaledVector(right, -dx * metres).addScaledVector(ahead, dy * metres);
  }

  zoom(steps: number): void {
    const factor = 1.12 ** steps;
    if (this.mode === 'third') this.third.distance = MathUtils.clamp(this.third.distance * factor, 1.2, 40);
    if (this.mode === 'orbit') this.orbit.distance = MathUtils.clamp(this.orbit.distance * factor, 0.6, 900);
    if (this.mode === 'top') this.top.height = MathUtils.clamp(this.top.height * factor, 4, 900);
    if (this.mode === 'free') this.fly(0, 0, -steps * 1.5);
  }

  /** Metres to the right, up and ahead. */
  fly(right: number, upward: number, ahead: number): void {
    const { turn, tilt, position } = this.free;
    const direction = directionOf(turn, tilt);
    position.addScaledVector(direction, ahead).addScaledVector(up, upward);
    position.addScaledVector(direction.cross(up).normalize(), right);
  }

  private viewHeight = 1;
  private readonly lastCenter = new Vector3();

  apply(visitor: Visitor, picker: Picker | null, viewHeight: number): void {
    this.viewHeight = Math.max(1, viewHeight);
    const { pose } = visitor;
    const eye = new Vector3(pose.x, pose.y + visitor.eyeHeight, pose.z);
    const center = new Vector3(pose.x, pose.y + visitor.height * 0.55, pose.z);
    this.lastCenter.copy(center);
    switch (this.mode) {
      case 'first':
        this.look(eye, pose.yaw + this.first.turn, pose.pitch + this.first.tilt);
        break;
      case 'third':
        this.follow(eye, pose.yaw, picker);
        break;
      case 'top':
        this.camera.position.set(pose.x + this.top.x, pose.y + this.top.height, pose.z + this.top.z);
        this.camera.up.set(0, 0, -1);
        this.camera.lookAt(pose.x + this.top.x, pose.y, pose.z + this.top.z);
        break;
      case 'orbit':
        this.circle(this.orbit.target ?? center);
        break;
      case 'free':
        this.look(this.free.position, this.free.turn, this.free.tilt);
    }
    this.camera.updateMatrixWorld();
  }

  private look(position: Vector3, yaw: number, pitch: number): void {
    this.camera.position.copy(position);
    this.camera.up.copy(up);
    this.camera.lookAt(position.clone().add(directionOf(yaw, pitch)));
  }

  /** Behind the visitor, nearer where something is between. */
  private follow(eye: Vector3, yaw: number, picker: Picker | null): void {
    const { turn, tilt, distance } = this.third;
    const back = directionOf(yaw + turn, -tilt).negate();
    const room = picker ? picker.clearance(eye, back, distance + 0.3) - 0.3 : distance;
    this.camera.position.copy(eye).addScaledVector(back, MathUtils.clamp(room, 0.25, distance));
    this.camera.up.copy(up);
    this.camera.lookAt(eye);
  }

  private circle(target: Vector3): void {
    const { turn, tilt, distance } = this.orbit;
    const flat = Math.cos(tilt) * distance;
    this.camera.position.set(
      target.x + Math.sin(turn) * flat,
      target.y + Math.sin(tilt) * distance,
      target.z + Math.cos(turn) * flat,
    );
    this.camera.up.copy(up);
    this.camera.lookAt(target);
  }

  /** A flight begins where the last camera was. */
  private startFlight(): void {
    const direction = this.camera.getWorldDirection(new Vector3());
    this.free.position.copy(this.camera.position);
    this.free.turn = this.mode === 'top' ? 0 : Math.atan2(-direction.x, -direction.z);
    this.free.tilt = MathUtils.clamp(Math.asin(MathUtils.clamp(direction.y, -1, 1)), -tiltLimit, tiltLimit);
  }
}

/** Yaw 0 looks along -Z, positive turns left. */
export function directionOf(yaw: number, pitch: number): Vector3 {
  return new Vector3(-Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), -Math.cos(yaw) * Math.cos(pitch));
}
