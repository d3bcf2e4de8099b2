import { doubleArea } from '../computeAreaNormals.js';
import { fanCurvatures, TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { type FeatureEdges, findFeatureEdges } from '../features/findFeatureEdges.js';
import type { FanSurface } from '../normals/assembleHeatEquation.js';
import { fanDirections } from '../normals/fanNormals.js';
import type { Fans } from '../normals/fans.js';
import { absorbSmallPatches, type Patches } from '../normals/findPatches.js';
import { asPhase, chunkPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { IS_EDGE } from './outlineLayout.js';

/** Options of the bake of outlines. Plain data: it is posted to the worker. */
export interface OutlineRequest {
  /** Edges where the surface turns by at least this angle, in radians, are creases. See `CreaseLimits`. */
  featureAngle?: number | undefined;
  /** Shorter chains of creases are left out, in object units. Default: see `CREASE_SHARE`. */
  creaseLength?: number | undefined;
  /** The geometry group of each triangle; null if there is only one. */
  triangleGroups: Uint16Array<ArrayBuffer> | null;
}

/** The surface that contours and feature edges are drawn from, before it is packed. */
export interface OutlineSurface {
  mesh: TriangleMesh;
  /** The fans of the hatch normals, except for the specks. */
  fans: Fans;
  /** Unit normals, three per fan. */
  normals: Float32Array<ArrayBuffer>;
  /** See `fanCurvatures`. */
  curvatures: Float32Array<ArrayBuffer>;
  edges: FeatureEdges;
  /** Radius of the bounding sphere. */
  radius: number;
  /** Whether there are so many parts between sharp edges and borders that outlines may crowd. */
  mayCrowd: boolean;
}

/**
 * Smoothing radius of the normals for contours, as a share of the bounding radius. With a larger one, contours would leave the silhouette.
 */
const CONTOUR_SHARE = 0.01;

/** Smoothing radius of the normals for curvatures, as a share of the bounding radius. */
const CURVATURE_SHARE = 0.015;

/** The number of parts from which on outlines may crowd. */
const MANY_PARTS = 24;

/** A mesh with fewer triangles is no scan: its small patches are modelled faces. */
const MIN_SCAN_TRIANGLES = 5000;

/** The largest number of triangles in a speck. */
const MAX_SPECK_TRIANGLES = 2;

/** The largest area of a speck, as a multiple of the mean area of a triangle. */
const MAX_SPECK_AREA = 1.5;

/** If specks hold a larger share of the triangles, they are the sides of modelled boxes. */
const MAX_SPECKS_SHARE = 0.1;

/** Connected creases are drawn if they are at least this long in total, as a share of the bounding radius. */
const CREASE_SHARE = 0.2;

/** The smoothing radii, in object units, of the normals for contours and for curvatures. */
export const outlineSmoothingRadii = (radius: number): [contours: number, curvatures: number] => [
  CONTOUR_SHARE * radius,
  CURVATURE_SHARE * radius,
];

/**
 * Computes the surface that contours, borders and creases are drawn from. On a coarse mesh each triangle keeps its own normal,
 * and contours run along its edges.
 *
 * @param surface with twins that are cut at sharp edges, and with fans that have absorbed small patches
 * @param joinedTwins the twins before any edge was cut
 * @param smoothed the normals of the fans at each of the `outlineSmoothingRadii`; null for a coarse mesh
 */
export function* bakeOutlines(
  surface: FanSurface,
  patches: Patches,
  joinedTwins: Int32Array,
  smoothed: readonly Float32Array[] | null,
  radius: number,
  { featureAngle, creaseLength, triangleGroups }: OutlineRequest,
): Generator<number, OutlineSurface, void> {
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
      { featureAngle: featureAngle ?? null, creaseLength: creaseLength ?? CREASE_SHARE * radius },
    ),
    0.7,
    1,
  );
  for (let edge = 0; edge < edges.flags.length; edge++) edges.flags[edge] |= IS_EDGE;
  return { mesh, ...smooth, edges, radius, mayCrowd: patches.sizes.length >= MANY_PARTS };
}

type SmoothSurface = Pick<OutlineSurface, 'fans' | 'normals' | 'curvatures'>;

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
 * Moves the corners of specks to the fans around them. A speck is a tiny patch between sharp edges. Decimated scans have many
 * triangles that are folded over, and without this step each would get an outline around it.
 */
function* absorbSpecks(surface: FanSurface, patches: Patches, fans: Fans): Generator<number, void, void> {
  const { areaNormals } = surface;
  const count = areaNormals.length / 3;
  if (count < MIN_SCAN_TRIANGLES) return;
  let whole = 0;
  for (let triangle = 0; triangle < count; triangle++) whole += 0.5 * doubleArea(areaNormals, triangle);
  const largest = (MAX_SPECK_AREA * whole) / count;
  const isSpeck = (area: number, triangles: number): boolean => triangles <= MAX_SPECK_TRIANGLES && area <= largest;
  let inSpecks = 0;
  for (let patch = 0; patch < patches.sizes.length; patch++) {
    if (isSpeck(patches.areas[patch], patches.sizes[patch])) inSpecks += patches.sizes[patch];
  }
  if (inSpecks <= MAX_SPECKS_SHARE * count) yield* absorbSmallPatches(surface, patches, fans, isSpeck);
}

/** The surface of a coarse mesh: every corner is a fan of its own, with the normal of its triangle. */
function* facets(areaNormals: Float64Array): Generator<number, SmoothSurface, void> {
  const count = areaNormals.length;
  const fans = { ofCorner: Uint32Array.from({ length: count }, (_, corner) => corner), count };
  const normals = yield* fanDirections(new Float32Array(3 * count), areaNormals, fans);
  return { fans, normals, curvatures: new Float32Array(TENSOR_FLOATS * count) };
}

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
  yield* chunkPhase(ofCorner.length / 3, 0, 0.7, (start, end) => addOthers(normals, ofCorner, sums, start, end));
  yield* chunkPhase(count, 0.7, 1, (start, end) => turnRange(normals, sums, start, end));
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
