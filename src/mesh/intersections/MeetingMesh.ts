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
  /** The shell of each triangle: those that are connected have one. */
  readonly shells: Uint32Array;
  /** Keys of edges that have a line already. */
  private readonly lined = new Set<number>();

  private constructor(
    /** The vertices of triangles that have an area, three each. */
    readonly vertices: Uint32Array,
    /** The points of their corners. */
    readonly points: Uint32Array,
    /** Unit normals of points, in the shared space. */
    readonly normals: Float64Array,
    /** Whole numbers: the position of each vertex, in steps of the grid. */
    readonly places: Float64Array,
    readonly tree: TriangleTree,
    shells: Uint32Array,
  ) {
    this.shells = shells;
  }

  /** Prepares a mesh. Yields its progress. */
  static *of(mesh: IntersectingMesh, grid: Grid): Generator<number, MeetingMesh, void> {
    const { positions, triangles, edges } = mesh;
    const { canonical } = yield* asPhase(weldPositions(positions), 0, 0.2);
    const places = new Float64Array(positions.length);
    const normals = new Float64Array(positions.length);
    const turn = turnOfNormals(mesh.toShared);
    yield* chunkPhase(canonical.length, 0.2, 0.3, (start, end) => {
      placeRange(mesh, grid, places, start, end);
      turnRange(mesh.normals, turn, normals, start, end);
    });
    const kept = new Uint32Array(triangles.length / 3);
    let count = 0;
    yield* chunkPhase(kept.length, 0.3, 0.4, (start, end) => {
      count = keepRange(triangles, canonical, places, kept, count, start, end);
    });
    const vertices = new Uint32Array(3 * count);
    const points = new Uint32Array(3 * count);
    const sets = disjointSets(canonical.length);
    yield* chunkPhase(count, 0.4, 0.5, (start, end) => {
      connectRange(triangles, canonical, kept, vertices, points, sets, start, end);
    });
    const shells = new Uint32Array(count);
    const boxes = new Float64Array(BOX * count);
    yield* chunkPhase(count, 0.5, 0.6, (start, end) => {
      for (let t = start; t < end; t++) shells[t] = rootOf(sets, vertices[3 * t]);
      writeBoxes(vertices, places, boxes, start, end);
    });
    const tree = yield* asPhase(TriangleTree.build(boxes, shells), 0.6, 1);
    const made = new MeetingMesh(vertices, points, normals, places, tree, shells);
    for (let i = 0; i < edges.length; i += 2) made.lined.add(made.keyOf(canonical[edges[i]], canonical[edges[i + 1]]));
    return made;
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
}

function placeRange(
  { positions, toShared }: IntersectingMesh,
  { origin, step }: Grid,
  places: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = 3 * start; i < 3 * end; i += 3)
    for (let axis = 0; axis < 3; axis++)
      places[i + axis] = Math.round((sharedAt(toShared, positions, i, axis) - origin[axis]) / step);
}

/** Keeps the triangles of a range that have an area and finite places. Returns how many are kept so far. */
function keepRange(
  triangles: Uint32Array,
  canonical: Uint32Array,
  places: Float64Array,
  kept: Uint32Array,
  count: number,
  start: number,
  end: number,
): number {
  let next = count;
  for (let t = start; t < end; t++) {
    const a = 3 * canonical[triangles[3 * t]];
    const b = 3 * canonical[triangles[3 * t + 1]];
    const c = 3 * canonical[triangles[3 * t + 2]];
    const ux = places[b] - places[a];
    const uy = places[b + 1] - places[a + 1];
    const uz = places[b + 2] - places[a + 2];
    const vx = places[c] - places[a];
    const vy = places[c + 1] - places[a + 1];
    const vz = places[c + 2] - places[a + 2];
    const area = Math.abs(uy * vz - uz * vy) + Math.abs(uz * vx - ux * vz) + Math.abs(ux * vy - uy * vx);
    if (area > 0 && area < Infinity) kept[next++] = t;
  }
  return next;
}

/** Writes the vertices and points of the triangles that are kept, and joins those that are connected. */
function connectRange(
  triangles: Uint32Array,
  canonical: Uint32Array,
  kept: Uint32Array,
  vertices: Uint32Array,
  points: Uint32Array,
  sets: Uint32Array,
  start: number,
  end: number,
): void {
  for (let t = start; t < end; t++) {
    for (let k = 0; k < 3; k++) {
      points[3 * t + k] = triangles[3 * kept[t] + k];
      vertices[3 * t + k] = canonical[points[3 * t + k]];
    }
    join(sets, vertices[3 * t], vertices[3 * t + 1]);
    join(sets, vertices[3 * t], vertices[3 * t + 2]);
  }
}

function writeBoxes(
  vertices: Uint32Array,
  places: Float64Array,
  boxes: Float64Array,
  start: number,
  end: number,
): void {
  for (let t = start; t < end; t++) {
    const a = 3 * vertices[3 * t];
    const b = 3 * vertices[3 * t + 1];
    const c = 3 * vertices[3 * t + 2];
    for (let axis = 0; axis < 3; axis++) {
      boxes[BOX * t + axis] = Math.min(places[a + axis], places[b + axis], places[c + axis]);
      boxes[BOX * t + 3 + axis] = Math.max(places[a + axis], places[b + axis], places[c + axis]);
    }
  }
}

/** The matrix, in columns, that takes normals to the shared space: the cofactors, turned where a matrix mirrors. */
function turnOfNormals(m: readonly number[]): readonly number[] {
  const column = (k: number) => [m[4 * k], m[4 * k + 1], m[4 * k + 2]] as const;
  const [x, y, z] = [column(0), column(1), column(2)];
  const crossed = (a: readonly number[], b: readonly number[]) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const cofactors = [...crossed(y, z), ...crossed(z, x), ...crossed(x, y)];
  const sign = cofactors[0] * x[0] + cofactors[1] * x[1] + cofactors[2] * x[2] < 0 ? -1 : 1;
  return cofactors.map((value) => sign * value);
}

function turnRange(
  normals: Float32Array,
  turn: readonly number[],
  turned: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = 3 * start; i < 3 * end; i += 3) {
    let square = 0;
    for (let axis = 0; axis < 3; axis++) {
      const value = normals[i] * turn[axis] + normals[i + 1] * turn[3 + axis] + normals[i + 2] * turn[6 + axis];
      turned[i + axis] = value;
      square += value * value;
    }
    const length = Math.sqrt(square) || 1;
    for (let axis = 0; axis < 3; axis++) turned[i + axis] /= length;
  }
}
