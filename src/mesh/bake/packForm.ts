import type { FormField } from '../form/FormField.js';
import { asPhase, forEachChunk } from '../phases.js';
import { formLayout, GRADIENTS_STRIDE } from './attributeLayouts.js';
import { NO_CORNER } from './splitVertices.js';

/** The normalised 16-bit integer that stands for 1. */
const ONE = 0x7fff;

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
  yield* asPhase(
    forEachChunk(count, (start, end) => packValues(values, formVertexOf, packed.values, start, end)),
    0,
    0.2,
  );
  yield* asPhase(
    forEachChunk(count, (start, end) => packGradients(slopes, exponent, formVertexOf, packed.gradients, 0, start, end)),
    0.2,
    0.6,
  );
  yield* asPhase(
    forEachChunk(count, (start, end) => {
      packGradients(crossings, exponent, formVertexOf, packed.gradients, formLayout.slope.itemSize, start, end);
    }),
    0.6,
    1,
  );
  return packed;
}

/** The buffers of a packed form, which are transferred with it. */
export const formBuffers = (form: PackedForm | null): ArrayBuffer[] =>
  form === null ? [] : [form.values.buffer, form.gradients.buffer];

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
