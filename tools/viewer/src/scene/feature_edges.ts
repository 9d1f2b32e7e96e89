// The edges of a mesh that one would draw: where its surface folds, and where it ends.

import { BufferGeometry, Float32BufferAttribute, Line3, Vector3, type BufferAttribute, type Mesh } from 'three';

const perMetre = 1e3; // vertices that are nearer than this are one
const seam = 0.02; // metres: surfaces with a gap like this are meant to meet
const sliver = 0.005; // metres: the height of a triangle that is a line
const cell = 1; // metres, of the grid in which edges are looked up

interface Edge {
  line: Line3;
  normal: Vector3; // of the first face
  faces: number;
  folds: boolean;
}

/** The vertices in world space, those that are one as one. */
function welded(mesh: Mesh): { ids: Int32Array; points: Vector3[] } {
  const positions = mesh.geometry.getAttribute('position') as BufferAttribute;
  const known = new Map<string, number>();
  const points: Vector3[] = [];
  const ids = new Int32Array(positions.count);
  for (let i = 0; i < positions.count; i++) {
    const point = new Vector3().fromBufferAttribute(positions, i).applyMatrix4(mesh.matrixWorld);
    const key = [point.x, point.y, point.z].map((value) => Math.round(value * perMetre)).join();
    let id = known.get(key);
    if (id === undefined) {
      id = points.push(point) - 1;
      known.set(key, id);
    }
    ids[i] = id;
  }
  return { ids, points };
}

/** Either side of a face may be its front. */
function differ(one: Vector3, other: Vector3, cosine: number): boolean {
  return Math.abs(one.dot(other)) <= cosine;
}

function edgesOf(mesh: Mesh, cosine: number): Edge[] {
  const { ids, points } = welded(mesh);
  const index = mesh.geometry.getIndex();
  const corners = index?.count ?? ids.length;
  const faces = new Set<string>();
  const edges = new Map<number, Edge>();
  for (let i = 0; i + 2 < corners; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => ids[index ? index.getX(i + k) : i + k]!) as [number, number, number];
    const face = [a, b, c].sort((one, other) => one - other).join();
    if (a === b || b === c || c === a || faces.has(face)) continue;
    faces.add(face); // many surfaces are there twice, once for each side
    const [p, q, r] = [points[a]!, points[b]!, points[c]!];
    const normal = q.clone().sub(p).cross(r.clone().sub(p));
    const longest = Math.max(p.distanceTo(q), q.distanceTo(r), r.distanceTo(p));
    if (normal.length() < sliver * longest) continue; // it faces anywhere
    normal.normalize();
    for (const [from, to] of [[a, b], [b, c], [c, a]] as const) {
      const key = Math.min(from, to) * points.length + Math.max(from, to);
      const edge = edges.get(key);
      if (!edge) edges.set(key, { line: new Line3(points[from], points[to]), normal, faces: 1, folds: false });
      else {
        edge.faces++;
        edge.folds ||= differ(edge.normal, normal, cosine);
      }
    }
  }
  return [...edges.values()];
}

const cellOf = ({ x, y, z }: Vector3): string => [x, y, z].map((value) => Math.floor(value / cell)).join();

/** The cells that an edge passes through, and those beside it at its samples' rounding. */
function cellsOf(line: Line3): Set<string> {
  const steps = Math.ceil((2 * line.distance()) / cell) + 1;
  const cells = new Set<string>();
  const point = new Vector3();
  for (let i = 0; i <= steps; i++) cells.add(cellOf(line.at(i / steps, point)));
  return cells;
}

/** Those at which the surface ends: without those that a neighbour with other vertices continues. */
function rims(open: Edge[], cosine: number): Edge[] {
  const grid = new Map<string, Edge[]>();
  for (const edge of open) {
    for (const key of cellsOf(edge.line)) {
      const known = grid.get(key);
      if (known) known.push(edge);
      else grid.set(key, [edge]);
    }
  }
  const middle = new Vector3();
  const nearest = new Vector3();
  return open.filter((edge) => {
    edge.line.getCenter(middle);
    return !(grid.get(cellOf(middle)) ?? []).some(
      (other) =>
        other !== edge &&
        !differ(edge.normal, other.normal, cosine) &&
        other.line.closestPointToPoint(middle, true, nearest).distanceTo(middle) < seam,
    );
  });
}

/**
 * Line segments in world space. Unlike EdgesGeometry of three.js, it draws no diagonals where surfaces are there once for
 * each side, nor the seams of flat surfaces whose triangles meet without common vertices or are in several meshes; exporters write both.
 * `foldDeg`: the least angle between surfaces that meet.
 */
export function featureEdges(meshes: readonly Mesh[], foldDeg: number): BufferGeometry {
  const cosine = Math.cos((foldDeg * Math.PI) / 180);
  const edges = meshes.flatMap((mesh) => edgesOf(mesh, cosine));
  const open = edges.filter((edge) => edge.faces === 1);
  const drawn = [...edges.filter((edge) => edge.folds), ...rims(open, cosine)];
  const points = drawn.flatMap(({ line }) => [...line.start, ...line.end]);
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
}
