// The campus in 3D: its geometry, or boxes of its objects where the report has none.

import {
  Box3,
  BoxGeometry,
  Color,
  DoubleSide,
  FrontSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Plane,
  Vector3,
  type BufferGeometry,
  type Material,
  type MeshStandardMaterial,
  type Object3D,
} from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/examples/jsm/libs/meshopt_decoder.module.js';
import type { CampusEntry } from '../format';
import { featureEdges } from './feature_edges';
import { ImagePlugin } from './image_plugin';

const mostWithEdges = 150_000; // triangles

/** A piece of the geometry, and which objects it belongs to. */
export interface Piece {
  mesh: Mesh;
  objects: number[];
  /** Name of the node in the model. */
  node: string;
  material: Material;
  bounds: Box3;
}

export class CampusModel {
  readonly root = new Group();
  readonly pieces: Piece[] = [];
  readonly bounds = new Box3();
  private readonly cutPlane = new Plane(new Vector3(0, -1, 0), 0);
  private readonly materials = new Set<Material>();

  constructor(readonly campus: CampusEntry) {
    this.root.name = campus.name;
  }

  static async load(campus: CampusEntry, glb: Uint8Array<ArrayBuffer> | null): Promise<CampusModel> {
    const model = new CampusModel(campus);
    if (glb) await model.addGeometry(glb);
    else model.addBoxes();
    if (model.isPlain()) model.addEdges();
    if (model.bounds.isEmpty()) model.bounds.set(new Vector3(...campus.min), new Vector3(...campus.max));
    return model;
  }

  piecesOf(object: number): Piece[] {
    return this.pieces.filter((piece) => piece.objects.includes(object));
  }

  /** Hides what is above a height; null shows all. */
  cut(height: number | null): void {
    const planes = height === null ? null : [this.cutPlane];
    if (height !== null) this.cutPlane.constant = height;
    for (const material of this.materials) {
      if ((material.clippingPlanes === null) !== (planes === null)) material.needsUpdate = true;
      material.clippingPlanes = planes;
    }
  }

  get cutHeight(): number | null {
    const [first] = this.materials;
    return first?.clippingPlanes ? this.cutPlane.constant : null;
  }

  /** Materials that stand in for those of the campus are cut like them. */
  adopt(material: Material): void {
    material.clippingPlanes = this.cutHeight === null ? null : [this.cutPlane];
    this.materials.add(material);
  }

  private async addGeometry(glb: Uint8Array<ArrayBuffer>): Promise<void> {
    const loader = new GLTFLoader();
    loader.setMeshoptDecoder(MeshoptDecoder);
    loader.register((parser) => new ImagePlugin(parser));
    const gltf = await loader.parseAsync(glb.buffer, '');
    gltf.scene.updateMatrixWorld(true);
    const plain = new Map<Material, Material>();
    gltf.scene.traverse((node) => {
      if (!(node instanceof Mesh)) return;
      const mesh = node as Mesh<BufferGeometry, Material>;
      const material = plain.get(mesh.material) ?? matte(mesh.material);
      plain.set(mesh.material, material);
      const { objects, name } = extrasOf(mesh);
      this.add(mesh, material, objects, name);
    });
    this.root.add(gltf.scene);
  }

  /** Whether next to nothing has a texture: surfaces of one colour can't be told apart where they join. */
  private isPlain(): boolean {
    let textured = 0;
    let all = 0;
    for (const { mesh, material } of this.pieces) {
      const count = trianglesOf(mesh);
      all += count;
      if ((material as MeshLambertMaterial).map && mesh.geometry.hasAttribute('uv')) textured += count;
    }
    return textured < 0.1 * all && all < mostWithEdges;
  }

  private addEdges(): void {
    const material = new LineBasicMaterial({ color: 0x1d2630, transparent: true, opacity: 0.42 });
    // Surfaces a little farther away than their edges.
    for (const surface of this.materials)
      Object.assign(surface, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.materials.add(material);
    const meshes = this.pieces.map(({ mesh }) => mesh);
    const edges = new LineSegments(featureEdges(meshes, 28), material);
    edges.renderOrder = 2;
    this.root.add(edges);
  }

  private addBoxes(): void {
    const solid = new MeshLambertMaterial({ color: 0xb9c0c8 });
    // A mesh isn't where its bounds are: one looks into them.
    const hollow = new MeshLambertMaterial({ color: 0xb9c0c8, transparent: true, opacity: 0.3, depthWrite: false });
    const ground = new MeshLambertMaterial({ color: 0x9fa890 });
    this.campus.objects.forEach((object, index) => {
      if (!object.modes.includes('solid')) return;
      const size = new Vector3(...object.max).sub(new Vector3(...object.min)).max(new Vector3(0.02, 0.02, 0.02));
      const mesh = new Mesh(new BoxGeometry(size.x, size.y, size.z));
      mesh.position.fromArray(object.min).addScaledVector(size, 0.5);
      const isGround = size.x > 60 && size.z > 60;
      if (isGround) {
        // The visitor walks in it, not on its box.
        mesh.scale.y = 0.01;
        mesh.position.y = object.min[1];
      }
      mesh.updateMatrixWorld(true);
      this.add(mesh, isGround ? ground : object.shape === 'mesh' ? hollow : solid, [index], object.id);
      this.root.add(mesh);
    });
  }

  private add(mesh: Mesh, material: Material, objects: number[], node: string): void {
    mesh.material = material;
    mesh.castShadow = !material.transparent;
    mesh.receiveShadow = true;
    mesh.matrixAutoUpdate = false;
    this.materials.add(material);
    const bounds = new Box3().setFromObject(mesh);
    this.bounds.union(bounds);
    this.pieces.push({ mesh, objects, node, material, bounds });
  }
}

function trianglesOf(mesh: Mesh): number {
  const { geometry } = mesh;
  return (geometry.getIndex()?.count ?? geometry.getAttribute('position').count) / 3;
}

/** A node's extras are the mesh's, or of the group that holds its parts. */
function extrasOf(mesh: Object3D): { objects: number[]; name: string } {
  for (let node: Object3D | null = mesh; node; node = node.parent) {
    const objects: unknown = node.userData.objects;
    if (Array.isArray(objects)) {
      const name: unknown = node.userData.node;
      return { objects: objects.filter((each) => typeof each === 'number'), name: String(name ?? node.name) };
    }
  }
  return { objects: [], name: mesh.name };
}

/** Without reflections, which nothing here would be reflected in, and fast where a processor draws. */
function matte(material: Material): Material {
  const source = material as MeshStandardMaterial;
  const common = {
    name: source.name,
    color: source.color ?? new Color(1, 1, 1),
    map: source.map ?? null,
    vertexColors: source.vertexColors,
    transparent: source.transparent,
    opacity: source.opacity,
    alphaTest: source.alphaTest,
    depthWrite: source.depthWrite,
    side: source.side === DoubleSide ? DoubleSide : FrontSide,
  };
  if (material instanceof MeshBasicMaterial) return new MeshBasicMaterial(common);
  return new MeshLambertMaterial({
    ...common,
    emissive: source.emissive ?? 0,
    emissiveMap: source.emissiveMap ?? null,
    emissiveIntensity: source.emissiveIntensity ?? 1,
  });
}
