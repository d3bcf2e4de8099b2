/** The twin of shaders/techniques/engraved/fieldAxis.glsl: the function that lines are level sets of. */
import { FIELD_CONSTANTS } from '../../../../engraving/constants/fieldConstants.js';
import { strokeDirection } from '../../base/strokeDirection.js';
import { tsl, type Value } from '../../base/values.js';

const { abs, cross, dot, length, max, normalize, select, vec3, vec4 } = tsl;
const { SLANT, UPRIGHT } = FIELD_CONSTANTS;

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
 * Its gradient at the origin, unit, and one over the distance of the lamp it counts from: 0 for planes across the axis.
 *
 * @param light towards it, unit, and one over its distance, field space
 * @param lineField the choice
 */
export function firstField(light: Value, lineField: string): Value {
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
