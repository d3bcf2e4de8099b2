import { computeAreaNormals, doubleArea } from '../computeAreaNormals.js';
import { asPhase } from '../phases.js';
import type { OcclusionMesh, OcclusionScene } from './OcclusionScene.js';

/** Twice the least area of a large triangle in a view of radius 1. */
const LARGE = 0.04;
/** The least length of a long triangle in a view of radius 1, and the least times that a slender one is longer than wide. */
const LONG = 0.1;
const SLENDER = 4;
/** The least cosine between the normal of a triangle and those of its corners: of a flat one, and of a slender one. */
const FLAT = 0.999;
const STRAIGHT = 0.9;
/** The places within a large and a long triangle that stand for a corner: shares of the way from the middle to it. */
const WITHIN_LARGE = [0.55, 0.2];
const WITHIN_LONG = [0.4];
/** Long triangles are measured until their samples are as many as those of vertices, or this many. */
const MOST_LONG = 1 << 15;

/** Samples within triangles. */
interface SamplesWithin {
  /** x, y, z of each. */
  within: number[];
  /** For each the number of its stand-in, after those of vertices. */
  standsFor: number[];
  /** For each stand-in the sample of its vertex. */
  standIns: number[];
}

/**
 * Chooses samples within triangles that are large, or long and flat or slender, as stand-ins for their corners. Measured at the corners alone, a
 * floor would be dark all over if they lie in shade, and a rod or a wall whose ends lie in other bodies would be black.
 *
 * @param meshes those with normals
 * @param scene with the samples of vertices
 */
export function* samplesWithin(
  meshes: readonly OcclusionMesh[],
  {
    samplePositions: positions,
    sampleNormals,
    sampleOf,
    backAfter,
    views,
  }: Omit<OcclusionScene, 'standsFor' | 'standIns' | 'sums'>,
): Generator<number, SamplesWithin, void> {
  const [{ radius }] = views;
  const vertices = positions.length / 3;
  const found: SamplesWithin = { within: [], standsFor: [], standIns: [] };
  const ofVertices = new Map<number, number>();
  const standInOf = (vertex: number): number => {
    let standIn = ofVertices.get(vertex);
    if (standIn === undefined) {
      standIn = found.standIns.push(vertex) - 1;
      ofVertices.set(vertex, standIn);
    }
    return vertices + standIn;
  };
  let left = Math.max(vertices, MOST_LONG);
  for (const [i, mesh] of meshes.entries()) {
    const indices = mesh.indices.map((vertex) => sampleOf[i][vertex]);
    const areaNormals = yield* asPhase(computeAreaNormals({ positions, indices }), 1, 1);
    const sides = new Set([0, backAfter[i]]);
    for (let first = 0; first < indices.length; first += 3) {
      const area = doubleArea(areaNormals, first / 3);
      const isLarge = area > LARGE * radius ** 2;
      const length = squaredLength(positions, indices, first);
      if (!isLarge && !(left > 0 && area > 0 && length > (LONG * radius) ** 2)) continue;
      const least = length > SLENDER * area ? STRAIGHT : FLAT;
      const sum = (term: (k: number) => number) => term(0) + term(1) + term(2);
      const corners = indices.subarray(first, first + 3);
      const isAlong = (corner: number) =>
        Math.abs(sum((k) => sampleNormals[3 * corner + k] * areaNormals[first + k])) > least * area;
      if (!corners.every(isAlong)) continue;
      const places = isLarge ? WITHIN_LARGE : WITHIN_LONG;
      for (const side of sides) {
        for (const corner of corners) {
          for (const share of places) {
            for (let axis = 0; axis < 3; axis++) {
              const at = (sample: number) => positions[3 * (sample + side) + axis];
              found.within.push(share * at(corner) + ((1 - share) / 3) * sum((k) => at(corners[k])));
            }
            found.standsFor.push(standInOf(corner + side));
          }
        }
      }
      if (!isLarge) left -= 3 * places.length * sides.size;
    }
  }
  return found;
}

/** The square of the length of the longest edge of a triangle. */
function squaredLength(positions: Float32Array, indices: Uint32Array, first: number): number {
  let longest = 0;
  for (let k = 0; k < 3; k++) {
    const a = 3 * indices[first + k];
    const b = 3 * indices[first + ((k + 1) % 3)];
    const x = positions[b] - positions[a];
    const y = positions[b + 1] - positions[a + 1];
    const z = positions[b + 2] - positions[a + 2];
    longest = Math.max(longest, x * x + y * y + z * z);
  }
  return longest;
}
