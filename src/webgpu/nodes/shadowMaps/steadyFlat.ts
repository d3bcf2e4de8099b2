/** Counterpart of shaders/shadowMaps/steadyFlat.glsl: replaces three.js' five noisy samples of a flat shadow map. */
import { tsl, type Value } from '../base/values.js';
import { compareFlat, type ShadowMap } from './depth.js';
import type { ShadowValues } from './ShadowValues.js';
import { steadily } from './steadyKernel.js';

const { vec2 } = tsl;

/** @param coord three.js' shadow coordinate: position on the map, from above, and depth */
export const steadyFlat = (map: ShadowMap, coord: Value, { radius, mapSize }: ShadowValues): Value =>
  steadily(radius, (x, y) => compareFlat(map, coord.xy.add(vec2(x, y).div(mapSize)), coord.z));
