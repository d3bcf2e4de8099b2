import { cosineBetween } from '../computeAreaNormals.js';
import { nextCorner, triangleOf } from '../corners.js';
import { chunkPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/** Least mean length of the edges of a coarse mesh, as a share of the bounding radius. */
const LONG_EDGE = 0.1;
/** Least mean angle between neighbouring triangles of a coarse mesh, in radians. */
const WIDE_ANGLE = (9 * Math.PI) / 180;

/**
 * Whether the triangles of a mesh show in its outline, as in a sphere of 320 triangles, but not of 1,280. A contour from smooth normals
 * would run well inside that outline.
 *
 * @param twins twins with NO_TWIN at sharp edges and where windings contradict each other; such edges do not count
 */
export function* isCoarse(
  mesh: TriangleMesh,
  twins: Int32Array,
  areaNormals: Float64Array,
  radius: number,
): Generator<number, boolean, void> {
  const sums: EdgeSums = { count: 0, length: 0, turned: 0 };
  yield* chunkPhase(twins.length, 0, 0.5, (start, end) => addLengths(mesh, twins, sums, start, end));
  // Angles are not measured on meshes with short edges, which most are.
  if (!(sums.length > LONG_EDGE * radius * sums.count)) return false;
  yield* chunkPhase(twins.length, 0.5, 1, (start, end) => addAngles(mesh, twins, areaNormals, sums, start, end));
  return sums.turned > WIDE_ANGLE * sums.length;
}

/** Sums over all edges that have twins. */
interface EdgeSums {
  count: number;
  length: number;
  /** The sum of the angles between neighbours, each times the length of the edge. */
  turned: number;
}

function addLengths(mesh: TriangleMesh, twins: Int32Array, sums: EdgeSums, start: number, end: number): void {
  let { count, length } = sums;
  for (let corner = start; corner < end; corner++) {
    if (!(twins[corner] > corner)) continue;
    count++;
    length += lengthOf(mesh, corner);
  }
  sums.count = count;
  sums.length = length;
}

function addAngles(
  mesh: TriangleMesh,
  twins: Int32Array,
  areaNormals: Float64Array,
  sums: EdgeSums,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    if (!(twin > corner)) continue;
    const cosine = cosineBetween(areaNormals, triangleOf(corner), triangleOf(twin)) || 0;
    sums.turned += lengthOf(mesh, corner) * Math.acos(Math.min(1, Math.max(-1, cosine)));
  }
}

/** The length of the edge that starts at `corner`. */
function lengthOf({ positions, indices }: TriangleMesh, corner: number): number {
  const a = 3 * indices[corner];
  const b = 3 * indices[nextCorner(corner)];
  const x = positions[b] - positions[a];
  const y = positions[b + 1] - positions[a + 1];
  const z = positions[b + 2] - positions[a + 2];
  return Math.sqrt(x * x + y * y + z * z);
}
