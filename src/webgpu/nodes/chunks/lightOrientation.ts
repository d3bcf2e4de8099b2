/**
 * The twin of shaders/chunks/lightOrientation.glsl: the direction from which a surface is lit, in its tangent plane: B of Algorithm 1. Of several
 * lights it is a direction known up to its sign, whose sign follows their weighted sum.
 */
import type { Light } from 'three';
import { directedLights, hasPlace } from '../base/directedLights.js';
import type { ToldLight } from '../base/ToldLight.js';
import { tsl, type Value } from '../base/values.js';
import { lightLuminance } from './lightLuminance.js';
import { fallOff, type LightValues, valuesFor } from './meanLight.js';

const { abs, cameraViewMatrix, cross, dot, float, inverseSqrt, length, max, normalize, positionView, select } = tsl;
const { smoothstep, vec2, vec3 } = tsl;

/** Below this squared sine of the angle between light and normal, the light gives no direction. */
const PARALLEL_SQUARED_SINE = 1e-8;
/** What a light weighs where it does not reach: a cone or a terminator must not leave strokes without a direction. */
const UNLIT_WEIGHT = 1e-4;
/** The cosine by which a light still counts beyond its terminator, so that strokes do not lose their direction right there. */
const BEHIND_TERMINATOR = 0.05;

/** Where strokes run, and how far the lights disagree: 0 where they lie in one line, 1 where no direction prevails. */
export interface Orientation {
  bitangent: Value;
  crossing: Value;
}

/** A vector perpendicular to n, not of unit length, and never short. */
export const anyTangent = (n: Value): Value =>
  select(abs(n.x).greaterThan(abs(n.z)), vec3(n.y.negate(), n.x, 0), vec3(0, n.z.negate(), n.y));

/** Where a light does not arrive strokes run across it. Its pole lies elsewhere, so no whirl of strokes is left in the shadow. @param toLight unit, view space */
function acrossLight(toLight: Value): Value {
  const [right, up] = [0, 1].map((column) => cameraViewMatrix.element(column).xyz);
  return normalize(cross(toLight, select(abs(dot(toLight, up)).lessThan(0.9), up, right)));
}

/** What a light is for strokes where it is known whether it arrives. */
function turnInShadow({ direction, arriving }: Incident, light: Light, told: readonly ToldLight[]): Incident {
  const isShadowed = told.find((one) => one.light === light)?.isShadowed;
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

/** The direction to a light from this fragment, view space, and what of it arrives. */
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

/** Algorithm 1 as it stands. */
function bitangentOfOne(n: Value, light: Light, viewToObject: Value, told: readonly ToldLight[]): Orientation {
  const { direction } = turnInShadow(incident(light, valuesFor(light)), light, told);
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
 * @param told of shadows
 */
export function lightBitangent(
  n: Value,
  lights: readonly Light[],
  viewToObject: Value,
  told: readonly ToldLight[],
): Orientation {
  const directed = directedLights(lights);
  if (directed.length === 1) return bitangentOfOne(n, directed[0], viewToObject, told);
  const e1 = normalize(anyTangent(n)).toVar();
  const e2 = cross(n, e1).toVar();
  const o: LightSums = {
    ...{ n, e1, e2, tensor: vec2(0).toVar(), sum: vec2(0).toVar() },
    ...{ extent: float(0).toVar(), weight: float(0).toVar() },
  };
  for (const light of directed) {
    const values = valuesFor(light);
    const { direction, arriving } = turnInShadow(incident(light, values), light, told);
    addLight(o, viewToObject.mul(direction), arriving, values.color);
  }
  if (directed.length === 0) {
    // A sky alone still has an up; beside a real light it is only fill.
    for (const light of lights.filter((one) => 'isHemisphereLight' in one)) {
      const { direction, color } = valuesFor(light);
      addLight(o, viewToObject.mul(direction), color, color);
    }
  }
  const amplitude = length(o.tensor).toVar();
  // Lights in line with the normal say nothing, so they do not disagree either.
  const least = o.weight.mul(PARALLEL_SQUARED_SINE).toVar();
  const disagreement = max(float(1).sub(amplitude.div(max(o.extent, 1e-20))), 0);
  const crossing = select(o.extent.greaterThan(least), disagreement, float(0)).toVar();
  // Half of the doubled angle without trigonometry, from the side on which nothing cancels.
  const { x, y } = o.tensor;
  const half = select(x.greaterThanEqual(0), vec2(amplitude.add(x), y), vec2(y, amplitude.sub(x))).toVar();
  const b = normalize(select(dot(half, o.sum).lessThan(0), half.negate(), half)).toVar();
  const bitangent = select(amplitude.greaterThan(least), e1.mul(b.x).add(e2.mul(b.y)), e1).toVar();
  return { bitangent, crossing };
}
