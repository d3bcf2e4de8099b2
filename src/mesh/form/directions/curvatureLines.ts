import { TENSOR_FLOATS } from '../../features/fanCurvatures.js';
import { forEachChunk } from '../../phases.js';
import type { FormOptions } from '../FormField.js';
import type { FormSurface } from '../FormSurface.js';
import { FRAME_FLOATS } from './connection.js';

/** The targets of a field of lines before it is smoothed. Complex numbers are two floats per fan; see `Connection`. */
export interface LineTargets {
  /** For each fan the weight of its target. */
  weights: Float64Array<ArrayBuffer>;
  /** The weighted targets. */
  right: Float64Array<ArrayBuffer>;
  /** The part of `right` due to curvature: the most convex direction. */
  curved: Float64Array<ArrayBuffer>;
  /** For each fan half the difference of its two principal curvatures, times the bounding radius of its part. */
  anisotropy: Float32Array<ArrayBuffer>;
}

/** The anisotropy at which curvature has half of its weight. */
const HALF_ANISOTROPY = 1;

/** From this anisotropy on, that of a limb of a thirtieth of the radius, directions spread the less far the thinner the limb is. */
const THIN_ANISOTROPY = 15;

/** Weight of `up` beside decided curvature. */
const UP_WEIGHT = 0.2;

/** Weight of the level axis on flat surfaces that face up or down, such as lids. */
const LEVEL_WEIGHT = 0.5;

/** The curvature, times the bounding radius, at which a surface is no longer flat. */
const FLAT_CURVATURE = 0.3;

/**
 * Measures where lines should run: along the most convex direction, with a weight that grows with the difference of the principal
 * curvatures, and weakly across `up`. Ridges and grooves cancel each other, so noise has no effect. Flat lids, which have neither, are
 * ruled along one axis, the horizontal one seen from the front.
 *
 * @param signs see `bendSigns`
 */
export function* curvatureLines(
  surface: FormSurface,
  frames: Float32Array,
  signs: Int8Array,
  { up, front, reach }: FormOptions,
): Generator<number, LineTargets, void> {
  const count = surface.fans.count;
  const targets: LineTargets = {
    weights: new Float64Array(count),
    right: new Float64Array(2 * count),
    curved: new Float64Array(2 * count),
    anisotropy: new Float32Array(count),
  };
  const perMass = 1 / (reach * surface.radius) ** 2;
  const axis = normalized(up);
  const level = normalized(cross(axis, viewedFrom(axis, front)));
  yield* forEachChunk(count, (start, end) =>
    measureRange(surface, frames, signs, perMass, axis, level, targets, start, end),
  );
  return targets;
}

function measureRange(
  { masses, tensors, radius, partShares }: FormSurface,
  frames: Float32Array,
  signs: Int8Array,
  perMass: number,
  axis: Vector,
  levelAxis: Vector,
  { weights, right, curved, anisotropy }: LineTargets,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const i = FRAME_FLOATS * fan;
    const scale = signs[fan] * partShares[fan] * radius;
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
    const mass = (perMass * masses[fan]) / partShares[fan] ** 2;
    const reached = Math.max(1, length / THIN_ANISOTROPY);
    const decided = (mass * reached * reached) / (length + HALF_ANISOTROPY);
    // The tangent across the axis, as long as the axis' part in the tangent plane.
    const hx = -(axis[0] * vx + axis[1] * vy + axis[2] * vz);
    const hy = axis[0] * ux + axis[1] * uy + axis[2] * uz;
    const steepness = hx * hx + hy * hy;
    const bend = scale * scale * (xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz));
    const flatness = (FLAT_CURVATURE ** 2 / (FLAT_CURVATURE ** 2 + bend)) ** 2;
    const lx = levelAxis[0] * ux + levelAxis[1] * uy + levelAxis[2] * uz;
    const ly = levelAxis[0] * vx + levelAxis[1] * vy + levelAxis[2] * vz;
    const across = UP_WEIGHT * mass;
    const along = LEVEL_WEIGHT * mass * flatness * Math.max(0, 1 - steepness);
    anisotropy[fan] = length;
    weights[fan] = decided * length + across * steepness + along * (lx * lx + ly * ly);
    curved[2 * fan] = decided * qx;
    curved[2 * fan + 1] = decided * qy;
    right[2 * fan] = decided * qx + across * (hx * hx - hy * hy) + along * (lx * lx - ly * ly);
    right[2 * fan + 1] = decided * qy + across * 2 * hx * hy + along * 2 * lx * ly;
  }
}

/** Multiplies the weight of each target by the prominence of its fan. */
export function* weighTargets(
  { weights, right }: LineTargets,
  prominences: Float32Array,
): Generator<number, void, void> {
  yield* forEachChunk(prominences.length, (start, end) => {
    for (let fan = start; fan < end; fan++) {
      weights[fan] *= prominences[fan];
      right[2 * fan] *= prominences[fan];
      right[2 * fan + 1] *= prominences[fan];
    }
  });
}

/** Natural logarithm of the ratio between the prominence of the front and that of the sides. */
const FRONT_EXPONENT = 1;

/** The same for surfaces that face up: objects are seen from above rather than below, where their shadows lie. */
const UP_EXPONENT = 1.2;

/**
 * The visual weight of each fan: the front weighs seven times as much as the back, and what faces up eleven times as much as what faces
 * down. Turns of the field cost as much as they are visible, so singular points, around which it turns most, move to the sides, the back
 * and below.
 *
 * @param signs see `bendSigns`
 */
export function* prominence(
  { fans, normals }: Pick<FormSurface, 'fans' | 'normals'>,
  signs: Int8Array,
  { up, front }: Pick<FormOptions, 'up' | 'front'>,
): Generator<number, Float32Array, void> {
  const axis = normalized(up);
  const facing = normalized(viewedFrom(axis, front));
  const most = axis.map((value, i) => UP_EXPONENT * value + FRONT_EXPONENT * facing[i]) as unknown as Vector;
  const prominences = new Float32Array(fans.count);
  yield* forEachChunk(fans.count, (start, end) => showRange(normals, signs, most, prominences, start, end));
  return prominences;
}

function showRange(
  normals: Float32Array,
  signs: Int8Array,
  [x, y, z]: Vector,
  prominences: Float32Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const height = normals[3 * fan] * x + normals[3 * fan + 1] * y + normals[3 * fan + 2] * z;
    prominences[fan] = Math.exp(signs[fan] * height);
  }
}

type Vector = readonly [x: number, y: number, z: number];

/** A vector of unit length, or zero for zero. */
function normalized([x, y, z]: Vector): Vector {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The front of an object without one of its own: z, or −y where up is z, as is usual in files and programs. */
const viewedFrom = (up: Vector, front?: Vector): Vector => front ?? (Math.abs(up[2]) < 0.9 ? [0, 0, 1] : [0, -1, 0]);
