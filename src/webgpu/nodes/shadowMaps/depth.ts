/** The twin of shaders/shadowMaps/depth.glsl: how much light passes a shadow map to a point beyond a depth. */
import type { Texture } from 'three';
import { threeNodes, tsl, type Value } from '../base/values.js';
import type { ShadowValues } from './ShadowValues.js';

const { cubeTexture, texture } = threeNodes;
const { abs, float, max, normalize, select, vec2 } = tsl;

/** A shadow map, and how it is kept. */
export interface ShadowMap {
  /** Depths, which a sampler compares; or moments of them. */
  texture: Texture;
  hasMoments: boolean;
  /** Whether larger depths are nearer. */
  isReversed: boolean;
}

interface Comparing {
  compare(depth: Value): Value;
}

/** @param place on the map, from above */
export const compareFlat = (map: ShadowMap, place: Value, depth: Value): Value =>
  (texture(map.texture, place as never) as unknown as Comparing).compare(depth);

export const compareCube = (map: ShadowMap, direction: Value, depth: Value): Value =>
  (cubeTexture(map.texture as never, direction as never) as unknown as Comparing).compare(depth);

/** @param moments mean and standard deviation of depths around a place. The share of them that lies beyond a depth, if there are two of them */
function passesMoments(moments: Value, depth: Value, isReversed: boolean): Value {
  const beyond = (isReversed ? moments.x.sub(depth) : depth.sub(moments.x)).toVar();
  const variance = max(moments.y.mul(moments.y), 1e-8).toVar();
  return select(beyond.greaterThan(0), variance.div(variance.add(beyond.mul(beyond))), float(1));
}

/** The depth as it is compared. */
export const biased = ({ isReversed }: ShadowMap, depth: Value, bias: Value): Value =>
  isReversed ? depth.sub(bias) : depth.add(bias);

/** @param at in the map, with w. Nothing lies outside the map. */
export function passesFlat(map: ShadowMap, at: Value, depth: Value): Value {
  const place = at.xy.div(at.w).toVar();
  const fromAbove = vec2(place.x, float(1).sub(place.y)).toVar();
  const there = map.hasMoments
    ? passesMoments((texture(map.texture, fromAbove as never) as unknown as Value).toVar(), depth, map.isReversed)
    : compareFlat(map, fromAbove, depth);
  const away = abs(place.sub(0.5)).toVar();
  return select(max(away.x, away.y).greaterThan(0.5), float(1), there);
}

/** The depth of a point on the face of a cube that it is seen on, which measures depth along its own axis. @param fromLight to the point */
export function depthOnFace({ isReversed }: ShadowMap, fromLight: Value, { near, far, bias }: ShadowValues): Value {
  const size = abs(fromLight).toVar();
  const alongFace = max(max(max(size.x, size.y), size.z), near);
  const depth = far
    .mul(float(1).sub(near.div(alongFace)))
    .div(far.sub(near))
    .add(bias);
  return isReversed ? float(1).sub(depth) : depth;
}

/** @param towards of any length @param lightDistance of the point */
export function passesCube(map: ShadowMap, towards: Value, lightDistance: Value, values: ShadowValues): Value {
  const direction = normalize(towards).toVar();
  return compareCube(map, direction, depthOnFace(map, direction.mul(lightDistance).toVar(), values));
}
