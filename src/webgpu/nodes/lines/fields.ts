/** The functions whose level sets are lines, and the varyings that they need. */
import type { Light } from 'three';
import { FIELD_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { formLayout } from '../../../mesh/bake/attributeLayouts.js';
import { directedLights, hasPlace, type ReceivedShadow, valuesFor } from '../base/lights.js';
import { lightLuminance } from '../base/maths.js';
import { tsl, type Value } from '../base/values.js';
import { strokeDirection } from '../chunks/lightOrientation.js';

const { abs, attribute, cross, dot, exp2, float, int, length, Loop, max, normalize, round, select } = tsl;
const { varyingProperty, vec3, vec4 } = tsl;
const { FIRST_AXIS, LEAST_SINE, LEAST_WEIGHT, SLANT, UPRIGHT } = FIELD_CONSTANTS;

/** Counterpart of shaders/techniques/lines/varyings.glsl. Field space: that of the object, or one for all objects of a scene, in tiles. */

export const vFieldPoint: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldPoint');
/** The normal smoothed to the scale of a stroke. */
export const vFieldNormal: Value = /* @__PURE__ */ varyingProperty('vec3', 'vFieldNormal');
/** The axis of the field, unit, and the curvature of its function; constant over an object. */
export const vField: Value = /* @__PURE__ */ varyingProperty('vec4', 'vField');
/** Unit direction towards the light, and reciprocal of its distance, 0 for directional lights; for fields that are read per fragment. */
export const vFieldLight: Value = /* @__PURE__ */ varyingProperty('vec4', 'vFieldLight');
/** Gradient of a function, per tile, and its value minus half of the gradient's product with the position. */
export const vForm: Value = /* @__PURE__ */ varyingProperty('vec4', 'vForm');
/** The same for the crossing lines. */
export const vFormCrossing: Value = /* @__PURE__ */ varyingProperty('vec4', 'vFormCrossing');

/** Counterpart of shaders/techniques/lines/formAttributes.glsl: the baked functions of lines that follow the form. */

export const formValue = (): Value => attribute(formLayout.value.name, 'vec2');
export const formSlope = (): Value => attribute(formLayout.slope.name, 'vec4');
export const formCrossing = (): Value => attribute(formLayout.crossing.name, 'vec4');

/**
 * @param slope a gradient in object space, as packed
 * @param place field space
 */
export function formVarying(slope: Value, value: Value, toField: Value, place: Value): Value {
  const gradient = toField
    .mul(slope.xyz)
    .mul(exp2(round(slope.w.mul(32767))))
    .toVar();
  return vec4(gradient, value.sub(dot(gradient, place).mul(0.5)));
}

/** Counterpart of shaders/techniques/lines/lightField.glsl: one light for the whole object, so that lines run on. */

/** A symmetric 3 × 3 matrix, by columns. */
type Tensor = readonly [Value, Value, Value];

const applied = ([x, y, z]: Tensor, v: Value): Value => x.mul(v.x).add(y.mul(v.y)).add(z.mul(v.z));

/** The weight of a light. */
const fieldWeight = (color: Value): Value => lightLuminance(color).add(LEAST_WEIGHT).toVar();

/** Σ w L Lᵀ and Σ w L. @param toLight of any length, field space */
function addFieldLight(tensor: Tensor, sum: Value, toLight: Value, weight: Value): void {
  const l = toLight.div(max(length(toLight), 1e-20)).toVar();
  tensor[0].addAssign(l.mul(l.x).mul(weight));
  tensor[1].addAssign(l.mul(l.y).mul(weight));
  tensor[2].addAssign(l.mul(l.z).mul(weight));
  sum.addAssign(l.mul(weight));
}

/** The contribution of a lamp to Σ w c / |P|, c = L·axis: the curvature of the sum of the lights' own fields at the origin. */
const fieldBend = (axis: Value, toLamp: Value, weight: Value): Value =>
  weight.mul(dot(toLamp, axis)).div(max(dot(toLamp, toLamp), 1e-20));

function fieldAxisOf(tensor: Tensor, sum: Value, count: number): Value {
  if (count === 1) return sum.div(max(length(sum), 1e-20));
  // Power iteration: four squarings equal sixteen steps. The loop runs in the shader, since three.js walks the node graph along every path,
  // of which unrolled steps have too many.
  const [x, y, z] = tensor.map((column) => column.toVar());
  const power: Tensor = [x, y, z];
  Loop({ start: int(0), end: int(4), type: 'int', condition: '<' }, () => {
    const trace = max(x.x.add(y.y).add(z.z), 1e-20).toVar();
    const squared = power.map((column) => applied(power, column).div(trace).toVar());
    for (const [i, column] of squared.entries()) power[i].assign(column);
  });
  const axis = applied(power, vec3(...FIRST_AXIS)).toVar();
  axis.assign(axis.div(max(length(axis), 1e-20)));
  return select(dot(axis, sum).lessThan(0), axis.negate(), axis);
}

/**
 * The light of the field: unit direction, and reciprocal of the distance, field space.
 *
 * @param viewToField linear part
 * @param place any, view space
 * @param fromOrigin the same in field space; null at the origin
 * @param receivedShadows lights that cast shadows; those that do not arrive are left out
 */
export function fieldLight(
  viewToField: Value,
  place: Value,
  lights: readonly Light[],
  { fromOrigin, receivedShadows }: { fromOrigin: Value | null; receivedShadows: readonly ReceivedShadow[] } = {
    fromOrigin: null,
    receivedShadows: [],
  },
): Value {
  const directed = directedLights(lights).map((light) => {
    const values = valuesFor(light);
    const isAtPlace = hasPlace(light);
    const way = viewToField.mul(isAtPlace ? values.position.sub(place) : values.direction);
    const isShadowed = receivedShadows.find((one) => one.light === light)?.isShadowed;
    const color = isShadowed ? select(isShadowed, vec3(0), values.color) : values.color;
    return {
      way: (isAtPlace && fromOrigin ? way.add(fromOrigin) : way).toVar(),
      weight: fieldWeight(color),
      isAtPlace,
    };
  });
  if (directed.length === 0) return vec4(0, 1, 0, 0);
  const tensor: Tensor = [vec3(0).toVar(), vec3(0).toVar(), vec3(0).toVar()];
  const sum = vec3(0).toVar();
  for (const { way, weight } of directed) addFieldLight(tensor, sum, way, weight);
  const axis = fieldAxisOf(tensor, sum, directed.length).toVar();
  const bend = float(0).toVar();
  for (const { way, weight, isAtPlace } of directed) {
    if (isAtPlace) bend.addAssign(fieldBend(axis, way, weight));
  }
  return vec4(axis, bend.div(max(length(applied(tensor, axis)), 1e-20)));
}

/** Counterpart of shaders/techniques/lines/fieldAxis.glsl: the function whose level sets are lines. */

/** The choices that a field in space depends on. */
export interface DirectionChoices {
  /** The choice `direction`. */
  direction: string;
  /** Whether lines run away from the light, as those of a ground that shows shadows alone. */
  runsAway: boolean;
  /** Whether lines turn in the shadows of lights. */
  reorients: boolean;
}

/** Whether the light directs the lines. */
export const turnsWithLight = ({ direction, runsAway }: DirectionChoices): boolean =>
  runsAway || direction === 'light' || direction === 'towardsLight';

/** Whether the field is the same for a whole object. */
export const isByVertex = ({ runsAway, reorients }: DirectionChoices): boolean => !runsAway && !reorients;

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
export function firstField(light: Value, { direction, runsAway }: DirectionChoices): Value {
  if (runsAway) return vec4(acrossGround(light.xyz), 0);
  const { x, y } = strokeDirection;
  const aside = across(light.xyz);
  if (direction === 'light') return vec4(light.xyz.mul(x).add(aside.mul(y)), x.mul(light.w));
  if (direction === 'towardsLight') return vec4(aside.mul(x).sub(light.xyz.mul(y)), y.negate().mul(light.w));
  return vec4(...(AXES[direction] ?? SLANT), 0);
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
