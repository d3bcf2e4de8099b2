/**
 * Counterpart of shaders/chunks/softShadows.glsl: shadows whose edges widen and whose tone dissolves with the distance from the occluder.
 */
import type { Light, LightShadow } from 'three';
import { SHADOW_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { hasPlace } from '../base/directedLights.js';
import { hatchingUniform } from '../base/uniforms.js';
import { threeNodes, tsl, type Value } from '../base/values.js';
import { biased, passesCube, passesFlat, type ShadowMap } from '../shadowMaps/depth.js';
import { type ShadowValues, shadowValuesFor } from '../shadowMaps/ShadowValues.js';
import { valuesFor } from './meanLight.js';
import { type Rays, shadowFade, shadowSearch, shadowSoftness } from './shadowSearch.js';

const { lightShadowMatrix } = threeNodes;
const { abs, cameraViewMatrix, cross, float, If, length, max, mix, normalize, positionView, positionWorld } = tsl;
const { select, vec2, vec3, vec4 } = tsl;
const { FARTHEST_CASTER, OVERHEAD } = SHADOW_CONSTANTS;

/** Tone of a full shadow where it touches its occluder. */
export const shadowTone: Value = /* @__PURE__ */ hatchingUniform('shadowTone', 'float');

/**
 * The share of the tone of all shadows that is left. @param taken luminance that they take @param lost the part of it that has dissolved
 */
export const shadowLeft = (taken: Value, lost: Value): Value =>
  select(taken.greaterThan(0), float(1).sub(lost.div(max(taken, 1e-20))), float(1));

function raysTo(toLight: Value, width: Value, nearing: Value): Rays {
  const upright = select(abs(toLight.y).lessThan(OVERHEAD), vec3(0, 1, 0), vec3(1, 0, 0));
  const side = normalize(cross(toLight, upright)).toVar();
  const farthest = width.div(max(shadowFade, 1 / FARTHEST_CASTER)).toVar();
  return { farthest, width, nearing, side, up: cross(toLight, side).toVar() };
}

/** Transforms a direction from view to world space. */
const inWorld = (direction: Value): Value => vec4(direction, 0).mul(cameraViewMatrix).xyz.toVar();

/** Light that passes a flat map, and the share of tone left. @param matrix from world to map @param toLight unit, world space */
function flatShadow(map: ShadowMap, matrix: Value, toLight: Value, values: ShadowValues): Value {
  const read = vec2(1).toVar();
  const at = matrix.mul(vec4(positionWorld, 1)).toVar();
  const away = abs(at.xyz.div(at.w).sub(0.5)).toVar();
  const isOnMap = at.w.greaterThan(0).and(max(max(away.x, away.y), away.z).lessThanEqual(0.5));
  If(isOnMap, () => {
    // The width of the map across the light at this distance is at.w divided by the length of this vector.
    const [row, lastRow] = (['x', 'w'] as const).map((c) => vec3(...[0, 1, 2].map((i) => matrix.element(i)[c])));
    const towards = matrix.mul(vec4(toLight, 0)).toVar();
    const width = at.w.div(length(row.sub(lastRow.mul(0.5)))).toVar();
    const rays = raysTo(toLight, width, max(towards.w.negate().div(at.w), 0).toVar());
    const found = shadowSearch(rays, values, {
      place: (distance) => at.add(towards.mul(distance)),
      across: [matrix.mul(vec4(rays.side, 0)).toVar(), matrix.mul(vec4(rays.up, 0)).toVar()],
      depth: (distance) => at.z.add(towards.z.mul(distance)).div(at.w.add(towards.w.mul(distance))),
      passes: (place, depth) => passesFlat(map, place, biased(map, depth, values.bias)),
    });
    read.assign(found);
  });
  return read;
}

/** @param fromLight from the light to the point, world space */
function cubeShadow(map: ShadowMap, fromLight: Value, values: ShadowValues): Value {
  const size = abs(fromLight).toVar();
  const lightDistance = length(fromLight).toVar();
  const toLight = fromLight.div(lightDistance).negate().toVar();
  const width = max(max(size.x, size.y), size.z).mul(2).toVar();
  const rays = raysTo(toLight, width, float(1).div(lightDistance).toVar());
  return shadowSearch(rays, values, {
    place: (distance) => fromLight.add(toLight.mul(distance)),
    across: [rays.side, rays.up],
    depth: (distance) => lightDistance.sub(distance),
    passes: (place, distance) => passesCube(map, place, distance, values),
  });
}

/**
 * The soft shadow of one light at the fragment.
 *
 * @param filtered the light that passes with three.js' filter
 */
export function readSoftShadow(
  light: Light & { shadow: LightShadow },
  map: ShadowMap,
  filtered: () => Value,
): { shadow: Value; toneLeft: Value } {
  const { direction, position } = valuesFor(light);
  const values = shadowValuesFor(light.shadow);
  const way = (hasPlace(light) ? position.sub(positionView) : direction).toVar();
  const read = vec2(1).toVar();
  const shadow = float(1).toVar();
  If(max(shadowFade, shadowSoftness).greaterThan(0), () => {
    const matrix = lightShadowMatrix(light as never) as unknown as Value;
    const found =
      'isPointLight' in light
        ? cubeShadow(map, inWorld(way.negate()), values)
        : flatShadow(map, matrix, inWorld(normalize(way)), values);
    read.assign(found);
  });
  If(shadowSoftness.greaterThan(0), () => {
    shadow.assign(mix(1, read.x, values.intensity));
  }).Else(() => {
    shadow.assign(filtered());
  });
  return { shadow, toneLeft: read.y };
}
