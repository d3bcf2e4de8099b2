import { disjointSets, join, rootOf } from '../disjointSets.js';
import { asPhase, chunkPhase } from '../phases.js';
import { weldPositions } from '../weldPositions.js';
import { BOX, TriangleTree } from './TriangleTree.js';

/** A mesh whose lines of intersection are looked for. */
export interface IntersectingMesh {
  /** Points, one for each normal at a vertex: position and unit normal, three numbers each. */
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer>;
  /** Points of the triangles. */
  triangles: Uint32Array<ArrayBuffer>;
  /** Points at the ends of edges that have a line already. */
  edges: Uint32Array<ArrayBuffer>;
  /** From the space of the mesh to one that all meshes share, in columns. */
  toShared: readonly number[];
}

/** Steps of the grid that all positions are rounded to, so that signs of orientation are exact: 2^40 in the box of the scene. */
const GRID = 2 ** 40;

/** The grid of a scene. */
export interface Grid {
  origin: readonly [number, number, number];
  /** Shared units per step. */
  step: number;
}

/** The grid over the boxes of meshes; six numbers each. */
export function gridOver(boxes: readonly Float64Array[]): Grid {
  const low = [0, 1, 2].map((axis) => boxes.reduce((least, box) => Math.min(least, box[axis]), Infinity));
  const high = [0, 1, 2].map((axis) => boxes.reduce((most, box) => Math.max(most, box[axis + 3]), -Infinity));
  const size = Math.max(...high.map((value, axis) => value - low[axis]));
  return { origin: [low[0], low[1], low[2]], step: size > 0 ? size / GRID : 1 };
}

/** The box of the finite positions of a mesh in the shared space; none of a mesh without. */
export function boxOf({ positions, toShared }: IntersectingMesh): Float64Array | null {
  const box = Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
  for (let i = 0; i < positions.length; i += 3) {
    for (let axis = 0; axis < 3; axis++) {
      const value = sharedAt(toShared, positions, i, axis);
      if (!Number.isFinite(value)) continue;
      box[axis] = Math.min(box[axis], value);
      box[axis + 3] = Math.max(box[axis + 3], value);
    }
  }
  return box[0] <= box[3] && box[1] <= box[4] && box[2] <= box[5] ? box : null;
}

const sharedAt = (m: readonly number[], p: ArrayLike<number>, i: number, axis: number): number =>
  m[axis] * p[i] + m[4 + axis] * p[i + 1] + m[8 + axis] * p[i + 2] + m[12 + axis];

/** A mesh on the grid of its scene, prepared for being cut by others. */
export class MeetingMesh {
  /** The vertices of triangles that have an area, three each. */
  readonly vertices: Uint32Array;
  /** The points of their corners. */
  readonly points: Uint32Array;
  /** Unit normals of points, in the shared space. */
  readonly normals: Float64Array;
  /** Whole numbers: the position of each vertex, in steps of the grid. */
  readonly places: Float64Array;
  /** The shell of each triangle: those that are connected have one. */
  readonly shells: Uint32Array;
  readonly tree!: TriangleTree;
  /** Keys of edges that have a line already. */
  private readonly lined = new Set<number>();
  private readonly edgeNumbers = new Map<number, number>();

  private constructor(mesh: IntersectingMesh, grid: Grid, canonical: Uint32Array) {
    const { positions, toShared } = mesh;
    this.places = new Float64Array(positions.length);
    for (let i = 0; i < positions.length; i += 3)
      for (let axis = 0; axis < 3; axis++)
        this.places[i + axis] = Math.round((sharedAt(toShared, positions, i, axis) - grid.origin[axis]) / grid.step);
    this.normals = sharedNormals(mesh);
    const kept = solidTriangles(mesh.triangles, canonical, this.places);
    this.vertices = kept.map((corner) => canonical[mesh.triangles[corner]]);
    this.points = kept.map((corner) => mesh.triangles[corner]);
    const sets = disjointSets(canonical.length);
    for (let i = 0; i < this.vertices.length; i += 3) {
      join(sets, this.vertices[i], this.vertices[i + 1]);
      join(sets, this.vertices[i], this.vertices[i + 2]);
    }
    this.shells = new Uint32Array(this.vertices.length / 3);
    for (let t = 0; t < this.shells.length; t++) this.shells[t] = rootOf(sets, this.vertices[3 * t]);
    for (let i = 0; i < mesh.edges.length; i += 2)
      this.lined.add(this.keyOf(canonical[mesh.edges[i]], canonical[mesh.edges[i + 1]]));
  }

  /** Prepares a mesh. Yields its progress. */
  static *of(mesh: IntersectingMesh, grid: Grid): Generator<number, MeetingMesh, void> {
    const { canonical } = yield* asPhase(weldPositions(mesh.positions), 0, 0.2);
    const made = new MeetingMesh(mesh, grid, canonical);
    yield 0.4;
    const boxes = new Float64Array(BOX * made.shells.length);
    yield* chunkPhase(made.shells.length, 0.4, 0.5, (start, end) => {
      writeBoxes(made.vertices, made.places, boxes, start, end);
    });
    return Object.assign(made, { tree: yield* asPhase(TriangleTree.build(boxes, made.shells), 0.5, 1) });
  }

  private keyOf(a: number, b: number): number {
    const vertexCount = this.places.length / 3;
    return a < b ? a * vertexCount + b : b * vertexCount + a;
  }

  /** Whether an edge of a triangle, from its corner k to the next, has a line already. */
  hasLine(triangle: number, k: number): boolean {
    const { vertices, lined } = this;
    if (lined.size === 0) return false;
    return lined.has(this.keyOf(vertices[3 * triangle + k], vertices[3 * triangle + ((k + 1) % 3)]));
  }

  /** The number of the edge between two vertices, counted from 0 in the order in which they are asked for. */
  edgeNumber(a: number, b: number): number {
    const { edgeNumbers } = this;
    const key = this.keyOf(a, b);
    const known = edgeNumbers.get(key);
    if (known !== undefined) return known;
    edgeNumbers.set(key, edgeNumbers.size);
    return edgeNumbers.size - 1;
  }
}

/** The corners of triangles that have an area and finite places. */
function solidTriangles(triangles: Uint32Array, canonical: Uint32Array, places: Float64Array): Uint32Array {
  const kept: number[] = [];
  for (let corner = 0; corner + 2 < triangles.length; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * canonical[triangles[corner + k]]);
    const [ux, uy, uz] = [0, 1, 2].map((axis) => places[b + axis] - places[a + axis]);
    const [vx, vy, vz] = [0, 1, 2].map((axis) => places[c + axis] - places[a + axis]);
    const area = Math.abs(uy * vz - uz * vy) + Math.abs(uz * vx - ux * vz) + Math.abs(ux * vy - uy * vx);
    if (area > 0 && area < Infinity) kept.push(corner, corner + 1, corner + 2);
  }
  return Uint32Array.from(kept);
}

function writeBoxes(
  vertices: Uint32Array,
  places: Float64Array,
  boxes: Float64Array,
  start: number,
  end: number,
): void {
  for (let t = start; t < end; t++) {
    const [a, b, c] = [3 * vertices[3 * t], 3 * vertices[3 * t + 1], 3 * vertices[3 * t + 2]];
    for (let axis = 0; axis < 3; axis++) {
      boxes[BOX * t + axis] = Math.min(places[a + axis], places[b + axis], places[c + axis]);
      boxes[BOX * t + 3 + axis] = Math.max(places[a + axis], places[b + axis], places[c + axis]);
    }
  }
}

/** The unit normals of points in the shared space: by the cofactors of the matrix, turned where it mirrors. */
function sharedNormals({ normals, toShared: m }: IntersectingMesh): Float64Array {
  const column = (k: number) => [m[4 * k], m[4 * k + 1], m[4 * k + 2]] as const;
  const [x, y, z] = [column(0), column(1), column(2)];
  const crossed = (a: readonly number[], b: readonly number[]) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const [yz, zx, xy] = [crossed(y, z), crossed(z, x), crossed(x, y)];
  const sign = yz[0] * x[0] + yz[1] * x[1] + yz[2] * x[2] < 0 ? -1 : 1;
  const turned = new Float64Array(normals.length);
  for (let i = 0; i < normals.length; i += 3) {
    for (let axis = 0; axis < 3; axis++)
      turned[i + axis] = sign * (normals[i] * yz[axis] + normals[i + 1] * zx[axis] + normals[i + 2] * xy[axis]);
    const length = Math.hypot(turned[i], turned[i + 1], turned[i + 2]) || 1;
    for (let axis = 0; axis < 3; axis++) turned[i + axis] /= length;
  }
  return turned;
}
