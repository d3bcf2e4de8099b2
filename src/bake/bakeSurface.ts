import { buildTriangleAdjacency, type TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import type { EdgeCounts } from '../adjacency/EdgeCounts.js';
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

/** What every layout is baked from. Plain data: it travels to the worker. */
export interface SurfaceRequest {
  /** Opens every error message: the function that was called and the thing it was given. */
  label: string;
  mesh: TriangleMesh;
  /** Edges whose triangles' normals differ by this or more, in radians, get no neighbour. */
  creaseAngle: number;
  /** Form finer than this, in object units, does not turn the hatch normals. `DEFAULT_SMOOTHING_SHARE` if undefined. */
  smoothingRadius?: number | undefined;
  /** Whether to compute smooth normals, for a mesh that has none. */
  wantsNormals: boolean;
}

/** Unit normals, one per fan: x, y, z in the order of the fans' numbers. */
export interface FanNormals {
  fans: Fans;
  normals: Float32Array<ArrayBuffer>;
}

/** What the layouts have in common. */
export interface Surface {
  /** With the creases cut. */
  adjacency: TriangleAdjacency;
  bounds: Bounds;
  hatchNormals: FanNormals;
  /** The smooth normals, if asked for. Their fans are those of the hatch normals or unions of them, but for specks. */
  smoothNormals: FanNormals | null;
}

/**
 * The smoothing radius, as a share of the radius of the bounding sphere. Strokes are some ten to a radius long: scan
 * noise is far finer, and folds of a robe or scales of a dragon are as large or larger.
 */
export const DEFAULT_SMOOTHING_SHARE = 0.03;

/** Validates the mesh, finds its adjacency, cuts the creases, and computes what normals there are to be. */
export function* bakeSurface(request: SurfaceRequest): Generator<number, Surface, void> {
  const { mesh } = request;
  yield* asPhase(validateTriangleMesh(mesh, request.label), 0, 0.03);
  const bounds = yield* asPhase(measureBounds(mesh), 0.03, 0.06);
  const adjacency = yield* asPhase(buildTriangleAdjacency(mesh), 0.06, 0.3);
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
 * Normals at the scale of `radius`, split at edges of the form. Patches smaller than a disc of that width take theirs from
 * what they lie on, and add nothing to it.
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

/** What a bake found out about the mesh, whatever its layout. */
export interface BakeReport extends EdgeCounts {
  bounds: Bounds;
}

export const reportOf = ({ adjacency, bounds }: Surface): BakeReport => {
  const { borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles } = adjacency;
  return { bounds, borderEdges, nonManifoldEdges, inconsistentEdges, degenerateTriangles };
};
