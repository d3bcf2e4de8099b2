import { triangleOf } from '../../corners.js';
import { TENSOR_FLOATS } from '../../features/fanCurvatures.js';
import { findPatches } from '../../normals/findPatches.js';
import { asPhase, forEachChunk } from '../../phases.js';
import type { FormSurface } from '../FormSurface.js';
import { facesOutwards } from './facesOutwards.js';

/** A piece bends one way if its mean curvature, with its sign, is at least this share of its mean without signs. */
const DECIDED_SHARE = 0.5;

/**
 * For each fan 1 if its piece of the surface is convex and −1 if it is hollow, such as the inside of a vase or a mesh wound inside out. A
 * piece that is both is judged by the winding of the mesh.
 */
export function* bendSigns(surface: FormSurface): Generator<number, Int8Array<ArrayBuffer>, void> {
  const { fans, mesh, areaNormals } = surface;
  const whole = (yield* asPhase(facesOutwards(mesh, areaNormals), 0, 0.3)) ? 1 : -1;
  const { ofTriangle, areas } = yield* asPhase(findPatches(surface), 0.3, 0.8);
  const patchOf = new Uint32Array(fans.count);
  yield* asPhase(
    forEachChunk(fans.ofCorner.length, (start, end) => assignRange(fans.ofCorner, ofTriangle, patchOf, start, end)),
    0.8,
    0.9,
  );
  const sums = new Float64Array(areas.length);
  const sizes = new Float64Array(areas.length);
  const signs = new Int8Array(fans.count);
  yield* asPhase(
    forEachChunk(fans.count, (start, end) => sumRange(surface, patchOf, sums, sizes, start, end)),
    0.9,
    0.95,
  );
  for (const [patch, sum] of sums.entries()) {
    const isDecided = Math.abs(sum) > DECIDED_SHARE * sizes[patch];
    sums[patch] = isDecided ? Math.sign(sum) : whole;
  }
  for (let fan = 0; fan < signs.length; fan++) signs[fan] = sums[patchOf[fan]];
  yield 1;
  return signs;
}

function assignRange(
  ofCorner: Uint32Array,
  ofTriangle: Uint32Array,
  patchOf: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) patchOf[ofCorner[corner]] = ofTriangle[triangleOf(corner)];
}

/** Adds the mean curvature of a range of fans to their patches. */
function sumRange(
  { masses, tensors }: FormSurface,
  patchOf: Uint32Array,
  sums: Float64Array,
  sizes: Float64Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const i = TENSOR_FLOATS * fan;
    const bend = masses[fan] * (tensors[i] + tensors[i + 3] + tensors[i + 5]);
    sums[patchOf[fan]] += bend;
    sizes[patchOf[fan]] += Math.abs(bend);
  }
}
