/** Counterpart of shaders/techniques/engraved/fieldAxis.glsl: the function whose level sets are lines. */
import { FIELD_CONSTANTS } from '../../../look/constants/engravedConstants.js';
import { strokeDirection } from '../base/strokeDirection.js';
import { tsl, type Value } from '../base/values.js';
import { vFieldNormal } from './varyings.js';

const { abs, cross, dot, length, max, normalize, select, vec3, vec4 } = tsl;
const { LEAST_SINE, SLANT, UPRIGHT } = FIELD_CONSTANTS;

/** The choices for lines cut by a field. */
export interface LineCut {
  /** The choice `lineField`. */
  lineField: string;
  /** Whether lines run away from the light, as those of a ground that shows shadows alone. */
  runsAway: boolean;
  /** Whether lines turn in the shadows of lights. */
  reorients: boolean;
}

/** Whether the light directs the lines. */
export const turnsWithLight = ({ lineField, runsAway }: LineCut): boolean =>
  runsAway || lineField === 'light' || lineField === 'towards';

/** Whether the field is the same for a whole object. */
export const isByVertex = ({ runsAway, reorients }: LineCut): boolean => !runsAway && !reorients;

/** A unit vector across another, continuous in it. */
export const across = (axis: Value): Value =>
  normalize(select(abs(axis.y).lessThan(UPRIGHT), cross(axis, vec3(0, 1, 0)), cross(axis, vec3(0, 0, 1))));

/** The axes of fields without a light. */
const AXES: Readonly<Record<string, readonly [number, number, number]>> = {
  x: [1, 0, 0],
  y: [0, 1, 0],
  z: [0, 0, 1],
  slant: SLANT,
};

/**
 * The axis across the light and along the ground, so that lines on the ground run away from the light. The coordinate axis nearest to the
 * normal stands for that of the ground, so that no line breaks.
 */
function acrossGround(light: Value): Value {
  const { x, y, z } = abs(vFieldNormal).toVar();
  const isY = y.greaterThanEqual(x).and(y.greaterThanEqual(z));
  const up = select(isY, vec3(0, 1, 0), select(z.greaterThanEqual(x), vec3(0, 0, 1), vec3(1, 0, 0))).toVar();
  const side = cross(light, up).toVar();
  const sine = length(side).toVar();
  return select(sine.greaterThan(LEAST_SINE), side.div(max(sine, LEAST_SINE)), across(light));
}

/**
 * The gradient of the field at the origin, unit, and the reciprocal of the distance of its lamp: 0 for planes across the axis.
 *
 * @param light unit direction towards it, and reciprocal of its distance, field space
 */
export function firstField(light: Value, { lineField, runsAway }: LineCut): Value {
  if (runsAway) return vec4(acrossGround(light.xyz), 0);
  const { x, y } = strokeDirection;
  const aside = across(light.xyz);
  if (lineField === 'light') return vec4(light.xyz.mul(x).add(aside.mul(y)), x.mul(light.w));
  if (lineField === 'towards') return vec4(aside.mul(x).sub(light.xyz.mul(y)), y.negate().mul(light.w));
  return vec4(...(AXES[lineField] ?? SLANT), 0);
}

/** The value of the field at a point, 0 at the origin, and its unit gradient. */
export function fieldAt(field: Value, point: Value): { value: Value; gradient: Value } {
  const toLamp = field.xyz.sub(point.mul(field.w)).toVar(); // in units of the distance of the lamp
  const far = max(length(toLamp), 1e-6).toVar();
  return {
    value: dot(point, field.xyz.add(toLamp)).div(far.add(1)).toVar(),
    gradient: toLamp.div(far).toVar(),
  };
}
