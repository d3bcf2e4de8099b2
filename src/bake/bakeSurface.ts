import { buildTriangleAdjacency, type TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import type { EdgeCounts } from '../adjacency/EdgeCounts.js';
import type { Nearness } from '../adjacency/joinBorders.js';
import { type Bounds, measureBounds } from '../mesh/measureBounds.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import { validateTriangleMesh } from '../mesh/validateTriangleMesh.js';
import { absorbSmallPatches } from '../normals/absorbSmallPatches.js';
import { buildFans, type Fans } from '../normals/buildFans.js';
import { computeSmoothNormals } from '../normals/computeSmoothNormals.js';
import { cutCreases } from '../normals/cutCreases.js';
import { cutSharpEdges } from '../normals/cutSharpEdges.js';
import { fanDirections } from '../normals/fanDirections.js';
import { smoothFanNormals } from '../normals/smoothFanNormals.js';
import { asPhase } from '../slices/asPhase.js';

/** The input of the bake for every layout. Plain data: it is posted to the worker. */
export interface SurfaceRequest {
  /** Begins every error message: the function that was called and the geometry it was given. */
  label: string;
  mesh: TriangleMesh;
  /** Triangles whose normals differ by this angle or more, in radians, are not neighbours. */
  creaseAngle: number;
  /** How near borders are joined, as a share of the bounding radius. See `nearnessOf`. */
  weldTolerance?: number | undefined;
  /** Detail finer than this, in object units, does not turn the hatch normals. See `DEFAULT_SMOOTHING_SHARE`. */
  smoothingRadius?: number | undefined;
  /** Whether to compute smooth normals, for a mesh that has none. */
  wantsNormals: boolean;
}

/** Unit normals, one per fan: x, y, z in the order of the fans' numbers. */
export interface FanNormals {
  fans: Fans;
  normals: Float32Array<ArrayBuffer>;
}

/** The part of the bake that all layouts share. */
export interface Surface {
  /** After cutting the creases. */
  adjacency: TriangleAdjacency;
  bounds: Bounds;
  hatchNormals: FanNormals;
  /** The smooth normals, if requested. Their fans are those of the hatch normals or unions of them, except small patches. */
  smoothNormals: FanNormals | null;
}

/**
 * The smoothing radius, as a share of the radius of the bounding sphere. A stroke is about a tenth of that radius long. Scan
 * noise is far finer; the folds of a robe or the scales of a dragon are as large or larger.
 */
export const DEFAULT_SMOOTHING_SHARE = 0.03;

/** The weld tolerance, as a share of the bounding radius: some roundings of single precision, far below any detail. */
export const DEFAULT_WELD_TOLERANCE = 1e-6;

/** A smaller share counts as 0: single precision would not notice. */
const LEAST_WELD_TOLERANCE = 2 ** -40;

/** The relative rounding of single precision. */
const SINGLE_ROUNDING = 2 ** -23;

/** How near the borders of a mesh are joined, in object units. */
export function nearnessOf({ radius }: Bounds, share = DEFAULT_WELD_TOLERANCE): Nearness {
  const used = share < LEAST_WELD_TOLERANCE ? 0 : share;
  return { tolerance: used * radius, rounding: Math.min(used, SINGLE_ROUNDING) * radius };
}

/** Validates the mesh, finds its adjacency, cuts the creases and computes the hatch normals and the smooth ones. */
export function* bakeSurface(request: SurfaceRequest): Generator<number, Surface, void> {
  const { mesh } = request;
  yield* asPhase(validateTriangleMesh(mesh, request.label), 0, 0.03);
  const bounds = yield* asPhase(measureBounds(mesh), 0.03, 0.06);
  const nearness = nearnessOf(bounds, request.weldTolerance);
  const adjacency = yield* asPhase(buildTriangleAdjacency(mesh, nearness), 0.06, 0.3);
  yield* asPhase(cutCreases(adjacency, request.creaseAngle), 0.3, 0.33);
  const smoothNormals = request.wantsNormals ? yield* asPhase(bakeSmoothNormals(adjacency), 0.33, 0.4) : null;
  const radius = request.smoothingRadius ?? DEFAULT_SMOOTHING_SHARE * bounds.radius;
  const hatchNormals = yield* asPhase(bakeHatchNormals(mesh, adjacency, radius), 0.4, 1);
  return { adjacency, bounds, hatchNormals, smoothNormals };
}

function* bakeSmoothNormals(adjacency: TriangleAdjacency): Generator<number, FanNormals, void> {
  const fans = yield* asPhase(buildFans(adjacency), 0, 0.5);
  return { fans, normals: yield* asPhase(computeSmoothNormals(adjacency.areaNormals, fans), 0.5, 1) };
}

/**
 * Normals at the scale of `radius`, split at sharp edges. Patches smaller than a disc of that diameter take the normals of
 * the surface around them and do not influence it.
 */
function* bakeHatchNormals(
  mesh: TriangleMesh,
  adjacency: TriangleAdjacency,
  radius: number,
): Generator<number, FanNormals, void> {
  const { canonicalCorners, areaNormals } = adjacency;
  const twins = yield* asPhase(cutSharpEdges(adjacency), 0, 0.15);
  const fans = yield* asPhase(buildFans({ twins, canonicalCorners }), 0.15, 0.22);
  const smoothed = yield* asPhase(
    smoothFanNormals({ mesh, twins, canonicalCorners, areaNormals, fans }, radius),
    0.22,
    0.9,
  );
  yield* asPhase(
    absorbSmallPatches({ twins, canonicalCorners, areaNormals }, fans, Math.PI * (radius / 2) ** 2),
    0.9,
    0.96,
  );
  return { fans, normals: yield* asPhase(fanDirections(smoothed, areaNormals, fans), 0.96, 1) };
}

/** What a bake of any layout found out about the mesh. */
export interface BakeReport extends EdgeCounts {
  bounds: Bounds;
}

export const reportOf = ({ adjacency, bounds }: Surface): BakeReport => {
  const { borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles } = adjacency;
  return { bounds, borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles };
};
