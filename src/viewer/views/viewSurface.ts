import { boundsOf, type MeshParts, setFaceNormal } from '../files/mesh/PlainMesh.js';
import type { UpAxis } from '../files/mesh/UpAxis.js';
import { type Landmark, landmarksOf } from './landmarks.js';

/** Triangles in any pose and size. */
export interface ViewTriangles {
  /** xyz of each vertex. */
  positions: ArrayLike<number>;
  /** Three per triangle, or null if every three vertices make one. */
  indices: ArrayLike<number> | null;
  /** Whether the back of each triangle is not drawn; null if both sides of all are. */
  isSingleSided: Uint8Array | null;
  /** The parts that the triangles belong to, if there are several with names. */
  parts?: NamedPoints | undefined;
}

/** Points on parts that have names. */
export interface NamedPoints extends MeshParts {
  /** xyz of each point; the vertices of the triangles where it is missing. */
  points?: ArrayLike<number>;
}

/** A surface that stands upright, in the unit sphere, with few enough triangles to be looked at from many sides. */
export interface ViewSurface {
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array;
  /** The unit normal of each triangle. */
  normals: Float32Array;
  /** The area of each triangle, and of all. */
  areas: Float32Array;
  area: number;
  isSingleSided: Uint8Array | null;
  /** Half the height, and half the larger horizontal extent. */
  halfHeight: number;
  halfWidth: number;
  /** Parts whose names say whether they are in front. */
  landmarks: readonly Landmark[];
}

/** Surfaces with more triangles are made coarser. */
const MANY = 30_000;
/** Grid cells along the radius of a surface that is made coarser. */
const CELLS = 36;

/** The rows of the matrices that turn an axis upwards, as the page does. */
const UPRIGHT: Readonly<Record<UpAxis, readonly [sign: number, axis: 0 | 1 | 2][]>> = {
  y: [
    [1, 0],
    [1, 1],
    [1, 2],
  ],
  z: [
    [1, 0],
    [1, 2],
    [-1, 1],
  ],
  x: [
    [-1, 1],
    [1, 0],
    [1, 2],
  ],
  '-y': [
    [-1, 0],
    [-1, 1],
    [1, 2],
  ],
  '-z': [
    [1, 0],
    [-1, 2],
    [1, 1],
  ],
  '-x': [
    [1, 1],
    [-1, 0],
    [1, 2],
  ],
};

/** Turns triangles upright, fits them into the unit sphere, and merges vertices of large ones that are close together. */
export function viewSurface({ positions, indices, isSingleSided, parts }: ViewTriangles, up: UpAxis): ViewSurface {
  const asFitted = fitting(positions, UPRIGHT[up]);
  const upright = asFitted(positions);
  const count = Math.floor((indices?.length ?? positions.length / 3) / 3);
  const corners = new Uint32Array(3 * count);
  for (let corner = 0; corner < corners.length; corner++) corners[corner] = indices ? indices[corner] : corner;
  const { points, joined } = count > MANY ? clustered(upright, corners) : { points: upright, joined: corners };
  return { ...measured(points, joined, isSingleSided), landmarks: landmarksIn(parts, upright, asFitted) };
}

type Fit = (points: ArrayLike<number>) => Float32Array<ArrayBuffer>;

function landmarksIn(parts: NamedPoints | undefined, upright: Float32Array, asFitted: Fit): Landmark[] {
  if (!parts) return [];
  return landmarksOf(parts.points ? asFitted(parts.points) : upright, parts);
}

/** The function that turns points upright, and moves and scales them as these positions have to be to lie in the unit sphere. */
function fitting(positions: ArrayLike<number>, rows: readonly (readonly [number, number])[]): Fit {
  const { low, high } = boundsOf(positions);
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  const radius = farthest(positions, middle[0], middle[1], middle[2]);
  const scale = radius > 0 ? 1 / radius : 1;
  return (points) => {
    const fitted = new Float32Array(points.length);
    for (const [k, [sign, axis]] of rows.entries()) {
      copyAxis(fitted, k, points, axis, sign * scale, -sign * scale * middle[axis]);
    }
    return fitted;
  };
}

/** The largest distance of points from a place. */
function farthest(points: ArrayLike<number>, x: number, y: number, z: number): number {
  let square = 0;
  for (let i = 0; i < points.length; i += 3) {
    const dx = points[i] - x;
    const dy = points[i + 1] - y;
    const dz = points[i + 2] - z;
    const here = dx * dx + dy * dy + dz * dz;
    if (here > square) square = here;
  }
  return Math.sqrt(square);
}

/** Copies one coordinate of each point to another, scaled and moved. */
function copyAxis(
  to: Float32Array,
  k: number,
  from: ArrayLike<number>,
  axis: number,
  scale: number,
  offset: number,
): void {
  for (let i = 0; i < from.length; i += 3) to[i + k] = scale * from[i + axis] + offset;
}

/** Merges the vertices in each cell of a grid. Triangles that lose a corner stay, without area. */
function clustered(
  positions: Float32Array,
  corners: Uint32Array,
): { points: Float32Array<ArrayBuffer>; joined: Uint32Array } {
  const side = 2 * CELLS + 2;
  const numbers = new Int32Array(side ** 3);
  const clusterOf = new Uint32Array(positions.length / 3);
  let count = 0;
  for (let vertex = 0, i = 0; vertex < clusterOf.length; vertex++, i += 3) {
    const x = ((positions[i] + 1) * CELLS + 0.5) | 0;
    const y = ((positions[i + 1] + 1) * CELLS + 0.5) | 0;
    const z = ((positions[i + 2] + 1) * CELLS + 0.5) | 0;
    const cell = (z * side + y) * side + x;
    if (numbers[cell] === 0) numbers[cell] = ++count;
    clusterOf[vertex] = numbers[cell] - 1;
  }
  const sizes = new Uint32Array(count);
  const sums = new Float64Array(3 * count);
  for (let vertex = 0, i = 0; vertex < clusterOf.length; vertex++, i += 3) {
    const cluster = clusterOf[vertex];
    sizes[cluster]++;
    for (let k = 0; k < 3; k++) sums[3 * cluster + k] += positions[i + k];
  }
  const points = new Float32Array(3 * count);
  for (let i = 0; i < points.length; i++) points[i] = sums[i] / sizes[Math.floor(i / 3)];
  return { points, joined: corners.map((vertex) => clusterOf[vertex]) };
}

function measured(
  positions: Float32Array<ArrayBuffer>,
  corners: Uint32Array,
  isSingleSided: Uint8Array | null,
): Omit<ViewSurface, 'landmarks'> {
  const count = corners.length / 3;
  const indices = new Uint32Array(corners.length);
  const normals = new Float32Array(corners.length);
  const areas = new Float32Array(count);
  const sides = isSingleSided && new Uint8Array(count);
  const face = new Float64Array(3);
  let kept = 0;
  let area = 0;
  for (let triangle = 0; triangle < count; triangle++) {
    const a = 3 * corners[3 * triangle];
    const b = 3 * corners[3 * triangle + 1];
    const c = 3 * corners[3 * triangle + 2];
    const twice = setFaceNormal(face, positions, a, b, c);
    if (!(twice > 1e-12)) continue;
    for (let k = 0; k < 3; k++) {
      indices[3 * kept + k] = corners[3 * triangle + k];
      normals[3 * kept + k] = face[k] / twice;
    }
    areas[kept] = twice / 2;
    if (sides && isSingleSided) sides[kept] = isSingleSided[triangle];
    area += twice / 2;
    kept++;
  }
  const { low, high } = boundsOf(positions);
  const half = high.map((value, axis) => Math.max(value, -low[axis]));
  return {
    positions,
    indices: indices.slice(0, 3 * kept),
    normals: normals.slice(0, 3 * kept),
    areas: areas.slice(0, kept),
    area,
    isSingleSided: sides?.slice(0, kept) ?? null,
    halfHeight: half[1],
    halfWidth: Math.max(half[0], half[2]),
  };
}
