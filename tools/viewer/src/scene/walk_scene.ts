// A walk in 3D: the visitor, its trail, trigger volumes, contacts, its gaze, and what is in its way.

import {
  ArrowHelper,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  SphereGeometry,
  Vector3,
} from 'three';
import type { Avatar, Finding } from '../format';
import { isCrouching, isDuring } from '../data/spans';
import type { LogLine } from '../data/log';
import type { Obstacle } from '../data/obstacle';
import type { Path } from '../data/path';
import type { WalkData } from '../data/report';
import type { Layers } from '../store';
import type { WalkContext } from '../walk/context';
import { directionOf, type Visitor } from './cameras';
import type { LoadedCampus } from './campuses';
import { Figure, otherColors, visitorColors } from './figure';
import type { Label, Labels } from './labels';
import { contains, edgesOf, facesOf, geometryOf, Volume } from './shapes';
import type { Stage } from './stage';
import { Trail } from './trail';

const defaultAvatar: Avatar = { radius: 0.3, height: 1.8, eye_height: 1.7 };
const colors = {
  trail: 0x2b7cff,
  other: 0xf08c1e,
  trigger: 0x35b6d9,
  contact: 0xff5a2c,
  gaze: 0xf5d742,
  failure: 0xff2a2a,
};

interface Walker {
  path: Path;
  log: LogLine[];
  figure: Figure;
  trail: Trail;
}

export class WalkScene {
  private readonly root = new Group();
  private readonly walkers: Walker[] = [];
  private readonly volumes: Volume[] = [];
  private readonly triggers = new Group();
  private readonly contacts = new Group();
  private readonly findings = new Group();
  private readonly obstacle = new Group();
  private readonly contactMarks: { from: number; to: number; root: Group }[] = [];
  private readonly gaze: Line;
  private readonly shownLabels: { label: Label; layer: keyof Layers }[] = [];
  private obstacleLabels: Label[] = [];
  private obstacleId = '';

  constructor(
    private readonly stage: Stage,
    private readonly loaded: LoadedCampus,
    private readonly context: WalkContext,
    private readonly labels: Labels,
  ) {
    this.addWalker(context.data, visitorColors, colors.trail, 4, 0);
    if (context.other) this.addWalker(context.other.data, otherColors, colors.other, 3, 0.03);
    this.addTriggers();
    this.addContacts();
    this.gaze = new Line(
      new BufferGeometry().setAttribute('position', new Float32BufferAttribute(6, 3)),
      new LineBasicMaterial({ color: colors.gaze, transparent: true, opacity: 0.9, fog: false }),
    );
    this.gaze.frustumCulled = false;
    this.root.add(this.triggers, this.contacts, this.findings, this.obstacle, this.gaze);
    this.addParting();
    stage.scene.add(this.root);
  }

  get avatar(): Avatar {
    return this.context.data.details.recording?.avatar ?? defaultAvatar;
  }

  visitorAt(tick: number): Visitor {
    const { log, path } = this.context.data;
    const { eye_height: eyeHeight, height, crouch_eye_height, crouch_height } = this.avatar;
    const pose = path?.at(tick) ?? { x: 0, y: 0, z: 0, yaw: 0, pitch: 0 };
    return isCrouching(log, tick)
      ? { pose, eyeHeight: crouch_eye_height ?? eyeHeight * 0.6, height: crouch_height ?? height * 0.6 }
      : { pose, eyeHeight, height };
  }

  get figures(): number[][] {
    return this.walkers.map(({ figure }) => figure.root.position.toArray());
  }

  /** Ids of what is lit as an obstacle. */
  get litObjects(): string[] {
    return this.obstacleId === '' ? [] : [this.obstacleId];
  }

  setTick(tick: number, layers: Layers, fromEyes: boolean): void {
    this.walkers.forEach(({ path, log, figure, trail }, index) => {
      const at = Math.min(tick, path.lastTick);
      figure.set(path.at(at), path.distanceAt(at), tick > at ? 0 : path.speedAt(at), isCrouching(log, at));
      figure.showBody(index > 0 || !fromEyes);
      figure.showCapsule(layers.capsule && (index > 0 || !fromEyes));
      trail.setTick(at);
      trail.root.visible = layers.trail;
    });
    this.triggers.visible = layers.triggers;
    this.contacts.visible = layers.contacts;
    this.findings.visible = layers.findings;
    const active = new Set(
      this.context.spans.filter((span) => span.kind === 'trigger' && isDuring(span, tick)).map((span) => span.object),
    );
    for (const volume of this.volumes) volume.setActive(active.has(volume.object.id));
    for (const { from, to, root } of this.contactMarks) {
      root.visible = from <= tick;
      root.scale.setScalar(isDuring({ from, to }, tick) ? 1.6 : 0.8);
    }
    for (const { label, layer } of this.shownLabels) label.root.classList.toggle('off', !layers[layer]);
    this.setGaze(tick, layers.gaze && !fromEyes);
  }

  /** Lights what is in the way in red, instead of what was lit before. */
  showObstacle(shown: Obstacle): void {
    this.obstacle.clear();
    for (const label of this.obstacleLabels.splice(0)) this.labels.remove(label);
    const index = this.context.objects.get(shown.object) ?? -1;
    const object = this.context.campus?.objects[index];
    this.obstacleId = object?.id ?? '';
    const at = shown.at ? new Vector3(...shown.at) : null;
    const pieces = object ? this.loaded.model.piecesOf(index) : [];
    this.loaded.obstacle.show(pieces, at);
    if (object && object.shape !== 'mesh') {
      const geometry = geometryOf(object);
      this.obstacle.add(edgesOf(geometry, colors.failure, 0.9, 20, 8));
      // A shape without nodes of the model is drawn itself.
      const faces = facesOf(geometry, colors.failure, 0.4, 7);
      Object.assign(faces.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
      if (pieces.length === 0) this.obstacle.add(faces);
    }
    if (at) {
      this.obstacle.add(ball(at, 0.05, colors.failure));
      const foot = shown.tick === null ? null : this.visitorAt(shown.tick).pose.y;
      if (foot === null || !this.addMeasure(shown, at, foot)) {
        this.obstacleLabels.push(this.labels.add(shown.object || 'here', at, 'failure', Infinity, 'below'));
      }
    }
  }

  showFindings(findings: readonly Finding[]): void {
    for (const finding of findings) {
      if (!finding.at) continue;
      const at = new Vector3(...finding.at);
      this.findings.add(ball(at.clone().add(new Vector3(0, 0.25, 0)), 0.14, 0xd946a6));
      const label = this.labels.add(String(finding.number), at.clone().add(new Vector3(0, 0.5, 0)), 'finding', 120);
      label.root.title = `${finding.kind} ${finding.subject}: ${finding.text}`;
      this.shownLabels.push({ label, layer: 'findings' });
    }
  }

  /** Triggers that the point is in. */
  triggersAt(point: Vector3): string[] {
    return this.volumes.filter((volume) => contains(volume.object, point)).map((volume) => volume.object.id);
  }

  resize(width: number, height: number): void {
    this.walkers.forEach(({ trail }) => trail.resize(width, height));
  }

  dispose(): void {
    this.root.removeFromParent();
    this.walkers.forEach(({ figure, trail }) => (figure.dispose(), trail.dispose()));
    this.loaded.obstacle.clear();
    this.loaded.hovered.clear();
    this.loaded.model.cut(null);
    for (const { label } of this.shownLabels) this.labels.remove(label);
    for (const label of this.obstacleLabels) this.labels.remove(label);
    this.stage.invalidate();
  }

  private addWalker(data: WalkData, look: typeof visitorColors, color: number, width: number, lift: number): void {
    const { path, log, details } = data;
    if (!path) return;
    const figure = new Figure(details.recording?.avatar ?? defaultAvatar, look);
    const trail = new Trail(path, { color, width, lift });
    this.root.add(figure.root, trail.root);
    this.walkers.push({ path, log, figure, trail });
  }

  private addTriggers(): void {
    for (const object of this.context.campus?.objects ?? []) {
      if (!object.modes.includes('trigger')) continue;
      const volume = new Volume(object, colors.trigger);
      this.volumes.push(volume);
      this.triggers.add(volume.root);
      const top = new Vector3(
        (object.min[0] + object.max[0]) / 2,
        object.max[1] + 0.1,
        (object.min[2] + object.max[2]) / 2,
      );
      this.shownLabels.push({ label: this.labels.add(object.id, top, 'trigger', 26), layer: 'triggers' });
    }
  }

  private addContacts(): void {
    for (const contact of this.context.data.details.recording?.contacts ?? []) {
      const root = new Group();
      root.add(ball(new Vector3(), 0.045, colors.contact));
      const normal = new Vector3(...contact.normal);
      if (normal.lengthSq() > 0) {
        root.add(new ArrowHelper(normal.normalize(), new Vector3(), 0.45, colors.contact, 0.13, 0.08));
      }
      root.position.set(...contact.point);
      this.contacts.add(root);
      this.contactMarks.push({ from: contact.tick, to: contact.to, root });
    }
  }

  /** From the eyes to what is looked at. */
  private setGaze(tick: number, shown: boolean): void {
    this.gaze.visible = shown && this.context.data.path !== null;
    if (!this.gaze.visible) return;
    const { pose, eyeHeight } = this.visitorAt(tick);
    const eye = new Vector3(pose.x, pose.y + eyeHeight, pose.z);
    const direction = directionOf(pose.yaw, pose.pitch);
    const reach = this.avatar.gaze_distance ?? 10;
    const end = eye.clone().addScaledVector(direction, this.loaded.picker.clearance(eye, direction, reach));
    const position = this.gaze.geometry.getAttribute('position');
    position.setXYZ(0, ...eye.addScaledVector(direction, 0.15).toArray());
    position.setXYZ(1, ...end.toArray());
    position.needsUpdate = true;
    const isHit = this.context.spans.some((span) => span.kind === 'ray' && isDuring(span, tick));
    (this.gaze.material as LineBasicMaterial).opacity = isHit ? 1 : 0.4;
  }

  /** Brackets as high as the riser and as what the visitor can step; false if there is nothing to measure so. */
  private addMeasure({ measure, object }: Obstacle, at: Vector3, foot: number): boolean {
    const isUp = measure !== null && /^(riser|ledge|headroom)$/.test(measure.kind);
    if (!isUp) return false;
    const bracket = (height: number, color: number, aside: number): Vector3 => {
      const base = new Vector3(at.x + aside, foot, at.z + aside);
      const top = base.clone().setY(foot + height);
      const bar = (y: number): Vector3[] => [-0.08, 0.08].map((x) => new Vector3(base.x + x, y, base.z));
      const geometry = new BufferGeometry().setFromPoints([base, top, ...bar(foot), ...bar(foot + height)]);
      const lines = new LineSegments(geometry, new LineBasicMaterial({ color, depthTest: false, fog: false }));
      lines.renderOrder = 9;
      this.obstacle.add(lines);
      return top;
    };
    const top = bracket(measure.measured, colors.failure, 0);
    this.obstacleLabels.push(
      this.labels.add(
        `${object || 'here'}: ${measure.kind} ${measure.measured.toFixed(2)} m`,
        top,
        'failure',
        Infinity,
        'left',
      ),
    );
    if (measure.allowed === null) return true;
    const can = bracket(measure.allowed, 0x3ddc84, 0.2);
    const word = measure.kind === 'headroom' ? 'needs' : 'steps';
    this.obstacleLabels.push(
      this.labels.add(`${word} ${measure.allowed.toFixed(2)} m`, can, 'measure', Infinity, 'right'),
    );
    return true;
  }

  private addParting(): void {
    const { other, data } = this.context;
    if (!other || other.partsAt === null || !data.path) return;
    const { x, y, z } = data.path.at(other.partsAt);
    const ring = new Mesh(
      new RingGeometry(0.45, 0.6, 40).rotateX(-Math.PI / 2),
      new MeshBasicMaterial({ color: 0xffffff, transparent: true, opacity: 0.9, depthWrite: false, fog: false }),
    );
    ring.position.set(x, y + 0.08, z);
    ring.renderOrder = 5;
    this.root.add(ring);
    const time = (other.partsAt / this.context.ticksPerSecond).toFixed(2);
    const label = this.labels.add(`paths part here, ${time} s`, new Vector3(x, y + 2.2, z), 'parting');
    this.shownLabels.push({ label, layer: 'trail' });
  }
}

function ball(at: Vector3, radius: number, color: number): Mesh {
  const mesh = new Mesh(
    new SphereGeometry(radius, 14, 10),
    new MeshBasicMaterial({ color, fog: false, toneMapped: false }),
  );
  mesh.position.copy(at);
  return mesh;
}
