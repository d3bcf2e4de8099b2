/** Filters of shadow maps without noise. */
import type { LightShadow, Texture } from 'three';
import { SHADOW_CONSTANTS } from '../../../look/constants/shadingConstants.js';
import { threeNodes, tsl, type Value } from '../base/values.js';

const { cubeTexture, reference, renderGroup, texture } = threeNodes;
const { abs, ceil, clamp, cross, dot, float, floor, fract, int, length, Loop, max, mix, normalize, select, vec2 } = tsl;
const { vec3 } = tsl;

/** Uniforms of a shadow, shared by all programs. */
export interface ShadowValues {
  bias: Value;
  intensity: Value;
  /** Texels per side. */
  mapSize: Value;
  normalBias: Value;
  /** Texels. */
  radius: Value;
  /** Depth range of the shadow camera. */
  near: Value;
  far: Value;
}

const valuesOf = /* @__PURE__ */ new WeakMap<LightShadow, ShadowValues>();

export function shadowValuesFor(shadow: LightShadow): ShadowValues {
  const known = valuesOf.get(shadow);
  if (known) return known;
  const read = (name: string, type: 'float' | 'vec2', object: object = shadow): Value =>
    reference(name, type, object).setGroup(renderGroup) as unknown as Value;
  const made: ShadowValues = {
    bias: read('bias', 'float'),
    intensity: read('intensity', 'float'),
    mapSize: read('mapSize', 'vec2'),
    normalBias: read('normalBias', 'float'),
    radius: read('radius', 'float'),
    near: read('near', 'float', shadow.camera),
    far: read('far', 'float', shadow.camera),
  };
  valuesOf.set(shadow, made);
  return made;
}

/** Counterpart of shaders/shadowMaps/depth.glsl: the light that passes a shadow map to a point at a depth. */

/** A shadow map and its format. */
export interface ShadowMap {
  /** Depths, read through a comparison sampler; or moments of depths. */
  texture: Texture;
  hasMoments: boolean;
  isCube: boolean;
  /** Whether larger depths are nearer. */
  isReversed: boolean;
}

interface Comparing {
  compare(depth: Value): Value;
}

/** @param place position on the map, from above */
const compareFlat = (map: ShadowMap, place: Value, depth: Value): Value =>
  (texture(map.texture, place as never) as unknown as Comparing).compare(depth);

const compareCube = (map: ShadowMap, direction: Value, depth: Value): Value =>
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

/**
 * The depth of a point on the face of the cube map that shows it, measured along the axis of the face. @param fromLight vector to the point
 */
function depthOnFace({ isReversed }: ShadowMap, fromLight: Value, { near, far, bias }: ShadowValues): Value {
  const size = abs(fromLight).toVar();
  const alongFace = max(max(max(size.x, size.y), size.z), near);
  const depth = far.mul(near.div(alongFace).oneMinus()).div(far.sub(near)).add(bias);
  return isReversed ? depth.oneMinus() : depth;
}

/**
 * The light that passes to a point. Outside a flat map all light does.
 *
 * @param at homogeneous position in a flat map, or the direction in a cube, of any length
 * @param depth of the point: in a cube its distance from the light
 */
export function passes(map: ShadowMap, values: ShadowValues, at: Value, depth: Value): Value {
  if (map.isCube) {
    const direction = normalize(at.xyz).toVar();
    return compareCube(map, direction, depthOnFace(map, direction.mul(depth).toVar(), values));
  }
  const place = at.xy.div(at.w).toVar();
  const fromAbove = vec2(place.x, place.y.oneMinus()).toVar();
  const biasedDepth = biased(map, depth, values.bias);
  const there = map.hasMoments
    ? passesMoments((texture(map.texture, fromAbove as never) as unknown as Value).toVar(), biasedDepth, map.isReversed)
    : compareFlat(map, fromAbove, biasedDepth);
  const away = abs(place.sub(0.5)).toVar();
  return select(max(away.x, away.y).greaterThan(0.5), float(1), there);
}

/** How a shadow map is read at a place of its own. */
export interface ShadowLookup {
  values: ShadowValues;
  /** The light that passes to a point, as `passes` finds it. */
  passes(at: Value, depth: Value): Value;
}

export function lookupIn(map: ShadowMap, shadow: LightShadow): ShadowLookup {
  const values = shadowValuesFor(shadow);
  return { values, passes: (at, depth) => passes(map, values, at, depth) };
}

/** Counterpart of shaders/shadowMaps/steadyKernel.glsl: a tent filter with samples no more than a texel apart. */

const samplesAside = (radius: Value): Value => int(clamp(ceil(radius), 0, SHADOW_CONSTANTS.MOST_SAMPLES));

function tentWeight(x: Value, y: Value, span: Value): Value {
  const area = span.sub(abs(x)).mul(span.sub(abs(y)));
  return area.div(span.mul(span).mul(span).mul(span));
}

/**
 * The weighted mean of samples in a grid.
 *
 * @param radius of the grid, texels
 * @param passes the light that passes at an offset, texels
 */
export function steadily(radius: Value, passes: (x: Value, y: Value) => Value): Value {
  const n = samplesAside(radius).toVar();
  const span = float(n).add(1).toVar();
  const away = radius.div(max(span.sub(1), 1)).toVar();
  const sum = float(0).toVar();
  const range = (name: string): object => ({ start: n.negate(), end: n, type: 'int', condition: '<=', name });
  Loop(range('row'), ({ row }) => {
    Loop(range('column'), ({ column }) => {
      const [x, y] = [float(column).toVar(), float(row).toVar()];
      sum.addAssign(tentWeight(x, y, span).mul(passes(x.mul(away), y.mul(away))));
    });
  });
  return sum;
}

/** Counterpart of shaders/shadowMaps/bilinearFlat.glsl: the four nearest texels, blended. */

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

/** Counterpart of shaders/shadowMaps/bilinearCube.glsl: the four nearest texels on a face of a cube, blended. */

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

/** Counterpart of shaders/shadowMaps/steadyFlat.glsl: replaces three.js' five noisy samples of a flat shadow map. */

/** @param coord three.js' shadow coordinate: position on the map, from above, and depth */
export const steadyFlat = (map: ShadowMap, coord: Value, { radius, mapSize }: ShadowValues): Value =>
  steadily(radius, (x, y) => compareFlat(map, coord.xy.add(vec2(x, y).div(mapSize)), coord.z));

/** Counterpart of shaders/shadowMaps/steadyCube.glsl: replaces three.js' five noisy samples of a cube map. */

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
