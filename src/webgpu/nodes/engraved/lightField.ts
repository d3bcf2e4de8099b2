/** Counterpart of shaders/techniques/engraved/lightField.glsl: one light for the whole object, so that lines run on. */
import type { Light } from 'three';
import { FIELD_CONSTANTS } from '../../../look/constants/engravedConstants.js';
import { directedLights, hasPlace } from '../base/directedLights.js';
import type { ReceivedShadow } from '../base/ReceivedShadow.js';
import { tsl, type Value } from '../base/values.js';
import { lightLuminance } from '../chunks/lightLuminance.js';
import { valuesFor } from '../chunks/meanLight.js';

const { dot, float, int, length, Loop, max, select, vec3, vec4 } = tsl;
const { FIRST_AXIS, LEAST_WEIGHT } = FIELD_CONSTANTS;

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
