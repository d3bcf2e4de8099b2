import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { fanCurvatures } from '../features/fanCurvatures.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import type { HeatEquation } from '../normals/assembleHeatEquation.js';
import { buildFans, type Fans } from '../normals/buildFans.js';
import { fanDirections } from '../normals/fanDirections.js';
import { diffuse, startFlow } from '../normals/smoothFanNormals.js';
import { asPhase } from '../slices/asPhase.js';
import type { FormOptions } from './FormOptions.js';
import { formTwins } from './formTwins.js';

/** The surface that a form field is computed on. Creases are borders here: lines on one side know nothing of the other. */
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
}

type Adjacency = Pick<TriangleAdjacency, 'canonicalCorners' | 'areaNormals'>;

/**
 * Prepares the surface of a mesh for a form field, with the creases as borders that `formTwins` chooses.
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
  const cut = yield* asPhase(formTwins(twins, adjacency.areaNormals, radius), 0, 0.15);
  return yield* asPhase(surfaceWithin(mesh, adjacency, cut, radius, options), 0.15, 1);
}

/** Prepares the surface with no borders but those of `twins`. */
export function* surfaceWithin(
  mesh: TriangleMesh,
  { canonicalCorners, areaNormals }: Adjacency,
  twins: Int32Array<ArrayBuffer>,
  radius: number,
  { smoothing }: FormOptions,
): Generator<number, FormSurface, void> {
  const fans = yield* asPhase(buildFans(twins), 0, 0.05);
  const surface = { mesh, twins, canonicalCorners, areaNormals, fans };
  const flow = yield* asPhase(startFlow(surface), 0.05, 0.2);
  const [smoothed] = yield* asPhase(diffuse(flow, [smoothing * radius]), 0.2, 0.8);
  const normals = yield* asPhase(fanDirections(smoothed, areaNormals, fans), 0.8, 0.85);
  const tensors = yield* asPhase(fanCurvatures(mesh, areaNormals, fans, normals), 0.85, 1);
  const { heat } = flow;
  return { mesh, twins, areaNormals, fans, normals, tensors, masses: heat.masses, heat, radius };
}
