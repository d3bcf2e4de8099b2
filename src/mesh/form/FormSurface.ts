import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { triangleOf } from '../corners.js';
import { fanCurvatures } from '../features/fanCurvatures.js';
import { assembleHeatEquation, type FanSurface, type HeatEquation } from '../normals/assembleHeatEquation.js';
import { buildFans, type Fans } from '../normals/buildFans.js';
import { fanDirections } from '../normals/fanNormals.js';
import { meanNormals } from '../normals/meanNormals.js';
import { fansInOrder } from '../normals/sortFans.js';
import { asPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import type { FormOptions } from './FormField.js';
import { findParts, type Parts } from './findParts.js';
import { formTwins } from './formTwins.js';
import { strokeNormals } from './strokeNormals.js';

/** The surface on which a form field is computed. Creases are borders: lines on one side do not depend on the other. */
export interface FormSurface {
  mesh: TriangleMesh;
  /** Twins with NO_TWIN at borders, at creases and where windings contradict each other. */
  twins: Int32Array<ArrayBuffer>;
  /** See `computeAreaNormals`. */
  areaNormals: Float64Array<ArrayBuffer>;
  /** The fans of `twins`. */
  fans: Fans;
  /** Unit normals at the scale of a stroke, three per fan. */
  normals: Float32Array<ArrayBuffer>;
  /** The curvature tensor of these normals, six floats per fan; see `fanCurvatures`. */
  tensors: Float32Array<ArrayBuffer>;
  /** A third of the area of each fan's triangles. */
  masses: Float64Array<ArrayBuffer>;
  heat: HeatEquation;
  /** The bounding radius of the mesh. */
  radius: number;
  /** For each fan the bounding radius of its connected part, as a share of that of the mesh. */
  partShares: Float32Array<ArrayBuffer>;
}

type Adjacency = Pick<TriangleAdjacency, 'canonicalCorners' | 'areaNormals'>;

/**
 * Prepares the surface of a mesh for a form field. `formTwins` chooses the creases that are borders.
 *
 * @param twins with NO_TWIN where windings contradict each other (`consistentTwins`)
 * @param radius the bounding radius of the mesh
 */
export function* formSurface(
  mesh: TriangleMesh,
  adjacency: Adjacency,
  twins: Int32Array<ArrayBuffer>,
  radius: number,
  options: FormOptions,
): Generator<number, FormSurface, void> {
  const parts = yield* asPhase(findParts(mesh, twins, adjacency.areaNormals, radius), 0, 0.05);
  const cut = yield* asPhase(formTwins(twins, adjacency.areaNormals, radius, parts), 0.05, 0.2);
  return yield* asPhase(surfaceWithin(mesh, adjacency, cut, radius, parts, options), 0.2, 1);
}

/** Prepares the surface with the borders of `twins` only. `parts` are connected across creases too. */
export function* surfaceWithin(
  mesh: TriangleMesh,
  { canonicalCorners, areaNormals }: Adjacency,
  twins: Int32Array<ArrayBuffer>,
  radius: number,
  parts: Parts,
  { smoothing }: FormOptions,
): Generator<number, FormSurface, void> {
  const fans = yield* asPhase(buildFans(twins), 0, 0.05);
  const surface = { mesh, twins, canonicalCorners, areaNormals, fans };
  const partShares = new Float32Array(fans.count);
  yield* forEachChunk(fans.ofCorner.length, (start, end) => {
    for (let corner = start; corner < end; corner++)
      partShares[fans.ofCorner[corner]] = parts.shares[parts.ofTriangle[triangleOf(corner)]];
  });
  const smoothed = yield* asPhase(strokeNormals(surface, smoothing * radius, partShares), 0.05, 0.7);
  const normals = yield* asPhase(fanDirections(smoothed, areaNormals, fans), 0.7, 0.75);
  const tensors = yield* asPhase(fanCurvatures(mesh, areaNormals, fans, normals), 0.75, 0.9);
  const heat = yield* asPhase(fanHeat(surface), 0.9, 1);
  return { mesh, twins, areaNormals, fans, normals, tensors, masses: heat.masses, heat, radius, partShares };
}

function* fanHeat(surface: FanSurface): Generator<number, HeatEquation, void> {
  const sorted = yield* asPhase(fansInOrder(surface), 0, 0.1);
  const { masses } = yield* asPhase(meanNormals(surface, sorted), 0.1, 0.3);
  return yield* asPhase(assembleHeatEquation(surface, masses, sorted), 0.3, 1);
}
