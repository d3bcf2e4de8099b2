/** Counterpart of shaders/shadowMaps/depth.glsl: the light that passes a shadow map to a point at a depth. */
import type { Texture } from 'three';
import { threeNodes, tsl, type Value } from '../base/values.js';
import type { ShadowValues } from './ShadowValues.js';

const { cubeTexture, texture } = threeNodes;
const { abs, float, max, normalize, select, vec2 } = tsl;

/** A shadow map and its format. */
export interface ShadowMap {
  /** Depths, read through a comparison sampler; or moments of depths. */
  texture: Texture;
  hasMoments: boolean;
  /** Whether larger depths are nearer. */
  isReversed: boolean;
}

interface Comparing {
  compare(depth: Value): Value;
}

/** @param place position on the map, from above */
export const compareFlat = (map: ShadowMap, place: Value, depth: Value): Value =>
  (texture(map.texture, place as never) as unknown as Comparing).compare(depth);

export const compareCube = (map: ShadowMap, direction: Value, depth: Value): Value =>
  (cubeTexture(map.texture as never, direction as never) as unknown as Comparing).compare(depth);

/** The share of the depths around a place that lie beyond a depth. @param moments mean and standard deviation of the depths */
function passesMoments(moments: Value, depth: Value, isReversed: boolean): Value {
  const beyond = (isReversed ? moments.x.sub(depth) : depth.sub(moments.x)).toVar();
  const variance = max(moments.y.mul(moments.y), 1e-8).toVar();
  return select(beyond.greaterThan(0), variance.div(variance.add(beyond.mul(beyond))), float(1));
}

/** The depth for the comparison, biased. */
export const biased = ({ isReversed }: ShadowMap, depth: Value, bias: Value): Value =>
  isReversed ? depth.sub(bias) : depth.add(bias);

/** @param at homogeneous position in the map. Outside the map all light passes. */
export function passesFlat(map: ShadowMap, at: Value, depth: Value): Value {
  const place = at.xy.div(at.w).toVar();
  const fromAbove = vec2(place.x, float(1).sub(place.y)).toVar();
  const there = map.hasMoments
    ? passesMoments((texture(map.texture, fromAbove as never) as unknown as Value).toVar(), depth, map.isReversed)
    : compareFlat(map, fromAbove, depth);
  const away = abs(place.sub(0.5)).toVar();
  return select(max(away.x, away.y).greaterThan(0.5), float(1), there);
}

/**
 * The depth of a point on the face of the cube map that shows it, measured along the axis of the face. @param fromLight vector to the point
 */
export function depthOnFace({ isReversed }: ShadowMap, fromLight: Value, { near, far, bias }: ShadowValues): Value {
  const size = abs(fromLight).toVar();
  const alongFace = max(max(max(size.x, size.y), size.z), near);
  const depth = far
    .mul(float(1).sub(near.div(alongFace)))
    .div(far.sub(near))
    .add(bias);
  return isReversed ? float(1).sub(depth) : depth;
}

/** @param towards direction, of any length @param lightDistance distance of the point */
export function passesCube(map: ShadowMap, towards: Value, lightDistance: Value, values: ShadowValues): Value {
  const direction = normalize(towards).toVar();
  return compareCube(map, direction, depthOnFace(map, direction.mul(lightDistance).toVar(), values));
}
