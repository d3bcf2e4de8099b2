import { ModelError } from '../common/ModelError.js';

/** A triangle mesh as typed arrays, which a worker can transfer without a copy. */
export interface PlainMesh {
  /** Three components per vertex. */
  positions: Float32Array;
  /** Three components per vertex, or null if the source has none. Zero vectors are computed later. */
  normals: Float32Array | null;
  /** Linear RGB, three components per vertex, or null if the source has none. */
  colors: Float32Array | null;
  /** Three per triangle, or null if every three vertices in order make one. */
  indices: Uint32Array | null;
  /** Two components per vertex; only in meshes with pictures. */
  uvs?: Float32Array;
  /** Contiguous ranges of corners by picture, opacity, sides, shadows, metal and paint; only in meshes where these differ, or with pictures or metal. */
  ranges?: PictureRange[];
  /** Of a mesh without ranges, see `PictureRange`. */
  isOneSided?: boolean;
  castsFronts?: boolean;
  /** The parts of the file that the mesh was joined from; only where there are several. */
  parts?: MeshParts;
}

/** The parts of a file that were joined to one mesh. Triangles of different parts share no vertices. */
export interface MeshParts {
  /** The name of each part, as users see it. */
  names: readonly string[];
  /** The index of the part that each vertex belongs to. */
  ofVertices: Uint32Array;
}

/** Consecutive corners with the same picture, opacity, sides, shadows, metal and paint. */
export interface PictureRange {
  start: number;
  count: number;
  /** The index of the picture, or -1 for none. */
  picture: number;
  /** Whether the range is see-through, as glass is. */
  isSeeThrough?: boolean;
  /** Whether only the fronts of its triangles are drawn, or both sides, as the file says; undefined if it does not say. */
  isOneSided?: boolean;
  /** Whether shadows are cast by the fronts of its triangles, instead of as three.js does it. */
  castsFronts?: boolean;
  /** How much of a room it mirrors, from 0 to 1: smooth metal does. */
  mirrors?: number;
  /** A name for the paint of its materials: those of one colour share it. Undefined where all paints are in one range. */
  paint?: string;
  /** Whether it is of nothing but small parts, of many. */
  isOfSmallParts?: boolean;
}

/** A mesh, with notes for the caption on what was left out. */
export interface NotedMesh {
  mesh: PlainMesh;
  notes: string[];
}

/** The number of triangles in a mesh. */
export function triangleCount(mesh: PlainMesh): number {
  return Math.floor((mesh.indices?.length ?? mesh.positions.length / 3) / 3);
}

/** Whether the back of each triangle is hidden, as far as the file says so; null if it is of none. */
export function oneSided(mesh: PlainMesh): Uint8Array | null {
  const { isOneSided, ranges = [{ start: 0, count: 3 * triangleCount(mesh), isOneSided }] } = mesh;
  const hidden = ranges.filter((range) => range.isOneSided);
  if (hidden.length === 0) return null;
  const sides = new Uint8Array(triangleCount(mesh));
  for (const { start, count } of hidden) sides.fill(1, start / 3, (start + count) / 3);
  return sides;
}

/** The buffers to transfer with a mesh. */
export function meshBuffers(mesh: PlainMesh): ArrayBuffer[] {
  const arrays = [mesh.positions, mesh.normals, mesh.colors, mesh.indices, mesh.uvs, mesh.parts?.ofVertices];
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}

/** The lowest and highest value of each coordinate. Without points, `low` is Infinity and `high` is -Infinity. */
interface Bounds {
  low: [x: number, y: number, z: number];
  high: [x: number, y: number, z: number];
}

/** The bounds of points, given as xyz. */
export function boundsOf(positions: ArrayLike<number>): Bounds {
  const low: Bounds['low'] = [Infinity, Infinity, Infinity];
  const high: Bounds['high'] = [-Infinity, -Infinity, -Infinity];
  for (let axis = 0; axis < 3; axis++) {
    let least = Infinity;
    let largest = -Infinity;
    for (let i = axis; i < positions.length; i += 3) {
      const value = positions[i];
      if (value < least) least = value;
      if (value > largest) largest = value;
    }
    low[axis] = least;
    high[axis] = largest;
  }
  return { low, high };
}

/** Bytes per triangle while a mesh is read: vertices, corners, and the room in which their arrays grow. */
const BYTES_PER_READ_TRIANGLE = 50;
/** The memory that a page can get for one model, besides the copies held while it is read and baked, in bytes. */
const MAX_BYTES = 2 ** 30;
/** Bytes per triangle of a large baked mesh: layout `pull`, with normals, colours and line data. Measured on a million triangles. */
const BYTES_PER_TRIANGLE = 205;
/** Rounded, since messages show it. */
const MAX_TRIANGLES = Math.floor(MAX_BYTES / BYTES_PER_TRIANGLE / 1e5) * 1e5;

/** Whether memory suffices to draw this many triangles. */
export const canDraw = (triangles: number): boolean => triangles <= MAX_TRIANGLES;

const MAX_READ_TRIANGLES = Math.floor(MAX_BYTES / BYTES_PER_READ_TRIANGLE / 1e6) * 1e6;

/** @throws ModelError if there are no triangles, or more than can be read before simplification */
export const checkReadTriangles = (triangles: number): void => checkCount(triangles, MAX_READ_TRIANGLES);

/** @throws ModelError if there are no triangles, or more than can be drawn */
export const checkTriangleCount = (triangles: number): void => checkCount(triangles, MAX_TRIANGLES);

function checkCount(triangles: number, most: number): void {
  if (!(triangles > 0)) {
    throw new ModelError('The file holds no triangles; only surfaces can be hatched, not points or lines.');
  }
  if (triangles > most) {
    throw new ModelError(
      `The model has more than ${most.toLocaleString('en')} triangles, for which a page has no memory.`,
    );
  }
}

/** Whether the total area of triangles is below a limit. Stops early for most meshes. */
function isAreaLess(positions: ArrayLike<number>, indices: ArrayLike<number> | null, least: number): boolean {
  let sum = 0;
  const count = indices?.length ?? positions.length / 3;
  for (let corner = 0; corner + 2 < count && sum < least; corner += 3) {
    const [a, b, c] = [corner, corner + 1, corner + 2].map((at) => 3 * (indices ? indices[at] : at));
    sum += areaOf(positions, a, b, c);
  }
  return sum < least;
}

/** The area of a triangle. @param a offset of the first corner's coordinates, likewise `b` and `c` */
export const areaOf = (positions: ArrayLike<number>, a: number, b: number, c: number): number =>
  setFaceNormal(scratch, positions, a, b, c) / 2;

const scratch = new Float64Array(3);

/**
 * Writes the normal of a triangle, as long as twice its area, and returns that length.
 *
 * @param a offset of the first corner's coordinates, likewise `b` and `c`
 */
export function setFaceNormal(to: Float64Array, positions: ArrayLike<number>, a: number, b: number, c: number): number {
  const ux = positions[b] - positions[a];
  const uy = positions[b + 1] - positions[a + 1];
  const uz = positions[b + 2] - positions[a + 2];
  const vx = positions[c] - positions[a];
  const vy = positions[c + 1] - positions[a + 1];
  const vz = positions[c + 2] - positions[a + 2];
  const x = uy * vz - uz * vy;
  const y = uz * vx - ux * vz;
  const z = ux * vy - uy * vx;
  to[0] = x;
  to[1] = y;
  to[2] = z;
  // Math.hypot takes several times as long.
  return Math.sqrt(x * x + y * y + z * z);
}

/** A model of radius 1 with less surface area than this is thinner than a pixel everywhere. */
const LEAST_AREA = 0.002;

/**
 * A note for a model of radius 1 whose triangles are slivers or dust that strokes cannot show.
 *
 * @param positions xyz of each vertex
 * @param indices three per triangle, or null if every three vertices make one
 * @param share of all triangles that these are
 */
export function thinNote(positions: ArrayLike<number>, indices: ArrayLike<number> | null, share = 1): string[] {
  return isAreaLess(positions, indices, LEAST_AREA * share) ? ['its triangles are too thin to be hatched'] : [];
}

/** Gives normals a length of 1, in place. Those without a direction become zero, and are computed from the surface later. */
export function normalizeNormals(normals: Float32Array): Float32Array {
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    for (let k = i; k < i + 3; k++) normals[k] = length > 0 && length < Infinity ? normals[k] / length : 0;
  }
  return normals;
}
