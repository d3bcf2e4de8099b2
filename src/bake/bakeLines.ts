import { IS_EDGE } from '../features/edgeFlags.js';
import { fanCurvatures, TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { type FeatureEdges, findFeatureEdges } from '../features/findFeatureEdges.js';
import { turnFlaps } from '../features/turnFlaps.js';
import { doubleArea } from '../mesh/computeAreaNormals.js';
import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import { absorbSmallPatches } from '../normals/absorbSmallPatches.js';
import type { FanSurface } from '../normals/assembleHeatEquation.js';
import type { Fans } from '../normals/buildFans.js';
import { fanDirections } from '../normals/fanDirections.js';
import type { Patches } from '../normals/findPatches.js';
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

/** The scales, in object units, of the normals that contours follow and of those that curvatures are measured on. */
export const lineSmoothingRadii = (radius: number): [contours: number, curvatures: number] => [
  CONTOUR_SHARE * radius,
  CURVATURE_SHARE * radius,
];

/**
 * Computes what contours, borders and creases are drawn from. On a coarse mesh each triangle keeps its own normal, and contours
 * run along its edges.
 *
 * @param surface whose twins are cut at sharp edges, and its fans after small patches were absorbed
 * @param joinedTwins that no edge was cut from
 * @param smoothed the normals of the fans at each of the `lineSmoothingRadii`; null for a coarse mesh
 */
export function* bakeLines(
  surface: FanSurface,
  patches: Patches,
  joinedTwins: Int32Array,
  smoothed: readonly Float32Array[] | null,
  radius: number,
  { creaseAngle, creaseLength, triangleGroups }: LineRequest,
): Generator<number, LineSurface, void> {
  const { mesh, areaNormals, twins, canonicalCorners } = surface;
  const smooth = yield* asPhase(smoothed ? smoothSurface(surface, patches, smoothed) : facets(areaNormals), 0, 0.7);
  const edges = yield* asPhase(
    findFeatureEdges(
      {
        mesh,
        canonicalCorners,
        areaNormals,
        joinedTwins,
        sharpTwins: twins,
        ofCorner: smooth.fans.ofCorner,
        normals: smooth.normals,
        triangleGroups,
      },
      { creaseAngle: creaseAngle ?? null, creaseLength: creaseLength ?? CREASE_SHARE * radius },
    ),
    0.7,
    1,
  );
  for (let edge = 0; edge < edges.flags.length; edge++) edges.flags[edge] |= IS_EDGE;
  return { mesh, ...smooth, edges, radius };
}

type SmoothSurface = Pick<LineSurface, 'fans' | 'normals' | 'curvatures'>;

function* smoothSurface(
  surface: FanSurface,
  patches: Patches,
  [ofContours, ofCurvatures]: readonly Float32Array[],
): Generator<number, SmoothSurface, void> {
  const { mesh, areaNormals } = surface;
  const fans = { ofCorner: surface.fans.ofCorner.slice(), count: surface.fans.count };
  yield* asPhase(absorbSpecks(surface, patches, fans), 0, 0.2);
  const normals = yield* asPhase(fanDirections(ofContours, areaNormals, fans), 0.2, 0.3);
  yield* asPhase(turnFlaps(normals, fans), 0.3, 0.4);
  const coarse = yield* asPhase(fanDirections(ofCurvatures, areaNormals, fans), 0.4, 0.5);
  const curvatures = yield* asPhase(fanCurvatures(mesh, areaNormals, fans, coarse), 0.5, 1);
  return { fans, normals, curvatures };
}

/**
 * Moves the corners of specks to the fans around them. Reduced scans have many triangles that lie folded over, and a line around
 * each would be dust.
 */
function* absorbSpecks(surface: FanSurface, patches: Patches, fans: Fans): Generator<number, void, void> {
  const { areaNormals } = surface;
  const count = areaNormals.length / 3;
  if (count < LEAST_IN_SCAN) return;
  let whole = 0;
  for (let triangle = 0; triangle < count; triangle++) whole += 0.5 * doubleArea(areaNormals, triangle);
  const largest = (LARGEST_SPECK * whole) / count;
  yield* absorbSmallPatches(surface, patches, fans, (area, triangles) => triangles <= MOST_IN_SPECK && area <= largest);
}

/** Every corner is a fan of its own, with the normal of its triangle. */
function* facets(areaNormals: Float64Array): Generator<number, SmoothSurface, void> {
  const count = areaNormals.length;
  const fans = { ofCorner: Uint32Array.from({ length: count }, (_, corner) => corner), count };
  const normals = yield* fanDirections(new Float32Array(3 * count), areaNormals, fans);
  return { fans, normals, curvatures: new Float32Array(TENSOR_FLOATS * count) };
}
