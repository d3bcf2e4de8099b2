import { cosineBetween } from '../mesh/computeAreaNormals.js';
import { NO_TWIN, nextCorner, triangleOf } from '../mesh/corners.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import { asPhase } from '../slices/asPhase.js';
import { forEachChunk } from '../slices/forEachChunk.js';

/** The mean length of an edge from which on a mesh may be coarse, as a share of the bounding radius. */
const LONG_EDGE = 0.1;
/** The mean angle between neighbours from which on it is. */
const WIDE_ANGLE = (9 * Math.PI) / 180;

/** Sums over edges. */
interface EdgeSums {
  count: number;
  length: number;
  /** Of the angles between neighbours, times the lengths of their edges. */
  turned: number;
}

/**
 * Whether a mesh has so few triangles that one sees them on its outline: a sphere of 320, but not one of 1,280. A contour of
 * smooth normals would run well inside of that outline.
 *
 * @param twins with NO_TWIN at sharp edges, which say nothing of how coarse a mesh is
 */
export function* isCoarse(
  mesh: TriangleMesh,
  twins: Int32Array,
  areaNormals: Float64Array,
  radius: number,
): Generator<number, boolean, void> {
  const sums: EdgeSums = { count: 0, length: 0, turned: 0 };
  yield* asPhase(
    forEachChunk(twins.length, (start, end) => addRange(mesh, twins, areaNormals, sums, start, end)),
    0,
    1,
  );
  return sums.length > LONG_EDGE * radius * sums.count && sums.turned > WIDE_ANGLE * sums.length;
}

function addRange(
  { positions, indices }: TriangleMesh,
  twins: Int32Array,
  areaNormals: Float64Array,
  sums: EdgeSums,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (twin === NO_TWIN || twin < corner) continue;
    const a = 3 * indices[corner];
    const b = 3 * indices[nextCorner(corner)];
    const x = positions[b] - positions[a];
    const y = positions[b + 1] - positions[a + 1];
    const z = positions[b + 2] - positions[a + 2];
    const length = Math.sqrt(x * x + y * y + z * z);
    const cosine = cosineBetween(areaNormals, triangleOf(corner), triangleOf(twin)) || 0;
    sums.count++;
    sums.length += length;
    sums.turned += length * Math.acos(Math.min(1, Math.max(-1, cosine)));
  }
}
