/** Counterpart of shaders/shadowMaps/bilinearCube.glsl: the four nearest texels on a face of a cube, blended. */
import { tsl, type Value } from '../base/values.js';
import { compareCube, depthOnFace, type ShadowMap } from './depth.js';
import type { ShadowValues } from './ShadowValues.js';

const { abs, dot, floor, fract, max, mix, select, vec2, vec3 } = tsl;

/** @param fromLight to the place, world space */
export function bilinearCube(map: ShadowMap, fromLight: Value, values: ShadowValues): Value {
  const size = abs(fromLight).toVar();
  const largest = max(max(size.x, size.y), size.z).toVar();
  const isX = size.x.equal(largest).toVar();
  const own = select(isX, vec3(1, 0, 0), select(size.y.equal(largest), vec3(0, 1, 0), vec3(0, 0, 1))).toVar();
  // Texels lie in rows along the two axes that are not the face's own.
  const row = select(isX, vec3(0, 1, 0), vec3(1, 0, 0)).toVar();
  const column = vec3(1).sub(own).sub(row).toVar();
  const onFace = fromLight.div(largest).toVar();
  const texel = onFace.mul(0.5).add(0.5).mul(values.mapSize.x).sub(0.5).toVar();
  const share = vec2(dot(fract(texel), row), dot(fract(texel), column)).toVar();
  const width = values.mapSize.x.mul(0.5).toVar();
  const corner = mix(floor(texel).add(0.5).div(width).sub(1), onFace, own).toVar();
  const depth = depthOnFace(map, fromLight, values).toVar();
  const passes = (x: number, y: number): Value =>
    compareCube(map, corner.add(row.mul(x).add(column.mul(y)).div(width)), depth);
  return mix(mix(passes(0, 0), passes(1, 0), share.x), mix(passes(0, 1), passes(1, 1), share.x), share.y);
}
