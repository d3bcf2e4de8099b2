import type { TriangleAdjacency } from '../adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, triangleOf } from '../corners.js';
import { fanCurvatures } from '../features/fanCurvatures.js';
import { assembleHeatEquation, type FanSurface, type HeatEquation } from '../normals/assembleHeatEquation.js';
import { cutSharpEdges } from '../normals/cutCreases.js';
import { fanDirections, meanNormals } from '../normals/fanNormals.js';
import { buildFans, type Fans, fansInOrder } from '../normals/fans.js';
import { findPatches } from '../normals/findPatches.js';
import { smoothFanNormals } from '../normals/smoothFanNormals.js';
import { asPhase, chunkPhase, forEachChunk } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import type { FormOptions } from './FormField.js';

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

/** A patch smaller than a disc of this radius has no lines of its own. A share of the bounding radius of its part. */
const SMALLEST_RADIUS = 0.04;

/**
 * Chooses the creases that are borders of the field: the sharp edges between two patches that are both large enough for lines of their own.
 * Lines continue across all others: creases that end within a patch, such as the corner of a mouth, and the small patches of scans.
 *
 * @param twins with NO_TWIN where windings contradict each other (`consistentTwins`)
 * @param radius the bounding radius of the mesh
 * @param parts the parts that `twins` connect
 * @returns a copy of `twins` with NO_TWIN at these creases
 */
export function* formTwins(
  twins: Int32Array<ArrayBuffer>,
  areaNormals: Float64Array<ArrayBuffer>,
  radius: number,
  parts: Parts,
): Generator<number, Int32Array<ArrayBuffer>, void> {
  const sharpTwins = twins.slice();
  yield* asPhase(cutSharpEdges(sharpTwins, areaNormals), 0, 0.7);
  const { ofTriangle, areas } = yield* asPhase(findPatches({ twins: sharpTwins, areaNormals }), 0.7, 0.9);
  const smallest = Math.PI * (SMALLEST_RADIUS * radius) ** 2;
  const isLarge = new Uint8Array(areas.length);
  yield* forEachChunk(ofTriangle.length, (start, end) => {
    for (let triangle = start; triangle < end; triangle++) {
      const patch = ofTriangle[triangle];
      isLarge[patch] = Number(areas[patch] >= smallest * parts.shares[parts.ofTriangle[triangle]] ** 2);
    }
  });
  const cut = twins.slice();
  yield* chunkPhase(twins.length, 0.9, 1, (start, end) => cutRange(sharpTwins, ofTriangle, isLarge, cut, start, end));
  return cut;
}

/** Each half-edge is judged by itself. The two halves of an edge always get the same result. */
function cutRange(
  sharpTwins: Int32Array,
  ofTriangle: Uint32Array,
  isLarge: Uint8Array,
  cut: Int32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = cut[corner];
    if (twin === NO_TWIN || sharpTwins[corner] !== NO_TWIN) continue;
    const a = ofTriangle[triangleOf(corner)];
    const b = ofTriangle[triangleOf(twin)];
    if (a !== b && isLarge[a] === 1 && isLarge[b] === 1) cut[corner] = NO_TWIN;
  }
}

/** The connected parts of a mesh. Each is a shape of its own: sizes on it are relative to the part, not to the whole. */
interface Parts {
  /** For each triangle its part. */
  ofTriangle: Uint32Array;
  /** For each part its bounding radius, as a share of that of the mesh. */
  shares: Float32Array<ArrayBuffer>;
}

/** Smaller parts count as having this share of the mesh: lines are coarser than their form. */
const SMALLEST_SHARE = 0.01;

/** Floats per part in boxes: the least x, y, z, then the largest. */
const BOX_FLOATS = 6;

/**
 * Finds the parts of a mesh.
 *
 * @param twins with NO_TWIN where windings contradict each other (`consistentTwins`), and not yet at creases
 * @param radius the bounding radius of the mesh
 */
export function* findParts(
  mesh: TriangleMesh,
  twins: Int32Array<ArrayBuffer>,
  areaNormals: Float64Array<ArrayBuffer>,
  radius: number,
): Generator<number, Parts, void> {
  const { ofTriangle, areas } = yield* asPhase(findPatches({ twins, areaNormals }), 0, 0.6);
  const shares = new Float32Array(areas.length).fill(1);
  // The only part is the mesh.
  if (areas.length === 1) return { ofTriangle, shares };
  const boxes = new Float64Array(BOX_FLOATS * areas.length);
  for (let i = 0; i < boxes.length; i++) boxes[i] = i % BOX_FLOATS < 3 ? Infinity : -Infinity;
  yield* chunkPhase(twins.length, 0.6, 0.8, (start, end) => encloseRange(mesh, ofTriangle, boxes, start, end));
  const squares = new Float64Array(areas.length);
  yield* chunkPhase(twins.length, 0.8, 1, (start, end) => reachRange(mesh, ofTriangle, boxes, squares, start, end));
  for (let part = 0; part < shares.length; part++)
    shares[part] = Math.min(1, Math.max(SMALLEST_SHARE, Math.sqrt(squares[part]) / (radius || 1)));
  return { ofTriangle, shares };
}

function encloseRange(
  { positions, indices }: TriangleMesh,
  ofTriangle: Uint32Array,
  boxes: Float64Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const box = BOX_FLOATS * ofTriangle[Math.floor(corner / 3)];
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * indices[corner] + axis];
      boxes[box + axis] = Math.min(boxes[box + axis], value);
      boxes[box + 3 + axis] = Math.max(boxes[box + 3 + axis], value);
    }
  }
}

/** Finds the square of the largest distance of the corners of each part from the middle of its box. */
function reachRange(
  { positions, indices }: TriangleMesh,
  ofTriangle: Uint32Array,
  boxes: Float64Array,
  squares: Float64Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const part = ofTriangle[Math.floor(corner / 3)];
    let square = 0;
    for (let axis = 0; axis < 3; axis++) {
      const middle = 0.5 * (boxes[BOX_FLOATS * part + axis] + boxes[BOX_FLOATS * part + 3 + axis]);
      square += (positions[3 * indices[corner] + axis] - middle) ** 2;
    }
    squares[part] = Math.max(squares[part], square);
  }
}

/**
 * A part is thinner than the larger radius if its normals, smoothed over twice the radius, are shorter than this share of the others: more
 * of them cancel than relief explains. From the second share on, it is not thin.
 */
const THIN = 0.3;
const THICK = 0.6;

/**
 * Smooths normals at the scale of a stroke. On thinner parts, such as claws and ears, normals from all around would cancel and be drowned
 * by those of the body; such parts take half the radius, or a quarter.
 *
 * @param shares see `smoothFanNormals`
 * @returns a vector per fan, not of unit length
 */
export function* strokeNormals(
  surface: FanSurface,
  radius: number,
  shares: Float32Array,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const radii = [radius, radius / 2, radius / 4];
  const [whole, half, quarter] = yield* asPhase(smoothFanNormals(surface, radii, shares), 0, 0.95);
  yield* chunkPhase(shares.length, 0.95, 1, (start, end) => {
    chooseRange(half, quarter, start, end);
    chooseRange(whole, half, start, end);
  });
  return whole;
}

/** Replaces vectors of a range of fans, in place, by those of the smaller radius where the part is thin. */
function chooseRange(vectors: Float32Array, finer: Float32Array, start: number, end: number): void {
  for (let i = 3 * start; i < 3 * end; i += 3) {
    const length = Math.sqrt(vectors[i] ** 2 + vectors[i + 1] ** 2 + vectors[i + 2] ** 2);
    const finerLength = Math.sqrt(finer[i] ** 2 + finer[i + 1] ** 2 + finer[i + 2] ** 2);
    if (length >= THICK * finerLength) continue;
    const t = Math.max(0, (length / finerLength - THIN) / (THICK - THIN));
    const share = t * t * (3 - 2 * t);
    const own = share / (length || 1);
    const other = (1 - share) / finerLength;
    for (let k = i; k < i + 3; k++) vectors[k] = finerLength * (own * vectors[k] + other * finer[k]);
  }
}
