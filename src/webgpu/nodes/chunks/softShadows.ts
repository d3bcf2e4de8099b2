/** The twin of shaders/chunks/softShadows.glsl: shadows alone, whose edges widen, and whose tone dissolves, with the distance from what casts them. */
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

/** Printed by a full shadow where it touches what casts it. */
export const shadowTone: Value = /* @__PURE__ */ hatchingUniform('shadowTone', 'float');

/** How much of the tone of all shadows is left. @param taken what they take of all lights @param lost how much of that has dissolved */
export const shadowLeft = (taken: Value, lost: Value): Value =>
  select(taken.greaterThan(0), float(1).sub(lost.div(max(taken, 1e-20))), float(1));

function raysTo(toLight: Value, width: Value, nearing: Value): Rays {
  const upright = select(abs(toLight.y).lessThan(OVERHEAD), vec3(0, 1, 0), vec3(1, 0, 0));
  const side = normalize(cross(toLight, upright)).toVar();
  const farthest = width.div(max(shadowFade, 1 / FARTHEST_CASTER)).toVar();
  return { farthest, width, nearing, side, up: cross(toLight, side).toVar() };
}

/** A direction in the view as it is in the world. */
const inWorld = (direction: Value): Value => vec4(direction, 0).mul(cameraViewMatrix).xyz.toVar();

/** What passes, and what is left. @param matrix from the world to the map @param toLight unit, world space */
function tellFlat(map: ShadowMap, matrix: Value, toLight: Value, values: ShadowValues): Value {
  const told = vec2(1).toVar();
  const at = matrix.mul(vec4(positionWorld, 1)).toVar();
  const away = abs(at.xyz.div(at.w).sub(0.5)).toVar();
  const isOnMap = at.w.greaterThan(0).and(max(max(away.x, away.y), away.z).lessThanEqual(0.5));
  If(isOnMap, () => {
    // What the map covers across the light is as wide, at this distance, as at.w over the length of this.
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
    told.assign(found);
  });
  return told;
}

/** @param fromLight to the point, world space */
function tellCube(map: ShadowMap, fromLight: Value, values: ShadowValues): Value {
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
 * What the map of one light tells of its shadow here.
 *
 * @param filtered how much passes as other surfaces receive it
 */
export function tellSoftShadow(
  light: Light & { shadow: LightShadow },
  map: ShadowMap,
  filtered: () => Value,
): { shadow: Value; toneLeft: Value } {
  const { direction, position } = valuesFor(light);
  const values = shadowValuesFor(light.shadow);
  const way = (hasPlace(light) ? position.sub(positionView) : direction).toVar();
  const told = vec2(1).toVar();
  const shadow = float(1).toVar();
  If(max(shadowFade, shadowSoftness).greaterThan(0), () => {
    const matrix = lightShadowMatrix(light as never) as unknown as Value;
    const found =
      'isPointLight' in light
        ? tellCube(map, inWorld(way.negate()), values)
        : tellFlat(map, matrix, inWorld(normalize(way)), values);
    told.assign(found);
  });
  If(shadowSoftness.greaterThan(0), () => {
    shadow.assign(mix(1, told.x, values.intensity));
  }).Else(() => {
    shadow.assign(filtered());
  });
  return { shadow, toneLeft: told.y };
}
