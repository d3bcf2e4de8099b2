/** Counterpart of shaders/chunks/strokeShadows.glsl: shadows in places along a stroke of a hand, so that it ends at their edges, and is not cut. */
import { type ReceivedShadow, valuesFor } from '../base/lights.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import type { ShadowLookup } from './shadowFilters.js';

const { abs, cameraViewMatrix, float, length, max, select, vec2, vec4 } = tsl;
const { lightShadowMatrix } = threeNodes;

/** A shadow at whose edges strokes end. */
type Cast = ReceivedShadow & { lookup: ShadowLookup; sent: Value };

/** Transforms a direction from view to world space. */
const inWorld = (direction: Value): Value => vec4(direction, 0).mul(cameraViewMatrix).xyz;

/** The share of a light that passes a flat map to a place. @param at homogeneous position in the map */
function passesFlat({ passes }: ShadowLookup, at: Value): Value {
  const place = at.xyz.div(at.w).toVar();
  const away = abs(place.sub(0.5)).toVar();
  const isOffMap = at.w.lessThanEqual(0).or(max(max(away.x, away.y), away.z).greaterThan(0.5));
  return select(isOffMap, float(1), passes(at, place.z));
}

/** The share of a light that passes its map to a place. @param viewPosition of it @param up the normal there, world space */
function passing({ light, lookup }: Cast, viewPosition: Value, up: Value): Value {
  const { values, passes } = lookup;
  const moved = up.mul(values.normalBias);
  if ('isPointLight' in light) {
    const fromLamp = inWorld(viewPosition.sub(valuesFor(light).position))
      .add(moved)
      .toVar();
    return passes(vec4(fromLamp, 0), length(fromLamp));
  }
  const matrix = lightShadowMatrix(light as never) as unknown as Value;
  const point = inWorld(viewPosition.sub(cameraViewMatrix.element(3).xyz));
  return passesFlat(lookup, matrix.mul(vec4(point.add(moved), 1)).toVar());
}

/** The shadows at whose edges strokes end. */
export interface CastShadows {
  /** The share of it that shadows take here. */
  takenHere: Value;
  /**
   * The share of it that shadows take at a place near this fragment, without soft edges.
   *
   * @param viewPosition and `normal`: view space
   */
  at(viewPosition: Value, normal: Value): Value;
  /**
   * The counterpart of `tonesOfShadows` in shaders/chunks/handStrokes.glsl: the tone of a surface without these shadows, and that in all of
   * them.
   *
   * @param open the share of directed light that occlusion leaves
   * @param toneOf the tone of the surface under lights of some radiance
   */
  tonesOf(radiance: Value, open: Value, toneOf: (radiance: Value) => Value): Value;
}

/** Undefined where no shadow map can be read. */
export function castShadowsOf(receivedShadows: readonly ReceivedShadow[]): CastShadows | undefined {
  const lights = receivedShadows.filter((one): one is Cast => one.sent !== null && one.lookup !== null);
  if (lights.length === 0) return undefined;
  const here = lights
    .map(({ sent, shadow }) => vec2(1, shadow).mul(sent))
    .reduce((sum, one) => sum.add(one))
    .toVar();
  const shareOf = (taken: Value): Value =>
    select(here.x.greaterThan(0), taken.div(max(here.x, 1e-20)), float(0)).toVar();
  return {
    takenHere: shareOf(here.x.sub(here.y)),
    at(viewPosition, normal) {
      const up = inWorld(normal).toVar();
      const taken = float(0).toVar();
      for (const received of lights) {
        const { intensity } = received.lookup.values;
        taken.addAssign(received.sent.mul(intensity).mul(passing(received, viewPosition, up).oneMinus()));
      }
      return shareOf(taken);
    },
    tonesOf(radiance, open, toneOf) {
      const ofThese = open.mul(here).toVar();
      const shaded = radiance.sub(ofThese.y).toVar();
      return vec2(toneOf(shaded.add(ofThese.x)), toneOf(shaded));
    },
  };
}
