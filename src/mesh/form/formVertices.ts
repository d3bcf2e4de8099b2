import { doubleArea } from '../computeAreaNormals.js';
import { chunkPhase } from '../phases.js';
import type { FormSeam } from './cutForm.js';
import type { FormField } from './FormField.js';
import type { FormSurface } from './FormSurface.js';
import { NO_OFFSET, type SeamRelations } from './phase/seamRelations.js';
import type { Phase } from './phase/solvePhase.js';

/** Gradients turn around a vertex if their mean is shorter than this share of their mean length. */
const TURNING_SHARE = 0.7;

/** The arrays of the loops over triangles. */
interface Gradients {
  surface: FormSurface;
  seam: FormSeam;
  /** φ and φ₂ of each wedge. */
  values: Float64Array;
  /** Three floats per wedge: first sums, weighted by area, then means. */
  slopes: Float32Array;
  crossings: Float32Array;
  /** Three floats per wedge: sums of the lengths of both gradients, and of areas. */
  weights: Float32Array;
  /** φ and φ₂ of the corners of one triangle, and its gradients: x, y, z of each. */
  corners: Float64Array;
  own: Float64Array;
}

/**
 * Turns wedges into form vertices with gradients, the area-weighted means of those of their triangles. Where gradients turn around a wedge,
 * as at singular points, each of its corners becomes a vertex with the gradient of its own triangle.
 */
export function* formVertices(
  surface: FormSurface,
  seam: FormSeam,
  relations: SeamRelations,
  phase: Phase,
): Generator<number, FormField, void> {
  const cornerCount = surface.twins.length;
  const { wedges } = seam;
  const gradients: Gradients = {
    surface,
    seam,
    values: new Float64Array(2 * wedges.count),
    slopes: new Float32Array(3 * wedges.count),
    crossings: new Float32Array(3 * wedges.count),
    weights: new Float32Array(3 * wedges.count),
    corners: new Float64Array(6),
    own: new Float64Array(6),
  };
  yield* chunkPhase(cornerCount, 0, 0.2, (start, end) => valueRange(gradients, relations, phase, start, end));
  yield* chunkPhase(cornerCount / 3, 0.2, 0.7, (start, end) => addRange(gradients, start, end));
  const turns = new Uint8Array(wedges.count);
  yield* chunkPhase(wedges.count, 0.7, 0.8, (start, end) => meanRange(gradients, turns, start, end));
  const ofCorner = wedges.ofCorner.slice();
  let count = wedges.count;
  yield* chunkPhase(cornerCount, 0.8, 0.9, (start, end) => {
    count = separateRange(gradients, turns, ofCorner, count, start, end);
  });
  const field: FormField = {
    count,
    ofCorner,
    values: new Float32Array(2 * count),
    slopes: lengthened(gradients.slopes, 3 * count),
    crossings: lengthened(gradients.crossings, 3 * count),
    radius: surface.radius,
    statistics: { singularPoints: singularPoints(seam), addedVertices: count - surface.fans.count },
  };
  yield* chunkPhase(cornerCount / 3, 0.9, 1, (start, end) => writeRange(gradients, turns, field, start, end));
  return field;
}

/** Writes φ and φ₂ of the wedges of a range of corners. */
function valueRange(
  { surface, seam, values }: Gradients,
  { signs, ofWedge }: SeamRelations,
  { nodes, offsets }: Phase,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const fan = surface.fans.ofCorner[corner];
    const wedge = seam.wedges.ofCorner[corner];
    const offset = ofWedge[wedge];
    values[2 * wedge] = signs[wedge] * nodes[2 * fan] + (offset === NO_OFFSET ? 0 : offsets[2 * offset]);
    values[2 * wedge + 1] = signs[wedge] * nodes[2 * fan + 1] + (offset === NO_OFFSET ? 0 : offsets[2 * offset + 1]);
  }
}

/**
 * Writes φ and φ₂ of the corners of a triangle into `corners`. φ has no value at a puncture, where each triangle extrapolates from its
 * other two corners.
 */
function readTriangle({ surface, seam, values, corners }: Gradients, first: number): void {
  for (let k = 0; k < 3; k++) {
    const wedge = seam.wedges.ofCorner[first + k];
    corners[2 * k] = values[2 * wedge];
    corners[2 * k + 1] = values[2 * wedge + 1];
  }
  for (let k = 0; k < 3; k++) {
    if (seam.isPuncture[surface.fans.ofCorner[first + k]] === 0) continue;
    const a = 2 * ((k + 1) % 3);
    const b = 2 * ((k + 2) % 3);
    corners[2 * k] = (corners[a] + corners[b]) / 2;
    corners[2 * k + 1] = (corners[a + 1] + corners[b + 1]) / 2;
  }
}

/** Writes the values of a triangle into `corners` and its gradients into `own`. Returns twice its area, 0 if it has no gradient. */
function measureTriangle(gradients: Gradients, first: number): number {
  const { surface, corners, own } = gradients;
  const {
    mesh: { positions, indices },
    areaNormals,
  } = surface;
  readTriangle(gradients, first);
  own.fill(0);
  const area = doubleArea(areaNormals, first / 3);
  if (!(area > 0)) return 0;
  for (let k = 0; k < 3; k++) {
    const p = 3 * indices[first + ((k + 1) % 3)];
    const q = 3 * indices[first + ((k + 2) % 3)];
    const x = (positions[q] - positions[p]) / area;
    const y = (positions[q + 1] - positions[p + 1]) / area;
    const z = (positions[q + 2] - positions[p + 2]) / area;
    const value = corners[2 * k];
    const value2 = corners[2 * k + 1];
    own[0] += value * x;
    own[1] += value * y;
    own[2] += value * z;
    own[3] += value2 * x;
    own[4] += value2 * y;
    own[5] += value2 * z;
  }
  // The gradient is the unit normal times the sum of values times opposite edges over twice the area.
  const nx = areaNormals[first] / area;
  const ny = areaNormals[first + 1] / area;
  const nz = areaNormals[first + 2] / area;
  turnBy(nx, ny, nz, own, 0);
  turnBy(nx, ny, nz, own, 3);
  return area;
}

/** Writes n × v over v. */
function turnBy(nx: number, ny: number, nz: number, vectors: Float64Array, i: number): void {
  const x = vectors[i];
  const y = vectors[i + 1];
  const z = vectors[i + 2];
  vectors[i] = ny * z - nz * y;
  vectors[i + 1] = nz * x - nx * z;
  vectors[i + 2] = nx * y - ny * x;
}

/** Adds the gradients of a range of triangles to their wedges. */
function addRange(gradients: Gradients, start: number, end: number): void {
  const { seam, slopes, crossings, weights, own } = gradients;
  const { ofCorner } = seam.wedges;
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const area = measureTriangle(gradients, first);
    if (area === 0) continue;
    const length = area * Math.sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
    const length2 = area * Math.sqrt(own[3] * own[3] + own[4] * own[4] + own[5] * own[5]);
    for (let corner = first; corner < first + 3; corner++) {
      const i = 3 * ofCorner[corner];
      for (let axis = 0; axis < 3; axis++) {
        slopes[i + axis] += area * own[axis];
        crossings[i + axis] += area * own[3 + axis];
      }
      weights[i] += length;
      weights[i + 1] += length2;
      weights[i + 2] += area;
    }
  }
}

/** Turns sums into means, and finds the wedges around which a gradient turns. */
function meanRange({ slopes, crossings, weights }: Gradients, turns: Uint8Array, start: number, end: number): void {
  for (let wedge = start; wedge < end; wedge++) {
    const i = 3 * wedge;
    if (isShort(slopes, i, weights[i]) || isShort(crossings, i, weights[i + 1])) turns[wedge] = TURNING;
    const share = 1 / (weights[i + 2] || 1);
    for (let axis = i; axis < i + 3; axis++) {
      slopes[axis] *= share;
      crossings[axis] *= share;
    }
  }
}

const isShort = (sums: Float32Array, i: number, length: number): boolean =>
  sums[i] * sums[i] + sums[i + 1] * sums[i + 1] + sums[i + 2] * sums[i + 2] < (TURNING_SHARE * length) ** 2;

/** Marks a wedge around which gradients turn, and then one whose number its first corner has kept. */
const TURNING = 1;
const KEPT = 2;

/** Gives each corner of a range a vertex of its own if gradients turn around its wedge. Returns the number of vertices so far. */
function separateRange(
  { surface, seam }: Gradients,
  turns: Uint8Array,
  ofCorner: Uint32Array,
  countBefore: number,
  start: number,
  end: number,
): number {
  let count = countBefore;
  for (let corner = start; corner < end; corner++) {
    const wedge = seam.wedges.ofCorner[corner];
    if (turns[wedge] === 0 && seam.isPuncture[surface.fans.ofCorner[corner]] === 0) continue;
    if (turns[wedge] === KEPT) ofCorner[corner] = count++;
    turns[wedge] = KEPT;
  }
  return count;
}

/** Writes the values of a range of triangles, and their gradients where vertices are theirs alone. */
function writeRange(
  gradients: Gradients,
  turns: Uint8Array,
  { ofCorner, values, slopes, crossings }: FormField,
  start: number,
  end: number,
): void {
  const { seam, corners, own } = gradients;
  const wedgeOf = seam.wedges.ofCorner;
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const turning = turns[wedgeOf[first]] | turns[wedgeOf[first + 1]] | turns[wedgeOf[first + 2]];
    if (turning !== KEPT) readTriangle(gradients, first);
    const hasOwn = turning === KEPT && measureTriangle(gradients, first) > 0;
    for (let k = 0; k < 3; k++) {
      const vertex = ofCorner[first + k];
      values[2 * vertex] = corners[2 * k];
      values[2 * vertex + 1] = corners[2 * k + 1];
      if (!hasOwn || turns[wedgeOf[first + k]] !== KEPT) continue;
      for (let axis = 0; axis < 3; axis++) {
        slopes[3 * vertex + axis] = own[axis];
        crossings[3 * vertex + axis] = own[3 + axis];
      }
    }
  }
}

/** A longer array that starts with `floats`. */
function lengthened(floats: Float32Array, length: number): Float32Array<ArrayBuffer> {
  const longer = new Float32Array(length);
  longer.set(floats);
  return longer;
}

function singularPoints({ isSingular, isPuncture }: FormSeam): number {
  let count = 0;
  for (let fan = 0; fan < isSingular.length; fan++) count += isSingular[fan] | isPuncture[fan];
  return count;
}
