import type { FormField } from '../form/FormField.js';
import type { FanNormals } from '../normals/fanNormals.js';
import { chunkPhase, forEachChunk } from '../phases.js';
import { formLayout, GRADIENTS_STRIDE, hatchNormal } from './attributeLayouts.js';
import { NO_CORNER } from './splitVertices.js';

/**
 * Packs the normals of fans into an attribute of three floats. With `cornerOfVertex` it has one normal per vertex: that of its
 * corner's fan, or +z for NO_CORNER. With null it has one normal per corner.
 */
export function* packNormals(
  { fans, normals }: FanNormals,
  cornerOfVertex: Uint32Array | null,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const corners = cornerOfVertex ?? fans.ofCorner;
  const packed = new Float32Array(3 * corners.length);
  yield* forEachChunk(corners.length, (start, end) =>
    packRange(normals, fans.ofCorner, cornerOfVertex, packed, start, end),
  );
  return packed;
}

function packRange(
  normals: Float32Array,
  ofCorner: Uint32Array,
  cornerOfVertex: Uint32Array | null,
  packed: Float32Array,
  start: number,
  end: number,
): void {
  for (let vertex = start; vertex < end; vertex++) {
    const corner = cornerOfVertex ? cornerOfVertex[vertex] : vertex;
    if (corner === NO_CORNER) {
      packed[3 * vertex + 2] = 1;
      continue;
    }
    const fan = 3 * ofCorner[corner];
    packed[3 * vertex] = normals[fan];
    packed[3 * vertex + 1] = normals[fan + 1];
    packed[3 * vertex + 2] = normals[fan + 2];
  }
}

/** The normalised 16-bit integer that stands for 1. */
const ONE = 0x7fff;

/** Packs the `hatchNormal` attribute, per vertex or per corner as `packNormals` does. */
export function* packHatchNormals(
  { fans, normals }: FanNormals,
  cornerOfVertex: Uint32Array | null,
): Generator<number, Int16Array<ArrayBuffer>, void> {
  const count = (cornerOfVertex ?? fans.ofCorner).length;
  const packed = new Int16Array(hatchNormal.itemSize * count);
  yield* forEachChunk(count, (start, end) => quantizeRange(normals, fans.ofCorner, cornerOfVertex, packed, start, end));
  return packed;
}

function quantizeRange(
  normals: Float32Array,
  ofCorner: Uint32Array,
  cornerOfVertex: Uint32Array | null,
  packed: Int16Array,
  start: number,
  end: number,
): void {
  for (let vertex = start; vertex < end; vertex++) {
    const corner = cornerOfVertex ? cornerOfVertex[vertex] : vertex;
    if (corner === NO_CORNER) {
      packed[4 * vertex + 2] = ONE;
      continue;
    }
    const fan = 3 * ofCorner[corner];
    packed[4 * vertex] = Math.round(ONE * normals[fan]);
    packed[4 * vertex + 1] = Math.round(ONE * normals[fan + 1]);
    packed[4 * vertex + 2] = Math.round(ONE * normals[fan + 2]);
  }
}

/** Gradients are cut to four times their mean length. Times the bounding radius. */
const LONGEST_GRADIENT = 64;

/** The attributes of `formLayout`. */
export interface PackedForm {
  values: Float32Array<ArrayBuffer>;
  /** For each vertex its slope, then its crossing, in one buffer: WebGPU takes no more than eight. */
  gradients: Int16Array<ArrayBuffer>;
}

/**
 * Packs the attributes of a form field. With `cornerOfVertex` there is one entry per vertex: that of its corner, or zeros for
 * NO_CORNER. With null there is one entry per corner.
 *
 * @param radius of the bounding sphere: gradients are some multiples of its inverse
 */
export function* packForm(
  { ofCorner, values, slopes, crossings }: FormField,
  radius: number,
  cornerOfVertex: Uint32Array | null,
): Generator<number, PackedForm, void> {
  const count = (cornerOfVertex ?? ofCorner).length;
  const packed: PackedForm = {
    values: new Float32Array(2 * count),
    gradients: new Int16Array(GRADIENTS_STRIDE * count),
  };
  const formVertexOf = (vertex: number): number => {
    const corner = cornerOfVertex ? cornerOfVertex[vertex] : vertex;
    return corner === NO_CORNER ? NO_CORNER : ofCorner[corner];
  };
  const exponent = radius > 0 ? Math.ceil(Math.log2(LONGEST_GRADIENT / radius)) : 0;
  yield* chunkPhase(count, 0, 0.2, (start, end) => packValues(values, formVertexOf, packed.values, start, end));
  yield* chunkPhase(count, 0.2, 0.6, (start, end) =>
    packGradients(slopes, exponent, formVertexOf, packed.gradients, 0, start, end),
  );
  yield* chunkPhase(count, 0.6, 1, (start, end) => {
    packGradients(crossings, exponent, formVertexOf, packed.gradients, formLayout.slope.itemSize, start, end);
  });
  return packed;
}

function packValues(
  values: Float32Array,
  formVertexOf: (vertex: number) => number,
  packed: Float32Array,
  start: number,
  end: number,
): void {
  for (let vertex = start; vertex < end; vertex++) {
    const source = formVertexOf(vertex);
    if (source === NO_CORNER) continue;
    packed[2 * vertex] = values[2 * source];
    packed[2 * vertex + 1] = values[2 * source + 1];
  }
}

function packGradients(
  gradients: Float32Array,
  exponent: number,
  formVertexOf: (vertex: number) => number,
  packed: Int16Array,
  offset: number,
  start: number,
  end: number,
): void {
  const scale = ONE * 2 ** -exponent;
  for (let vertex = start; vertex < end; vertex++) {
    const source = formVertexOf(vertex);
    if (source === NO_CORNER) continue;
    const target = GRADIENTS_STRIDE * vertex + offset;
    for (let axis = 0; axis < 3; axis++) {
      const value = Math.round(scale * gradients[3 * source + axis]);
      packed[target + axis] = Math.min(Math.max(value, -ONE), ONE);
    }
    packed[target + 3] = exponent;
  }
}
