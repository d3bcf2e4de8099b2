import type { Light } from 'three';
import { directedLights, fallOff, hasPlace, type LightValues, type ReceivedShadow, valuesFor } from '../base/lights.js';
import { lightLuminance } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { abs, cameraViewMatrix, cross, dot, float, inverseSqrt, length, max, normalize, positionView, select } = tsl;
const { smoothstep, vec2, vec3 } = tsl;

/** Whether strokes and lines follow the form. @param direction the choice */
export const followsForm = (direction: string): boolean => direction === 'form' || direction === 'acrossForm';

export const strokeDirection: Value = /* @__PURE__ */ hatchingUniform('strokeDirection', 'vec2');

/**
 * Counterpart of shaders/chunks/lightOrientation.glsl: the direction from which a surface is lit, in its tangent plane: B of Algorithm 1.
 * Several lights are averaged as axes; the sign of the result is that of their weighted sum.
 */

/** Squared sine of the angle between light and normal below which a light gives no direction. */
const PARALLEL_SQUARED_SINE = 1e-8;
/** Weight of a light where it does not reach, so that strokes keep a direction beyond a cone or a terminator. */
const UNLIT_WEIGHT = 1e-4;
/** Cosine down to which a light counts beyond its terminator, so that strokes keep their direction there. */
const BEHIND_TERMINATOR = 0.05;

/** The direction of strokes, and the disagreement of the lights: 0 where they are collinear, 1 where no direction prevails. */
export interface Orientation {
  bitangent: Value;
  crossing: Value;
}

/** A vector perpendicular to n, neither of unit length nor close to zero. */
export const anyTangent = (n: Value): Value =>
  select(abs(n.x).greaterThan(abs(n.z)), vec3(n.y.negate(), n.x, 0), vec3(0, n.z.negate(), n.y));

/**
 * A direction across a light, for strokes in its shadow. Its pole is not that of the light, so that no singularity shows in the shadow.
 * @param toLight unit, view space
 */
function acrossLight(toLight: Value): Value {
  const [right, up] = [0, 1].map((column) => cameraViewMatrix.element(column).xyz);
  return normalize(cross(toLight, select(abs(dot(toLight, up)).lessThan(0.9), up, right)));
}

/** A light as strokes see it: in its own shadow, turned across. */
function turnInShadow(
  { direction, arriving }: Incident,
  light: Light,
  receivedShadows: readonly ReceivedShadow[],
): Incident {
  const isShadowed = receivedShadows.find((one) => one.light === light)?.isShadowed;
  if (!isShadowed) return { direction, arriving };
  return {
    direction: select(isShadowed, acrossLight(direction), direction).toVar(),
    arriving: select(isShadowed, vec3(0), arriving),
  };
}

interface Incident {
  direction: Value;
  arriving: Value;
}

/** The direction to a light from this fragment, view space, and the colour that arrives. */
function incident(light: Light, values: LightValues): Incident {
  if (!hasPlace(light)) return { direction: values.direction, arriving: values.color };
  const way = values.position.sub(positionView).toVar();
  const away = length(way).toVar();
  const direction = way.div(away).toVar();
  const left = fallOff(away, values).toVar();
  if ('isSpotLight' in light) {
    left.mulAssign(smoothstep(values.coneCosine, values.penumbraCosine, dot(direction, values.direction)));
  }
  return { direction, arriving: values.color.mul(left) };
}

/** Algorithm 1 for one light, as in the paper. */
function bitangentOfOne(
  n: Value,
  light: Light,
  viewToObject: Value,
  receivedShadows: readonly ReceivedShadow[],
): Orientation {
  const { direction } = turnInShadow(incident(light, valuesFor(light)), light, receivedShadows);
  const l = viewToObject.mul(direction).toVar();
  const projected = l.sub(n.mul(dot(l, n))).toVar();
  // L ∥ N: the lit pole is white and the unlit one black, so any tangent will do.
  const isSeen = dot(projected, projected).greaterThan(dot(l, l).mul(PARALLEL_SQUARED_SINE));
  const chosen = select(isSeen, projected, anyTangent(n)).toVar();
  return { bitangent: chosen.mul(inverseSqrt(dot(chosen, chosen))).toVar(), crossing: float(0) };
}

interface LightSums {
  n: Value;
  /** An orthonormal basis of the tangent plane. */
  e1: Value;
  e2: Value;
  /** Σ w (lx² − ly², 2 lx ly) */
  tensor: Value;
  /** Σ w l */
  sum: Value;
  /** Σ w |l|² */
  extent: Value;
  /** Σ w */
  weight: Value;
}

function addLight(o: LightSums, toLight: Value, arriving: Value, emitted: Value): void {
  const direction = normalize(toLight).toVar();
  const l = vec2(dot(direction, o.e1), dot(direction, o.e2)).toVar();
  const facing = max(dot(direction, o.n).add(BEHIND_TERMINATOR), 0);
  const w = lightLuminance(arriving).mul(facing).add(lightLuminance(emitted).mul(UNLIT_WEIGHT)).toVar();
  o.tensor.addAssign(vec2(l.x.mul(l.x).sub(l.y.mul(l.y)), l.x.mul(l.y).mul(2)).mul(w));
  o.sum.addAssign(l.mul(w));
  o.extent.addAssign(dot(l, l).mul(w));
  o.weight.addAssign(w);
}

/**
 * @param n unit normal, object space
 * @param lights of the scene
 * @param viewToObject linear part
 * @param receivedShadows lights that cast shadows
 */
export function lightBitangent(
  n: Value,
  lights: readonly Light[],
  viewToObject: Value,
  receivedShadows: readonly ReceivedShadow[],
): Orientation {
  const directed = directedLights(lights);
  if (directed.length === 1) return bitangentOfOne(n, directed[0], viewToObject, receivedShadows);
  const e1 = normalize(anyTangent(n)).toVar();
  const e2 = cross(n, e1).toVar();
  const o: LightSums = {
    ...{ n, e1, e2, tensor: vec2(0).toVar(), sum: vec2(0).toVar() },
    ...{ extent: float(0).toVar(), weight: float(0).toVar() },
  };
  for (const light of directed) {
    const values = valuesFor(light);
    const { direction, arriving } = turnInShadow(incident(light, values), light, receivedShadows);
    addLight(o, viewToObject.mul(direction), arriving, values.color);
  }
  if (directed.length === 0) {
    // A hemisphere light gives a direction only if there is no other light.
    for (const light of lights.filter((one) => 'isHemisphereLight' in one)) {
      const { direction, color } = valuesFor(light);
      addLight(o, viewToObject.mul(direction), color, color);
    }
  }
  const amplitude = length(o.tensor).toVar();
  // Lights along the normal give no direction, so they do not disagree.
  const least = o.weight.mul(PARALLEL_SQUARED_SINE).toVar();
  const disagreement = max(amplitude.div(max(o.extent, 1e-20)).oneMinus(), 0);
  const crossing = select(o.extent.greaterThan(least), disagreement, float(0)).toVar();
  // Half of the doubled angle without trigonometry, from the side without cancellation.
  const { x, y } = o.tensor;
  const half = select(x.greaterThanEqual(0), vec2(amplitude.add(x), y), vec2(y, amplitude.sub(x))).toVar();
  const b = normalize(select(dot(half, o.sum).lessThan(0), half.negate(), half)).toVar();
  const bitangent = select(amplitude.greaterThan(least), e1.mul(b.x).add(e2.mul(b.y)), e1).toVar();
  return { bitangent, crossing };
}
