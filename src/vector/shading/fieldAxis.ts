/**
 * The function whose level sets are lines, and one light for a whole object, so that lines run on, as in fieldAxis.glsl and lightField.glsl
 * of shaders/techniques/lines.
 */
import { FIELD_CONSTANTS } from '../../look/constants/lineConstants.js';
import { axisAngle, combined, cross, dot, lengthOf, normalize, type Vec3 } from '../../look/vectors.js';

/** The distance along an axis, or from a lamp. */
export interface Field {
  /** The gradient at the origin, unit. */
  axis: Vec3;
  /** Reciprocal of the distance of its lamp, per tile; 0 for planes across the axis. */
  bend: number;
}

/** The directions of lines that a field cuts. */
export type CutDirection = 'light' | 'towardsLight' | 'x' | 'y' | 'z' | 'slant';

const { SLANT, UPRIGHT } = FIELD_CONSTANTS;

const AXES: Readonly<Record<'x' | 'y' | 'z' | 'slant', Vec3>> = {
  x: [1, 0, 0],
  y: [0, 1, 0],
  z: [0, 0, 1],
  slant: SLANT,
};

/** A unit vector across another, continuous in it. */
export const across = (axis: Vec3): Vec3 => normalize(cross(axis, Math.abs(axis[1]) < UPRIGHT ? [0, 1, 0] : [0, 0, 1]));

/**
 * The field of the first family.
 *
 * @param light a result of `fieldLight`
 * @param angle by which lines are turned, counterclockwise, radians
 */
export function firstField(direction: CutDirection, { axis, bend }: Field, angle: number): Field {
  const turn = axisAngle(angle);
  const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
  if (direction === 'light') return { axis: combined(cosine, axis, sine, across(axis)), bend: cosine * bend };
  if (direction === 'towardsLight') return { axis: combined(cosine, across(axis), -sine, axis), bend: -sine * bend };
  return { axis: AXES[direction], bend: 0 };
}

/** The value of a field at a point, 0 at the origin, and its gradient there, unit. The point is in field space, tiles. */
export function fieldAt({ axis, bend }: Field, point: Vec3): { value: number; gradient: Vec3 } {
  const toLamp = combined(1, axis, -bend, point);
  const far = Math.max(lengthOf(toLamp), 1e-6);
  const sum = combined(1, axis, 1, toLamp);
  return { value: dot(point, sum) / (1 + far), gradient: combined(1 / far, toLamp, 0, toLamp) };
}

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
