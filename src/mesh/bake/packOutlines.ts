import { TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { chunkPhase } from '../phases.js';
import type { OutlineSurface } from './bakeOutlines.js';
import {
  LOW_FLAGS,
  octahedral,
  POINT_BITS,
  POINT_WORDS,
  PRIMITIVE_WORDS,
  SEARCHED_IN_WORKER,
} from './outlineLayout.js';
import { paddedWords } from './pullLayout.js';

const float = new Float32Array(1);
const word = new Uint32Array(float.buffer);

/** The largest half float. */
const LARGEST = 65504;

/**
 * The 16 bits of the half float nearest to `value`. Values beyond the largest half float are clamped to it; subnormal values
 * and NaN become 0.
 */
export function halfFloat(value: number): number {
  float[0] = Number.isNaN(value) ? 0 : Math.min(Math.max(value, -LARGEST), LARGEST);
  const bits = word[0];
  const sign = (bits >>> 16) & 0x8000;
  // The bias of the exponent changes from 127 to 15. Adding half of the last bit that is kept rounds to the nearest.
  const magnitude = (bits & 0x7fffffff) - ((127 - 15) << 23) + 0x1000;
  return magnitude < 1 << 23 ? sign : sign | (magnitude >>> 13);
}

/** The data that outlines are drawn from (`outlineLayout.ts`). Plain data: the worker posts it back. */
export interface PackedOutlines {
  /** `POINT_WORDS` words per point, padded to whole rows of a texture. */
  points: Uint32Array<ArrayBuffer>;
  /** `PRIMITIVE_WORDS` words per primitive, all triangles before all edges, padded to whole rows. */
  primitives: Uint32Array<ArrayBuffer>;
  /** A copy of `primitives` for a search in the worker, which takes ownership; null if there is none. */
  searched: Uint32Array<ArrayBuffer> | null;
  triangleCount: number;
  edgeCount: number;
  /** x, y, z of each point, for the search for contours. */
  positions: Float32Array<ArrayBuffer>;
  /** x, y, z of each point's unit normal. */
  normals: Float32Array<ArrayBuffer>;
  radius: number;
  /** Whether there are so many parts that outlines may crowd, and `lineSpacings` is to be run. */
  mayCrowd: boolean;
}

/**
 * Packs the surface that outlines are drawn from.
 *
 * @param indices the vertex of each corner in the layout that is baked
 */
export function* packOutlines(
  { fans, normals, curvatures, edges, radius, mesh, mayCrowd }: OutlineSurface,
  indices: Uint32Array,
): Generator<number, PackedOutlines, void> {
  const triangleCount = mesh.indices.length / 3;
  const edgeCount = edges.flags.length;
  const positions = new Float32Array(3 * fans.count);
  const vertices = new Uint32Array(fans.count);
  yield* chunkPhase(mesh.indices.length, 0, 0.3, (start, end) =>
    placeRange(mesh.positions, mesh.indices, indices, fans.ofCorner, positions, vertices, start, end),
  );
  const points = new Uint32Array(paddedWords(fans.count, POINT_WORDS));
  yield* chunkPhase(fans.count, 0.3, 0.8, (start, end) =>
    packPoints(positions, vertices, normals, curvatures, radius, points, start, end),
  );
  const primitives = new Uint32Array(paddedWords(triangleCount + edgeCount, PRIMITIVE_WORDS));
  yield* chunkPhase(triangleCount, 0.8, 1, (start, end) => packTriangles(fans.ofCorner, primitives, start, end));
  const first = PRIMITIVE_WORDS * triangleCount;
  primitives.set(edges.fans, first);
  for (let edge = 0; edge < edgeCount; edge++) {
    const flags = edges.flags[edge];
    primitives[first + PRIMITIVE_WORDS * edge] |= (flags & LOW_FLAGS) << POINT_BITS;
    primitives[first + PRIMITIVE_WORDS * edge + 1] |= (flags >> 4) << POINT_BITS;
  }
  const searched = triangleCount < SEARCHED_IN_WORKER ? null : primitives.slice();
  return { points, primitives, searched, triangleCount, edgeCount, positions, normals, radius, mayCrowd };
}

/** Writes the position and a vertex of the fan of each corner in a range. */
function placeRange(
  meshPositions: Float32Array,
  meshIndices: Uint32Array,
  indices: Uint32Array,
  ofCorner: Uint32Array,
  positions: Float32Array,
  vertices: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const fan = ofCorner[corner];
    const vertex = 3 * meshIndices[corner];
    positions[3 * fan] = meshPositions[vertex];
    positions[3 * fan + 1] = meshPositions[vertex + 1];
    positions[3 * fan + 2] = meshPositions[vertex + 2];
    vertices[fan] = indices[corner];
  }
}

function packPoints(
  positions: Float32Array,
  vertices: Uint32Array,
  normals: Float32Array,
  curvatures: Float32Array,
  radius: number,
  words: Uint32Array,
  start: number,
  end: number,
): void {
  const floats = new Float32Array(words.buffer);
  for (let point = start; point < end; point++) {
    const i = 3 * point;
    const target = POINT_WORDS * point;
    floats[target] = positions[i];
    floats[target + 1] = positions[i + 1];
    floats[target + 2] = positions[i + 2];
    words[target + 3] = octahedral(normals[i], normals[i + 1], normals[i + 2]);
    for (let pair = 0; pair < TENSOR_FLOATS / 2; pair++) {
      const k = TENSOR_FLOATS * point + 2 * pair;
      words[target + 4 + pair] = halfFloat(radius * curvatures[k]) | (halfFloat(radius * curvatures[k + 1]) << 16);
    }
    words[target + 7] = vertices[point];
  }
}

function packTriangles(ofCorner: Uint32Array, words: Uint32Array, start: number, end: number): void {
  for (let triangle = start; triangle < end; triangle++) {
    for (let k = 0; k < 3; k++) words[PRIMITIVE_WORDS * triangle + k] = ofCorner[3 * triangle + k];
  }
}
