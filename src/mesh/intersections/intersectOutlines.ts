import {
  DRAWN_WHOLE,
  octahedral,
  POINT_BITS,
  POINT_MASK,
  POINT_WORDS,
  PRIMITIVE_WORDS,
  SEGMENT_POINTS,
  unpackPoints,
} from '../bake/outlineLayout.js';
import { asPhase } from '../phases.js';
import { findIntersections } from './findIntersections.js';
import { LINE_FLOATS } from './joinSegments.js';
import type { IntersectingMesh } from './MeetingMesh.js';

/** The outlines of a mesh, as packed for drawing (`outlineLayout.ts`). */
export interface PackedSurface {
  points: Uint32Array<ArrayBuffer>;
  primitives: Uint32Array<ArrayBuffer>;
  pointCount: number;
  triangleCount: number;
  edgeCount: number;
  /** From the space of the mesh to one that all meshes share, and back, in columns. */
  toShared: readonly number[];
  fromShared: readonly number[];
}

/** What `intersectOutlines` is asked for. Plain data. */
export interface OutlineIntersectionRequest {
  surfaces: PackedSurface[];
  /** The surfaces of each pair, two numbers each; a surface twice for the lines between its shells. */
  pairs: readonly number[];
}

/** The lines of a pair, packed. */
export interface PackedLines {
  /** The number of the pair in the request. */
  pair: number;
  /** `SEGMENT_POINTS` points of `POINT_WORDS` words per segment, in the space of the first mesh; null if it was too much work. */
  points: Uint32Array<ArrayBuffer> | null;
}

/** Finds the lines along which outlined surfaces cut each other. A pair that is not in the result has none. Yields its progress. */
export function* intersectOutlines({
  surfaces,
  pairs,
}: OutlineIntersectionRequest): Generator<number, PackedLines[], void> {
  const meshes: IntersectingMesh[] = [];
  for (const surface of surfaces) {
    meshes.push(unpacked(surface));
    yield 0.1 * (meshes.length / surfaces.length);
  }
  const found = yield* asPhase(findIntersections({ meshes, pairs }), 0.1, 1);
  return found.map(({ pair, lines }) => {
    const { fromShared, toShared } = surfaces[pairs[2 * pair]];
    return { pair, points: lines && packed(lines, fromShared, toShared) };
  });
}

function unpacked({
  points,
  primitives,
  pointCount,
  triangleCount,
  edgeCount,
  toShared,
}: PackedSurface): IntersectingMesh {
  const { positions, normals } = unpackPoints(points, pointCount);
  const triangles = new Uint32Array(3 * triangleCount);
  for (let t = 0; t < triangleCount; t++)
    for (let k = 0; k < 3; k++) triangles[3 * t + k] = primitives[PRIMITIVE_WORDS * t + k] & POINT_MASK;
  const edges: number[] = [];
  for (let edge = triangleCount; edge < triangleCount + edgeCount; edge++) {
    const o = PRIMITIVE_WORDS * edge;
    if ((primitives[o] >>> POINT_BITS) & DRAWN_WHOLE)
      edges.push(primitives[o] & POINT_MASK, primitives[o + 1] & POINT_MASK);
  }
  return { positions, normals, triangles, edges: Uint32Array.from(edges), toShared };
}

/** Numbers of a segment at which the position and the normal of each of its points begin. */
const POINTS = [
  [0, 6],
  [3, 9],
  [0, 12],
  [3, 15],
] as const;

function packed(
  lines: Float64Array,
  toObject: readonly number[],
  toShared: readonly number[],
): Uint32Array<ArrayBuffer> {
  const count = lines.length / LINE_FLOATS;
  const words = new Uint32Array(SEGMENT_POINTS * POINT_WORDS * count);
  const floats = new Float32Array(words.buffer);
  const m = toObject;
  for (let i = 0; i < count; i++) {
    for (const [k, [place, normal]] of POINTS.entries()) {
      const p = LINE_FLOATS * i + place;
      const n = LINE_FLOATS * i + normal;
      const target = POINT_WORDS * (SEGMENT_POINTS * i + k);
      for (let axis = 0; axis < 3; axis++)
        floats[target + axis] =
          m[axis] * lines[p] + m[4 + axis] * lines[p + 1] + m[8 + axis] * lines[p + 2] + m[12 + axis];
      // Normals go back by the transpose of the matrix that goes there, up to their length.
      const [x, y, z] = [0, 4, 8].map(
        (o) => toShared[o] * lines[n] + toShared[o + 1] * lines[n + 1] + toShared[o + 2] * lines[n + 2],
      );
      words[target + 3] = octahedral(x, y, z);
    }
  }
  return words;
}
