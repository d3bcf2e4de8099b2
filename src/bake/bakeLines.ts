import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { IS_EDGE } from '../features/edgeFlags.js';
import { fanCurvatures, TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { type FeatureEdges, findFeatureEdges } from '../features/findFeatureEdges.js';
import { isCoarse } from '../features/isCoarse.js';
import { turnFlaps } from '../features/turnFlaps.js';
import { doubleArea } from '../mesh/computeAreaNormals.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import { absorbSmallPatches } from '../normals/absorbSmallPatches.js';
import type { FanSurface } from '../normals/assembleHeatEquation.js';
import type { Fans } from '../normals/buildFans.js';
import { fanDirections } from '../normals/fanDirections.js';
import { smoothFanNormals } from '../normals/smoothFanNormals.js';
import { asPhase } from '../slices/asPhase.js';

/** What a bake is asked for lines. Plain data. */
export interface LineRequest {
  /** See `CreaseLimits`. */
  creaseAngle?: number | undefined;
  /** In object units. Default: see `CREASE_SHARE`. */
  creaseLength?: number | undefined;
  /** The group of each triangle; null where there is one alone. */
  triangleGroups: Uint16Array<ArrayBuffer> | null;
}

/** What lines are drawn from, before it is packed. */
export interface LineSurface {
  mesh: TriangleMesh;
  /** Those of the hatch normals. */
  fans: Fans;
  /** Unit normals, three per fan. */
  normals: Float32Array<ArrayBuffer>;
  /** See `fanCurvatures`. */
  curvatures: Float32Array<ArrayBuffer>;
  edges: FeatureEdges;
  /** Of the bounding sphere. */
  radius: number;
}

/** The scale of the normals that contours follow, as a share of the bounding radius: fine enough not to leave the outline. */
const CONTOUR_SHARE = 0.01;

/** The scale of the normals that curvatures are measured on. */
const CURVATURE_SHARE = 0.015;

/** Meshes of fewer triangles are no scans, and their small patches are faces. */
const LEAST_IN_SCAN = 5000;
/** A speck has so many triangles at most, */
const MOST_IN_SPECK = 2;
/** and so many times the area of a mean triangle. */
const LARGEST_SPECK = 1.5;

/** Creases that hang together are drawn from this length on, as a share of the bounding radius. */
const CREASE_SHARE = 0.2;

/**
 * Computes what contours, borders and creases are drawn from. On a coarse mesh each triangle keeps its own normal, and contours
 * run along its edges.
 *
 * @param surface whose twins are cut at sharp edges, and its fans before small patches were absorbed
 * @param adjacency with twins that no edge was cut from
 * @param ofCorner the fan of each corner after small patches were absorbed
 */
export function* bakeLines(
  surface: FanSurface,
  adjacency: TriangleAdjacency,
  ofCorner: Uint32Array<ArrayBuffer>,
  radius: number,
  { creaseAngle, creaseLength, triangleGroups }: LineRequest,
): Generator<number, LineSurface, void> {
  const { mesh, areaNormals, twins, canonicalCorners } = surface;
  const smooth = (yield* asPhase(isCoarse(mesh, twins, areaNormals, radius), 0, 0.03))
    ? yield* asPhase(facets(areaNormals), 0.03, 0.85)
    : yield* asPhase(smoothSurface(surface, ofCorner, radius), 0.03, 0.85);
  const edges = yield* asPhase(
    findFeatureEdges(
      {
        mesh,
        canonicalCorners,
        areaNormals,
        joinedTwins: adjacency.twins,
        sharpTwins: twins,
        ofCorner: smooth.fans.ofCorner,
        normals: smooth.normals,
        triangleGroups,
      },
      { creaseAngle: creaseAngle ?? null, creaseLength: creaseLength ?? CREASE_SHARE * radius },
    ),
    0.85,
    1,
  );
  for (let edge = 0; edge < edges.flags.length; edge++) edges.flags[edge] |= IS_EDGE;
  return { mesh, ...smooth, edges, radius };
}

type SmoothSurface = Pick<LineSurface, 'fans' | 'normals' | 'curvatures'>;

function* smoothSurface(
  surface: FanSurface,
  ofCorner: Uint32Array<ArrayBuffer>,
  radius: number,
): Generator<number, SmoothSurface, void> {
  const { mesh, areaNormals } = surface;
  const fans = { ofCorner: ofCorner.slice(), count: surface.fans.count };
  yield* asPhase(absorbSpecks(surface, fans), 0, 0.05);
  const directions = function* (share: number) {
    const smoothed = yield* asPhase(smoothFanNormals(surface, share * radius), 0, 0.9);
    return yield* asPhase(fanDirections(smoothed, areaNormals, fans), 0.9, 1);
  };
  const normals = yield* asPhase(directions(CONTOUR_SHARE), 0.05, 0.3);
  yield* asPhase(turnFlaps(normals, fans), 0.3, 0.33);
  const coarse = yield* asPhase(directions(CURVATURE_SHARE), 0.33, 0.7);
  const curvatures = yield* asPhase(fanCurvatures(mesh, areaNormals, fans, coarse), 0.7, 1);
  return { fans, normals, curvatures };
}

/**
 * Moves the corners of specks to the fans around them. Reduced scans have many triangles that lie folded over, and a line around
 * each would be dust.
 */
function* absorbSpecks(surface: FanSurface, fans: Fans): Generator<number, void, void> {
  const { areaNormals } = surface;
  const count = areaNormals.length / 3;
  if (count < LEAST_IN_SCAN) return;
  let whole = 0;
  for (let triangle = 0; triangle < count; triangle++) whole += 0.5 * doubleArea(areaNormals, triangle);
  const largest = (LARGEST_SPECK * whole) / count;
  yield* absorbSmallPatches(surface, fans, (area, triangles) => triangles <= MOST_IN_SPECK && area <= largest);
}

/** Every corner is a fan of its own, with the normal of its triangle. */
function* facets(areaNormals: Float64Array): Generator<number, SmoothSurface, void> {
  const count = areaNormals.length;
  const fans = { ofCorner: Uint32Array.from({ length: count }, (_, corner) => corner), count };
  const normals = yield* fanDirections(new Float32Array(3 * count), areaNormals, fans);
  return { fans, normals, curvatures: new Float32Array(TENSOR_FLOATS * count) };
}
