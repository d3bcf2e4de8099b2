import { TENSOR_FLOATS } from '../features/fanCurvatures.js';
import { forEachChunk } from '../slices/forEachChunk.js';
import type { FormOptions } from './FormOptions.js';
import type { FormSurface } from './FormSurface.js';
import { FRAME_FLOATS } from './tangentFrames.js';

/** What a field of lines is drawn towards, before it is smoothed. Complex numbers are two floats per fan; see `Connection`. */
export interface LineTargets {
  /** For each fan how much it insists on its target. */
  weights: Float64Array<ArrayBuffer>;
  /** The weighted targets. */
  right: Float64Array<ArrayBuffer>;
  /** The part of `right` that curvature asks for: the direction that is the most convex. */
  curved: Float64Array<ArrayBuffer>;
  /** For each fan how far its two principal curvatures lie apart: half their difference, times the bounding radius. */
  anisotropy: Float32Array<ArrayBuffer>;
}

/** The anisotropy at which curvature counts half. */
const HALF_ANISOTROPY = 1;

/** How much `up` counts, beside curvature that is decided. */
const UP_WEIGHT = 0.2;

/**
 * Measures where lines should run: along the most convex direction, the more decidedly the further the principal curvatures lie
 * apart, and weakly across `up`. Ridges and grooves cancel each other, so that noise says nothing.
 */
export function* curvatureLines(
  surface: FormSurface,
  frames: Float32Array,
  { up, reach }: FormOptions,
): Generator<number, LineTargets, void> {
  const count = surface.fans.count;
  const targets: LineTargets = {
    weights: new Float64Array(count),
    right: new Float64Array(2 * count),
    curved: new Float64Array(2 * count),
    anisotropy: new Float32Array(count),
  };
  const scale = surface.radius * outwards(surface);
  const perMass = 1 / (reach * surface.radius) ** 2;
  const length = Math.hypot(...up) || 1;
  const axis = [up[0] / length, up[1] / length, up[2] / length] as const;
  yield* forEachChunk(count, (start, end) => measureRange(surface, frames, scale, perMass, axis, targets, start, end));
  return targets;
}

/** −1 if the surface is wound inside out, so that it is hollow in the mean, otherwise 1. */
function outwards({ masses, tensors }: FormSurface): number {
  let bend = 0;
  for (let fan = 0; fan < masses.length; fan++) {
    const i = TENSOR_FLOATS * fan;
    bend += masses[fan] * (tensors[i] + tensors[i + 3] + tensors[i + 5]);
  }
  return bend < 0 ? -1 : 1;
}

function measureRange(
  { masses, tensors }: FormSurface,
  frames: Float32Array,
  scale: number,
  perMass: number,
  axis: readonly [number, number, number],
  { weights, right, curved, anisotropy }: LineTargets,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const i = FRAME_FLOATS * fan;
    const ux = frames[i];
    const uy = frames[i + 1];
    const uz = frames[i + 2];
    const vx = frames[i + 3];
    const vy = frames[i + 4];
    const vz = frames[i + 5];
    const k = TENSOR_FLOATS * fan;
    const xx = tensors[k];
    const xy = tensors[k + 1];
    const xz = tensors[k + 2];
    const yy = tensors[k + 3];
    const yz = tensors[k + 4];
    const zz = tensors[k + 5];
    // The tensor times u and times v, and from these its part without a trace, in the frame.
    const kux = xx * ux + xy * uy + xz * uz;
    const kuy = xy * ux + yy * uy + yz * uz;
    const kuz = xz * ux + yz * uy + zz * uz;
    const kvx = xx * vx + xy * vy + xz * vz;
    const kvy = xy * vx + yy * vy + yz * vz;
    const kvz = xz * vx + yz * vy + zz * vz;
    const qx = 0.5 * scale * (ux * kux + uy * kuy + uz * kuz - vx * kvx - vy * kvy - vz * kvz);
    const qy = scale * (vx * kux + vy * kuy + vz * kuz);
    const length = Math.sqrt(qx * qx + qy * qy);
    const mass = perMass * masses[fan];
    const decided = mass / (length + HALF_ANISOTROPY);
    // The tangent across the axis, as long as the axis' part in the tangent plane.
    const hx = -(axis[0] * vx + axis[1] * vy + axis[2] * vz);
    const hy = axis[0] * ux + axis[1] * uy + axis[2] * uz;
    const level = UP_WEIGHT * mass;
    anisotropy[fan] = length;
    weights[fan] = decided * length + level * (hx * hx + hy * hy);
    curved[2 * fan] = decided * qx;
    curved[2 * fan + 1] = decided * qy;
    right[2 * fan] = decided * qx + level * (hx * hx - hy * hy);
    right[2 * fan + 1] = decided * qy + level * 2 * hx * hy;
  }
}
