/** Counterpart of shaders/shadowMaps/bilinearFlat.glsl: the four nearest texels, blended. */
import { tsl, type Value } from '../base/values.js';
import { compareFlat, type ShadowMap } from './depth.js';
import type { ShadowValues } from './ShadowValues.js';

const { floor, fract, mix, vec2 } = tsl;

/** @param coord three.js' shadow coordinate: position on the map, from above, and depth */
export function bilinearFlat(map: ShadowMap, coord: Value, { mapSize }: ShadowValues): Value {
  const texel = coord.xy.mul(mapSize).sub(0.5).toVar();
  const share = fract(texel).toVar();
  const corner = floor(texel).add(0.5).toVar();
  const row = (y: number): Value => {
    const [left, right] = [0, 1].map((x) => compareFlat(map, corner.add(vec2(x, y)).div(mapSize), coord.z));
    return mix(left, right, share.x);
  };
  return mix(row(0), row(1), share.y);
}
