import { computeAreaNormals, doubleArea } from '../computeAreaNormals.js';
import { asPhase } from '../phases.js';
import type { OcclusionMesh, OcclusionScene } from './OcclusionScene.js';

/** Twice the least area of a large triangle in a view of radius 1. */
const LARGE = 0.04;
/** The least cosine between the normal of a flat triangle and those of its corners. */
const FLAT = 0.999;
/** The places within a triangle that stand for a corner: shares of the way from the middle to it. */
const PLACES = [0.55, 0.2];

/**
 * Chooses samples within large flat triangles, which stand for those of their corners: measured at corners alone, a floor would be dark all
 * over if they lie under posts.
 *
 * @param meshes those with normals
 * @param scene with the samples of vertices
 */
export function* samplesWithin(
  meshes: readonly OcclusionMesh[],
  { samplePositions: positions, sampleNormals, sampleOf, backAfter, views }: Omit<OcclusionScene, 'standsFor'>,
): Generator<number, { within: number[]; standsFor: number[] }, void> {
  const within: number[] = [];
  const standsFor: number[] = [];
  for (const [i, mesh] of meshes.entries()) {
    const indices = mesh.indices.map((vertex) => sampleOf[i][vertex]);
    const areaNormals = yield* asPhase(computeAreaNormals({ positions, indices }), 1, 1);
    for (let first = 0; first < indices.length; first += 3) {
      const area = doubleArea(areaNormals, first / 3);
      if (!(area > LARGE * views[0].radius ** 2)) continue;
      const sum = (term: (k: number) => number) => term(0) + term(1) + term(2);
      const corners = indices.subarray(first, first + 3);
      const isFlat = (corner: number) =>
        Math.abs(sum((k) => sampleNormals[3 * corner + k] * areaNormals[first + k])) > FLAT * area;
      if (!corners.every(isFlat)) continue;
      for (const side of new Set([0, backAfter[i]])) {
        for (const corner of corners) {
          for (const share of PLACES) {
            for (let axis = 0; axis < 3; axis++) {
              const at = (sample: number) => positions[3 * (sample + side) + axis];
              within.push(share * at(corner) + ((1 - share) / 3) * sum((k) => at(corners[k])));
            }
            standsFor.push(corner + side);
          }
        }
      }
    }
  }
  return { within, standsFor };
}
