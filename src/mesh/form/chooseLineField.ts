import { TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { forEachChunk } from '../phases.js';
import type { FormSurface } from './FormSurface.js';

/** The field chosen for `lineField: 'auto'`, and the measure behind it. */
export interface LineFieldChoice {
  lineField: 'form' | 'light';
  /** The share of the surface that is flat, from 0 to 1. */
  flatShare: number;
}

/** Fans of a smaller curvature, times the bounding radius, are flat: they give lines no direction. */
const FLAT_CURVATURE = 0.3;

/**
 * From this share on, a mesh consists of flat faces. Shares are clearly high or low: of the models of the playground, a column with its
 * lids has 0.17, the highest with a form, and gears 0.69, the lowest without.
 */
const FLAT_FACED_SHARE = 0.4;

/**
 * Chooses between lines that follow the form, for organic shapes, and lines that follow the light, for machine parts and other meshes of
 * flat faces, which have no form. The measure is the share of the area that is flat between the creases.
 */
export function* chooseLineField({
  masses,
  tensors,
  radius,
}: Pick<FormSurface, 'masses' | 'tensors' | 'radius'>): Generator<number, LineFieldChoice, void> {
  const limit = (FLAT_CURVATURE / radius) ** 2;
  let area = 0;
  let flat = 0;
  yield* forEachChunk(masses.length, (start, end) => {
    for (let fan = start; fan < end; fan++) area += masses[fan];
    flat += flatArea(masses, tensors, limit, start, end);
  });
  const flatShare = area > 0 ? flat / area : 1;
  return { lineField: flatShare < FLAT_FACED_SHARE ? 'form' : 'light', flatShare };
}

/** The area of those of a range of fans whose curvature has a square below `limit`. */
function flatArea(masses: Float64Array, tensors: Float32Array, limit: number, start: number, end: number): number {
  let area = 0;
  for (let fan = start; fan < end; fan++) {
    const i = TENSOR_FLOATS * fan;
    const diagonal = tensors[i] ** 2 + tensors[i + 3] ** 2 + tensors[i + 5] ** 2;
    const beside = tensors[i + 1] ** 2 + tensors[i + 2] ** 2 + tensors[i + 4] ** 2;
    if (diagonal + 2 * beside < limit) area += masses[fan];
  }
  return area;
}
