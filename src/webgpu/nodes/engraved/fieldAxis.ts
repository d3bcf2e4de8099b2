/** The twin of shaders/techniques/engraved/fieldAxis.glsl: the function that lines are level sets of. */
import { FIELD_CONSTANTS } from '../../../look/constants/engravedConstants.js';
import { strokeDirection } from '../base/strokeDirection.js';
import { tsl, type Value } from '../base/values.js';
import { vFieldNormal } from './varyings.js';

const { abs, cross, dot, length, max, normalize, select, vec3, vec4 } = tsl;
const { LEAST_SINE, SLANT, UPRIGHT } = FIELD_CONSTANTS;

/** What cuts lines out of an object. */
export interface LineCut {
  /** The choice. */
  lineField: string;
  /** Whether lines run away from the light, as those of shadows alone do. */
  runsAway: boolean;
  /** Whether they turn where some lights do not arrive. */
  reorients: boolean;
}

/** Whether the light says how lines run. */
export const turnsWithLight = ({ lineField, runsAway }: LineCut): boolean =>
  runsAway || lineField === 'light' || lineField === 'towards';

/** Whether the field is the same all over an object. */
export const isByVertex = ({ runsAway, reorients }: LineCut): boolean => !runsAway && !reorients;

/** Any unit vector across another, the same for neighbours of it. */
export const across = (axis: Value): Value =>
  normalize(select(abs(axis.y).lessThan(UPRIGHT), cross(axis, vec3(0, 1, 0)), cross(axis, vec3(0, 0, 1))));

/** What the axis is without a light. */
const AXES: Readonly<Record<string, readonly [number, number, number]>> = {
  x: [1, 0, 0],
  y: [0, 1, 0],
  z: [0, 0, 1],
  slant: SLANT,
};

/**
 * Across the light and across the ground, whose lines run away from the light then. The axis that leans least from the normal stands for the
 * ground: it is the same all over it, so that no line breaks.
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
 * Its gradient at the origin, unit, and one over the distance of the lamp it counts from: 0 for planes across the axis.
 *
 * @param light towards it, unit, and one over its distance, field space
 */
export function firstField(light: Value, { lineField, runsAway }: LineCut): Value {
  if (runsAway) return vec4(acrossGround(light.xyz), 0);
  const { x, y } = strokeDirection;
  const aside = across(light.xyz);
  if (lineField === 'light') return vec4(light.xyz.mul(x).add(aside.mul(y)), x.mul(light.w));
  if (lineField === 'towards') return vec4(aside.mul(x).sub(light.xyz.mul(y)), y.negate().mul(light.w));
  return vec4(...(AXES[lineField] ?? SLANT), 0);
}

/** The value at a point, 0 at the origin, and its gradient, unit. */
export function fieldAt(field: Value, point: Value): { value: Value; gradient: Value } {
  const toLamp = field.xyz.sub(point.mul(field.w)).toVar(); // over the distance of the lamp
  const far = max(length(toLamp), 1e-6).toVar();
  return {
    value: dot(point, field.xyz.add(toLamp)).div(far.add(1)).toVar(),
    gradient: toLamp.div(far).toVar(),
  };
}
