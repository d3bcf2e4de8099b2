import { doubleArea } from '../mesh/computeAreaNormals.js';
import { NO_TWIN, nextCorner, triangleOf } from '../mesh/corners.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';

/** The mean length of an edge from which on a mesh may be coarse, as a share of the bounding radius. */
const LONG_EDGE = 0.1;
/** The mean angle between neighbours from which on it is. */
const WIDE_ANGLE = (9 * Math.PI) / 180;

/**
 * Whether a mesh has so few triangles that one sees them on its outline: a sphere of 320, but not one of 1,280. A contour of
 * smooth normals would run well inside of that outline.
 *
 * @param twins with NO_TWIN at sharp edges, which say nothing of how coarse a mesh is
 */
export function isCoarse(
  { positions, indices }: TriangleMesh,
  twins: Int32Array,
  areaNormals: Float64Array,
  radius: number,
): boolean {
  let length = 0;
  let turned = 0;
  let edges = 0;
  for (let corner = 0; corner < indices.length; corner++) {
    const twin = twins[corner];
    if (twin === NO_TWIN || twin < corner) continue;
    const a = 3 * indices[corner];
    const b = 3 * indices[nextCorner(corner)];
    const own = Math.hypot(
      positions[b] - positions[a],
      positions[b + 1] - positions[a + 1],
      positions[b + 2] - positions[a + 2],
    );
    length += own;
    turned += own * angleBetween(areaNormals, triangleOf(corner), triangleOf(twin));
    edges++;
  }
  return length > LONG_EDGE * radius * edges && turned > WIDE_ANGLE * length;
}

function angleBetween(areaNormals: Float64Array, a: number, b: number): number {
  const dot =
    areaNormals[3 * a] * areaNormals[3 * b] +
    areaNormals[3 * a + 1] * areaNormals[3 * b + 1] +
    areaNormals[3 * a + 2] * areaNormals[3 * b + 2];
  return Math.acos(Math.min(1, Math.max(-1, dot / doubleArea(areaNormals, a) / doubleArea(areaNormals, b) || 0)));
}
