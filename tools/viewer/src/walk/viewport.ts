// The 3D part of a walk's page: puts the scene on the stage, moves the camera, finds what the pointer is on.

import { Vector2, Vector3 } from 'three';
import { element, Scope } from '../ui/dom';
import { planPoints } from '../data/path';
import type { Point } from '../format';
import { CameraRig, directionOf } from '../scene/cameras';
import type { LoadedCampus } from '../scene/campuses';
import { Labels } from '../scene/labels';
import type { Hit } from '../scene/picker';
import { viewOf } from '../scene/sightline';
import type { Stage } from '../scene/stage';
import { WalkScene } from '../scene/walk_scene';
import { AuthorMarks } from './author_marks';
import type { WalkContext } from './context';
import { HoverCard } from './hover_card';

export class Viewport {
  readonly root: HTMLElement;
  readonly rig: CameraRig;
  readonly marks: AuthorMarks;
  private readonly labels = new Labels();
  private readonly scene: WalkScene;
  private readonly hover: HoverCard;
  private readonly keys = new Set<string>();
  private width = 1;
  private height = 1;

  constructor(
    private readonly context: WalkContext,
    private readonly stage: Stage,
    private readonly loaded: LoadedCampus,
    private readonly scope: Scope,
  ) {
    const { store } = context;
    this.rig = new CameraRig(stage.camera);
    this.scene = new WalkScene(stage, loaded, context, this.labels);
    this.scene.showFindings(
      (context.report.index.findings ?? []).filter((finding) => finding.campus === context.data.row.campus),
    );
    this.marks = new AuthorMarks(stage, context, scope);
    this.hover = new HoverCard(context, (point) => this.scene.triggersAt(point));
    stage.canvas.tabIndex = 0;
    stage.canvas.setAttribute('role', 'img');
    stage.canvas.setAttribute('aria-label', 'The campus in 3D, with the visitor');
    this.root = element('div', { class: 'viewport-scene' }, stage.canvas, this.labels.root, this.hover.root);
    scope.resized(this.root, () => this.resize());
    this.listen();
    const update = (seconds: number): boolean => this.update(seconds);
    stage.animations.add(update);
    scope.add(() => stage.animations.delete(update));
    store.on(scope, 'camera', (mode) => (this.rig.setMode(mode), stage.invalidate()));
    store.on(scope, 'cut', (height) => (loaded.model.cut(height), stage.invalidate()));
    for (const each of ['tick', 'layers'] as const) store.on(scope, each, () => stage.invalidate());
    scope.add(() => this.scene.dispose());
  }

  /** Lights what was in the way of a failure, and looks at it from where it is seen. */
  showFailure(index: number): void {
    const entry = this.context.failures[index];
    if (!entry) return;
    const { failure, obstacle } = entry;
    const tick = failure.scene?.tick ?? this.context.lastTick;
    this.context.store.set({ tick, playing: false });
    this.scene.showObstacle(obstacle);
    const { pose, height } = this.scene.visitorAt(tick);
    const body = new Vector3(pose.x, pose.y + height * 0.55, pose.z);
    const at = obstacle.at ? new Vector3(...obstacle.at) : body.clone().add(directionOf(pose.yaw, 0).multiplyScalar(0.5));
    const ahead = at.clone().sub(body).setY(0);
    // What can't be reached may be far away: then as if the visitor stood before it.
    if (at.distanceTo(body) > 6) body.copy(at).addScaledVector(ahead.clone().normalize(), -1.2);
    if (ahead.lengthSq() < 1e-4) ahead.copy(directionOf(pose.yaw, 0));
    this.context.store.set({ camera: 'orbit' });
    this.rig.lookFrom(viewOf(this.loaded.picker, body, at, ahead.normalize()));
    this.stage.invalidate();
  }

  /** From a little above, a few steps away. */
  lookAt(point: Point): void {
    this.context.store.set({ camera: 'orbit', playing: false });
    this.rig.overlook(new Vector3(...point), 12);
    this.stage.invalidate();
  }

  /** Looks at the whole of the path. */
  overlook(): void {
    const points = planPoints(this.context.data.row.plan);
    if (points.length === 0) return;
    const center = points
      .reduce((sum, [x, z]) => sum.add(new Vector3(x, 0, z)), new Vector3())
      .divideScalar(points.length);
    const reach = Math.max(...points.map(([x, z]) => Math.hypot(x - center.x, z - center.z)));
    const heights = [...(this.context.data.path?.y ?? [0])];
    const highest = heights.reduce((most, y) => Math.max(most, y));
    center.y = (highest + heights.reduce((least, y) => Math.min(least, y))) / 2;
    this.context.store.set({ camera: 'orbit' });
    this.rig.overlook(center, Math.max(12, reach * 2.2));
    this.update(0);
    if (this.isHidden()) this.context.store.set({ cut: highest + this.scene.avatar.height + 0.4 });
    this.stage.invalidate();
  }

  /** What is at a point of the canvas, in CSS pixels from its top left. */
  pick(x: number, y: number): Hit | null {
    const { camera } = this.stage;
    const clip = new Vector2((x / this.width) * 2 - 1, 1 - (y / this.height) * 2);
    const direction = new Vector3(clip.x, clip.y, 0.5).unproject(camera).sub(camera.position).normalize();
    return this.loaded.picker.cast(camera.position.clone(), direction);
  }

  /** Whether less than half of the path can be seen. */
  private isHidden(): boolean {
    const { path } = this.context.data;
    if (!path) return false;
    const samples = Array.from({ length: 16 }, (_, i) => path.at((path.lastTick * (i + 0.5)) / 16));
    const seen = samples.filter(({ x, y, z }) =>
      this.loaded.picker.sees(this.stage.camera.position, new Vector3(x, y + 0.5, z)),
    );
    return seen.length < samples.length / 2;
  }

  private resize(): void {
    this.width = this.root.clientWidth;
    this.height = this.root.clientHeight;
    this.scene.resize(this.width, this.height);
    this.update(0);
    this.stage.resize(this.width, this.height);
  }

  private update(seconds: number): boolean {
    const { store } = this.context;
    const { tick, layers, camera } = store.state;
    const flying = this.fly(seconds);
    const visitor = this.scene.visitorAt(tick);
    this.rig.apply(visitor, this.loaded.picker, this.height);
    this.scene.setTick(tick, layers, camera === 'first');
    this.labels.place(this.stage.camera, this.width, this.height);
    return flying;
  }

  private fly(seconds: number): boolean {
    if (this.context.store.state.camera !== 'free' || this.keys.size === 0) return false;
    const along = (plus: string, minus: string): number => Number(this.keys.has(plus)) - Number(this.keys.has(minus));
    const metres = seconds * (this.keys.has('shift') ? 30 : 8);
    this.rig.fly(along('d', 'a') * metres, along('e', 'q') * metres, along('w', 's') * metres);
    return true;
  }

  private listen(): void {
    const { canvas } = this.stage;
    let pressed: { x: number; y: number; moved: boolean } | null = null;
    const pointers = new Map<number, { x: number; y: number }>();
    const isDrawing = (): boolean => this.context.store.state.tool === 'box';
    this.scope.listen(canvas, 'pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      pressed = { x: event.offsetX, y: event.offsetY, moved: false };
      this.hover.hide();
      if (isDrawing() && event.button === 0) this.marks.beginBox(this.pick(event.offsetX, event.offsetY));
    });
    this.scope.listen(canvas, 'pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before || !pressed) {
        this.hoverAt(event);
        return;
      }
      const [dx, dy] = [event.offsetX - before.x, event.offsetY - before.y];
      if (Math.hypot(event.offsetX - pressed.x, event.offsetY - pressed.y) > 4) pressed.moved = true;
      if (isDrawing() && pointers.size === 1 && event.buttons & 1) {
        this.marks.stretchBox(this.pick(event.offsetX, event.offsetY));
      } else if (pointers.size === 2) {
        this.pinch(pointers, event);
      } else if (event.buttons & 6 || event.shiftKey) {
        this.rig.pan(dx, dy);
      } else {
        this.rig.drag(dx, dy);
      }
      pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      this.stage.invalidate();
    });
    const lift = (event: PointerEvent): void => {
      pointers.delete(event.pointerId);
      if (isDrawing()) this.marks.endBox();
      else if (pressed && !pressed.moved && event.type === 'pointerup') this.clicked(event);
      if (pointers.size === 0) pressed = null;
    };
    this.scope.listen(canvas, 'pointerup', lift);
    this.scope.listen(canvas, 'pointercancel', lift);
    this.scope.listen(canvas, 'pointerleave', () => this.hoverOff());
    this.scope.listen(canvas, 'contextmenu', (event) => event.preventDefault());
    this.scope.listen(
      canvas,
      'wheel',
      (event) => {
        event.preventDefault();
        this.rig.zoom(Math.sign(event.deltaY) * Math.min(3, Math.abs(event.deltaY) / 60 + 0.4));
        this.stage.invalidate();
      },
      { passive: false },
    );
    this.listenForFlight(canvas);
  }

  private listenForFlight(canvas: HTMLElement): void {
    this.scope.listen(canvas, 'keydown', (event) => {
      const key = event.key.toLowerCase();
      const isFlight = this.context.store.state.camera === 'free' && /^([wasdqe]|shift)$/.test(key);
      if (!isFlight || event.ctrlKey || event.metaKey) return;
      this.keys.add(key);
      if (key !== 'shift') event.stopPropagation();
      this.stage.invalidate();
    });
    this.scope.listen(canvas, 'keyup', (event) => this.keys.delete(event.key.toLowerCase()));
    this.scope.listen(canvas, 'blur', () => this.keys.clear());
  }

  private pinch(pointers: Map<number, { x: number; y: number }>, event: PointerEvent): void {
    const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    const before = pointers.get(event.pointerId);
    if (!other || !before) return;
    const was = Math.hypot(before.x - other.x, before.y - other.y);
    const is = Math.hypot(event.offsetX - other.x, event.offsetY - other.y);
    this.rig.zoom(Math.log(Math.max(was, 1) / Math.max(is, 1)) / Math.log(1.12));
    this.rig.pan((event.offsetX - before.x) / 2, (event.offsetY - before.y) / 2);
  }

  private clicked(event: PointerEvent): void {
    const hit = this.pick(event.offsetX, event.offsetY);
    if (this.context.store.state.tool === 'point') this.marks.addPoint(hit);
    else if (event.pointerType !== 'mouse') this.showHover(hit, event);
  }

  private hoverAt(event: PointerEvent): void {
    if (event.pointerType === 'mouse') this.showHover(this.pick(event.offsetX, event.offsetY), event);
  }

  private showHover(hit: Hit | null, event: PointerEvent): void {
    if (!this.hover.show(hit, event.offsetX, event.offsetY, this.width)) return;
    const object = this.hover.object;
    const bounds = this.context.campus?.objects[object];
    // Ground under the pointer is no news.
    const isGround = bounds !== undefined && bounds.max[0] - bounds.min[0] > 60 && bounds.max[2] - bounds.min[2] > 60;
    const pieces = object >= 0 && !isGround ? this.loaded.model.piecesOf(object) : [];
    this.loaded.hovered.show(
      pieces.length === 0 && object >= 0 && !isGround && hit ? [hit.piece] : pieces,
      hit?.point ?? null,
    );
    this.stage.invalidate();
  }

  private hoverOff(): void {
    this.hover.hide();
    this.loaded.hovered.clear();
    this.stage.invalidate();
  }

  /** Brings camera and scene to the state at once, before the next drawing does. */
  refresh(): void {
    this.update(0);
  }

  /** Where the figures stand now. */
  get figures(): number[][] {
    this.refresh();
    return this.scene.figures;
  }

  get litObjects(): string[] {
    return this.scene.litObjects;
  }
}
