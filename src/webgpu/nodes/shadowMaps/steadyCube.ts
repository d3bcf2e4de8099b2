/** Counterpart of shaders/shadowMaps/steadyCube.glsl: replaces three.js' five noisy samples of a cube map. */
import { tsl, type Value } from '../base/values.js';
import { compareCube, depthOnFace, type ShadowMap } from './depth.js';
import type { ShadowValues } from './ShadowValues.js';
import { steadily } from './steadyKernel.js';

const { abs, cross, length, normalize, select, vec3 } = tsl;

/** @param fromLight to the place, world space */
export function steadyCube(map: ShadowMap, fromLight: Value, values: ShadowValues): Value {
  const distance = length(fromLight).toVar();
  const middle = fromLight.div(distance).toVar();
  const size = abs(middle).toVar();
  const aside = select(size.x.greaterThan(size.z), vec3(0, 1, 0), vec3(1, 0, 0));
  const tangent = normalize(cross(middle, aside)).toVar();
  const bitangent = cross(middle, tangent).toVar();
  const texel = values.mapSize.x;
  return steadily(values.radius, (x, y) => {
    // Each sample is compared with the depth of a point in its direction, as far from the light as the fragment.
    const direction = middle.add(tangent.mul(x).add(bitangent.mul(y)).div(texel)).toVar();
    return compareCube(map, direction, depthOnFace(map, direction.mul(distance).toVar(), values));
  });
}
