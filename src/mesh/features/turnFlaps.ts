import type { Fans } from '../normals/buildFans.js';
import { asPhase, forEachChunk } from '../phases.js';

/** The cosine of 70°, the widest angle allowed between a normal and the mean of those around it. */
const WIDEST = Math.cos((70 * Math.PI) / 180);

/**
 * Replaces, in place, the normals of flaps by the mean of the normals around them. A flap is a fan whose normal contradicts all
 * others in its triangles: scans have triangles that are folded over at one corner. Without this step a contour would run around
 * each of them.
 *
 * @param normals unit normals, three per fan
 */
export function* turnFlaps(normals: Float32Array, { ofCorner, count }: Fans): Generator<number, void, void> {
  const sums = new Float32Array(normals.length);
  yield* asPhase(
    forEachChunk(ofCorner.length / 3, (start, end) => addOthers(normals, ofCorner, sums, start, end)),
    0,
    0.7,
  );
  yield* asPhase(
    forEachChunk(count, (start, end) => turnRange(normals, sums, start, end)),
    0.7,
    1,
  );
}

/** Adds to the sum of each fan the normals of the other two corners, for each triangle in a range. */
function addOthers(normals: Float32Array, ofCorner: Uint32Array, sums: Float32Array, start: number, end: number): void {
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const a = 3 * ofCorner[first];
    const b = 3 * ofCorner[first + 1];
    const c = 3 * ofCorner[first + 2];
    for (let axis = 0; axis < 3; axis++) {
      const na = normals[a + axis];
      const nb = normals[b + axis];
      const nc = normals[c + axis];
      sums[a + axis] += nb + nc;
      sums[b + axis] += nc + na;
      sums[c + axis] += na + nb;
    }
  }
}

function turnRange(normals: Float32Array, sums: Float32Array, start: number, end: number): void {
  for (let i = 3 * start; i < 3 * end; i += 3) {
    const x = sums[i];
    const y = sums[i + 1];
    const z = sums[i + 2];
    const length = Math.sqrt(x * x + y * y + z * z);
    const along = normals[i] * x + normals[i + 1] * y + normals[i + 2] * z;
    if (length === 0 || along > WIDEST * length) continue;
    normals[i] = x / length;
    normals[i + 1] = y / length;
    normals[i + 2] = z / length;
  }
}
