/** One light for a whole object, so that lines run on, as in shaders/techniques/engraved/lightField.glsl. */

import { FIELD_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { combined, dot, lengthOf, normalize, type Vec3 } from '../../look/vectors.js';
import type { Field } from './fieldAxis.js';

/** A light with a direction, relative to the origin of the field. */
export interface FieldLamp {
  /** Vector towards it, field space: of any length for a directional light; for a positional light its position, tiles. */
  toLight: Vec3;
  luminance: number;
  isFar: boolean;
}

const { LEAST_WEIGHT, FIRST_AXIS } = FIELD_CONSTANTS;

/** Steps of the power iteration. The shader has sixteen, which suffice unless two axes are nearly equal. */
const STEPS = 64;

/** Σ w L (L·a): the tensor of the lights times an axis. */
function applied(lights: readonly { unit: Vec3; weight: number }[], axis: Vec3): Vec3 {
  let sum: Vec3 = [0, 0, 0];
  for (const { unit, weight } of lights) sum = combined(1, sum, weight * dot(unit, axis), unit);
  return sum;
}

/**
 * The axis on which the lights agree most, the principal axis of Σ w L Lᵀ, and the curvature of their fields along it. Up without lights.
 */
export function fieldLight(lamps: readonly FieldLamp[]): Field {
  if (lamps.length === 0) return { axis: [0, 1, 0], bend: 0 };
  const lights = lamps.map(({ toLight, luminance }) => ({
    unit: normalize(toLight),
    weight: luminance + LEAST_WEIGHT,
  }));
  let sum: Vec3 = [0, 0, 0];
  for (const { unit, weight } of lights) sum = combined(1, sum, weight, unit);
  let axis = lights[0].unit;
  if (lights.length > 1) {
    axis = FIRST_AXIS;
    for (let step = 0; step < STEPS; step++) axis = normalize(applied(lights, axis));
    if (dot(axis, sum) < 0) axis = combined(-1, axis, 0, axis);
  }
  let bend = 0;
  for (const [i, { toLight, isFar }] of lamps.entries()) {
    if (!isFar) bend += (lights[i].weight * dot(toLight, axis)) / Math.max(dot(toLight, toLight), 1e-20);
  }
  return { axis, bend: bend / Math.max(lengthOf(applied(lights, axis)), 1e-20) };
}
