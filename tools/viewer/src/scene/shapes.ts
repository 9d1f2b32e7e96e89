// Colliders' shapes as geometry: trigger volumes, and outlines of what is in the way.

import {
  BoxGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
  type BufferGeometry,
} from 'three';
import type { CampusObject } from '../format';

/** In the world. A mesh has only its bounds. */
export function geometryOf(object: CampusObject): BufferGeometry {
  const center = object.center ? new Vector3(...object.center) : middleOf(object);
  const radius = object.radius ?? 0.5;
  let geometry: BufferGeometry;
  switch (object.shape) {
    case 'sphere':
      geometry = new SphereGeometry(radius, 24, 14);
      break;
    case 'capsule':
      geometry = new CapsuleGeometry(radius, Math.max(0.001, (object.height ?? 1) - 2 * radius), 6, 20);
      break;
    case 'wheel':
      geometry = new CylinderGeometry(radius, radius, object.width ?? 1, 40).rotateZ(Math.PI / 2);
      break;
    case 'box':
      geometry = new BoxGeometry(...(object.size ?? sizeOf(object)));
      break;
    case 'mesh':
      geometry = new BoxGeometry(...sizeOf(object));
      return geometry.translate(...middleOf(object).toArray());
  }
  return geometry.applyMatrix4(axesOf(object).setPosition(center));
}

/** Whether a point is in an object's volume, or no farther from it than `slack`. Of a mesh: in its bounds. */
export function contains(object: CampusObject, point: Vector3, slack = 0): boolean {
  const inBounds = point
    .toArray()
    .every((value, i) => value >= object.min[i]! - slack && value <= object.max[i]! + slack);
  if (!inBounds || !object.center) return inBounds;
  const [x, y, z] = point
    .clone()
    .sub(new Vector3(...object.center))
    .applyMatrix4(axesOf(object).transpose())
    .toArray();
  const radius = (object.radius ?? 0) + slack;
  switch (object.shape) {
    case 'box':
      return [x, y, z].every((value, i) => Math.abs(value) <= (object.size?.[i] ?? 0) / 2 + slack);
    case 'sphere':
      return Math.hypot(x, y, z) <= radius;
    case 'capsule':
      return Math.hypot(x, Math.max(0, Math.abs(y) - (object.height ?? 0) / 2 + (object.radius ?? 0)), z) <= radius;
    case 'wheel':
      return Math.abs(x) <= (object.width ?? 0) / 2 + slack && Math.hypot(y, z) <= radius;
    case 'mesh':
      return true;
  }
}

type Faces = Mesh<BufferGeometry, MeshBasicMaterial>;
type Edges = LineSegments<BufferGeometry, LineBasicMaterial>;

/** Translucent, and not dimmed by the fog. */
export function facesOf(geometry: BufferGeometry, color: number, opacity: number, renderOrder = 0): Faces {
  const material = new MeshBasicMaterial({ color, transparent: true, opacity, depthWrite: false, fog: false });
  return Object.assign(new Mesh(geometry, material), { renderOrder });
}

/** Where faces meet at more than an angle, in degrees. */
export function edgesOf(geometry: BufferGeometry, color: number, opacity: number, angle = 1, renderOrder = 0): Edges {
  const material = new LineBasicMaterial({ color, transparent: true, opacity, fog: false });
  return Object.assign(new LineSegments(new EdgesGeometry(geometry, angle), material), { renderOrder });
}

/** Translucent, with its edges; brighter while the visitor is inside. */
export class Volume {
  readonly root = new Group();
  private readonly faces: MeshBasicMaterial;
  private readonly edges: LineBasicMaterial;

  constructor(
    readonly object: CampusObject,
    private readonly color: number,
  ) {
    const geometry = geometryOf(object);
    const faces = facesOf(geometry, color, 0.08, 5);
    const edges = edgesOf(geometry, color, 0.5, 30, 6);
    this.faces = faces.material;
    this.edges = edges.material;
    this.root.add(faces, edges);
  }

  setActive(active: boolean): void {
    this.faces.opacity = active ? 0.24 : 0.07;
    this.edges.opacity = active ? 1 : 0.45;
    this.faces.color.set(active ? 0xffc53d : this.color);
    this.edges.color.set(active ? 0xffb000 : this.color);
  }
}

function middleOf(object: CampusObject): Vector3 {
  return new Vector3(...object.min).add(new Vector3(...object.max)).multiplyScalar(0.5);
}

function sizeOf(object: CampusObject): [number, number, number] {
  const size = new Vector3(...object.max).sub(new Vector3(...object.min));
  return [Math.max(size.x, 0.01), Math.max(size.y, 0.01), Math.max(size.z, 0.01)];
}

function axesOf(object: CampusObject): Matrix4 {
  const [ax, ay, az, bx, by, bz, cx, cy, cz] = object.axes?.length === 9 ? object.axes : [1, 0, 0, 0, 1, 0, 0, 0, 1];
  return new Matrix4().makeBasis(new Vector3(ax, ay, az), new Vector3(bx, by, bz), new Vector3(cx, cy, cz));
}
