// The visitor: a person of the avatar's size, whose legs swing with the metres walked.

import {
  CapsuleGeometry,
  CircleGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  SphereGeometry,
  EdgesGeometry,
  type BufferGeometry,
  type Object3D,
} from 'three';
import type { Avatar } from '../format';
import type { Pose } from '../data/path';

export const visitorColors = { coat: 0x2f6fde, bag: 0x18315c, trousers: 0x2c3442, skin: 0xe2b08d, hair: 0x3a2a1f };
export const otherColors = { ...visitorColors, coat: 0xe08a1e, bag: 0x5c3d12, trousers: 0x4a4038 };

/** Proportions of an adult of height 1. */
const hip = 0.51;
const shoulder = 0.82;

export class Figure {
  readonly root = new Group();
  private readonly body = new Group();
  private readonly capsule: LineSegments;
  private readonly limbs: { leftLeg: Group; rightLeg: Group; leftArm: Group; rightArm: Group };
  private readonly height: number;
  private readonly geometries: BufferGeometry[] = [];

  constructor(
    private readonly avatar: Avatar,
    colors: typeof visitorColors,
  ) {
    this.height = avatar.height;
    // Narrow bodies are drawn narrow, but nobody is a barrel.
    const girth = Math.min(1.15, Math.max(0.7, avatar.radius / (0.165 * this.height)));
    const coat = new MeshLambertMaterial({ color: colors.coat });
    const cloth = new MeshLambertMaterial({ color: colors.trousers });
    const skin = new MeshLambertMaterial({ color: colors.skin });
    const bag = new MeshLambertMaterial({ color: colors.bag });
    const hair = new MeshLambertMaterial({ color: colors.hair });

    const torso = this.part(new CapsuleGeometry(0.088, 0.185, 6, 14), coat, 0.675, 0);
    torso.scale.set(1.08 * girth, 1, 0.74 * girth);
    const hips = this.part(new SphereGeometry(0.085, 14, 10), cloth, 0.525, 0);
    hips.scale.set(1.08 * girth, 0.8, 0.8 * girth);
    const shoulders = this.part(new CapsuleGeometry(0.043, 0.17 * girth, 6, 14).rotateZ(Math.PI / 2), coat, 0.785, 0);
    shoulders.scale.set(1, 1, 0.92);
    // Shows from afar which way the visitor faces.
    const pack = this.part(new CapsuleGeometry(0.062, 0.1, 6, 12), bag, 0.7, 0.085 * girth);
    pack.scale.set(1, 1, 0.62);
    this.part(new CapsuleGeometry(0.026, 0.05, 4, 10), skin, 0.855, 0);
    const head = this.part(new SphereGeometry(0.062, 18, 14), skin, 0.93, -0.006);
    head.scale.set(0.86, 1.12, 0.98);
    const cap = this.part(new SphereGeometry(0.065, 18, 10, 0, Math.PI * 2, 0, Math.PI * 0.56), hair, 0.937, 0.006);
    cap.scale.set(0.9, 1.1, 1);
    const face = this.part(new SphereGeometry(0.012, 8, 6), skin, 0.922, -0.066);
    face.scale.set(0.8, 1.1, 1);

    this.limbs = {
      leftLeg: this.limb(-0.048 * girth, hip, 0.043, 0.4, cloth, hair),
      rightLeg: this.limb(0.048 * girth, hip, 0.043, 0.4, cloth, hair),
      leftArm: this.limb(-0.122 * girth, shoulder - 0.03, 0.028, 0.33, coat, skin),
      rightArm: this.limb(0.122 * girth, shoulder - 0.03, 0.028, 0.33, coat, skin),
    };
    this.limbs.leftArm.rotation.z = -0.1;
    this.limbs.rightArm.rotation.z = 0.1;
    this.body.scale.setScalar(this.height);
    // Drawn after what of the trail shows through walls, so that it doesn't show through the visitor.
    this.body.traverse((node) => {
      node.renderOrder = 3.5;
      if (node instanceof Mesh) (node.material as MeshLambertMaterial).transparent = true;
    });

    this.capsule = new LineSegments(
      new EdgesGeometry(new CapsuleGeometry(avatar.radius, this.height - 2 * avatar.radius, 4, 12), 1),
      new LineBasicMaterial({ color: colors.coat, transparent: true, opacity: 0.55 }),
    );
    this.capsule.position.y = this.height / 2;
    this.root.add(this.body, this.capsule, this.shadow());
  }

  set(pose: Pose, metresWalked: number, metresPerTick: number, crouching: boolean): void {
    this.root.position.set(pose.x, pose.y, pose.z);
    this.root.rotation.y = pose.yaw;
    // One step of each leg in 0.8 of the height; no swing when standing.
    const phase = (metresWalked / (0.8 * this.height)) * Math.PI * 2;
    const swing = Math.min(1, metresPerTick / 0.012) * 0.5;
    const { leftLeg, rightLeg, leftArm, rightArm } = this.limbs;
    leftLeg.rotation.x = Math.sin(phase) * swing;
    rightLeg.rotation.x = -Math.sin(phase) * swing;
    leftArm.rotation.x = -Math.sin(phase) * swing * 0.8;
    rightArm.rotation.x = Math.sin(phase) * swing * 0.8;
    const low = (this.avatar.crouch_height ?? this.height * 0.6) / this.height;
    this.body.scale.y = this.height * (crouching ? low : 1);
    this.capsule.scale.y = crouching ? low : 1;
    this.capsule.position.y = (this.height / 2) * (crouching ? low : 1);
  }

  showBody(shown: boolean): void {
    this.body.visible = shown;
  }

  showCapsule(shown: boolean): void {
    this.capsule.visible = shown;
  }

  dispose(): void {
    this.root.removeFromParent();
    this.geometries.forEach((geometry) => geometry.dispose());
    this.capsule.geometry.dispose();
  }

  /** In the middle of its parent, from side to side. */
  private part(
    geometry: BufferGeometry,
    material: MeshLambertMaterial,
    y: number,
    z: number,
    parent: Object3D = this.body,
  ): Mesh {
    this.geometries.push(geometry);
    const mesh = new Mesh(geometry, material);
    mesh.position.set(0, y, z);
    parent.add(mesh);
    return mesh;
  }

  /** Hangs from its joint; its end is a shoe or a hand. */
  private limb(
    x: number,
    y: number,
    radius: number,
    length: number,
    cloth: MeshLambertMaterial,
    end: MeshLambertMaterial,
  ): Group {
    const joint = new Group();
    joint.position.set(x, y, 0);
    this.part(new CapsuleGeometry(radius, length, 4, 10), cloth, -length / 2, 0, joint);
    const sphere = new SphereGeometry(radius * 1.02, 10, 8);
    const tip = this.part(sphere, end, -length - radius * 0.75, -radius * 0.5, joint);
    if (y === hip) {
      tip.scale.set(0.95, 0.7, 1.9);
      tip.position.set(0, -hip + radius * 0.7, -radius * 0.7);
    }
    this.body.add(joint);
    return joint;
  }

  /** A soft dark spot under the feet. */
  private shadow(): Mesh {
    const geometry = new CircleGeometry(this.avatar.radius * 1.25, 24).rotateX(-Math.PI / 2);
    const material = new MeshBasicMaterial({
      color: 0x000000,
      transparent: true,
      opacity: 0.28,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -4,
      polygonOffsetUnits: -4,
    });
    this.geometries.push(geometry);
    const mesh = new Mesh(geometry, material);
    mesh.position.y = 0.02;
    return mesh;
  }
}
