import { blankThresholdMap } from '../../../material/hatchingUniforms.js';
import { hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { type TextureValue, tsl, type Value } from '../base/values.js';

const { clamp, dot, exp2, floor, fract, inverseSqrt, log2, min, mix, vec2, vec3, vec4 } = tsl;

/** Counterpart of shaders/chunks/levelByDepth.glsl: the level of a map by the depth of the fragment. */

export const tilesPerObjectUnit: Value = /* @__PURE__ */ hatchingUniform('tilesPerObjectUnit', 'float');
const texelPixels = /* @__PURE__ */ hatchingUniform('texelPixels', 'float');

/** The level of a map for the depth of the fragment (paper, section 3.4). @param size texels per tile */
export const levelByDepth = (size: Value, unitsPerPixel: Value): Value =>
  log2(tilesPerObjectUnit.mul(unitsPerPixel).mul(size).mul(texelPixels)).toVar();

/**
 * Counterpart of shaders/chunks/thresholdMap.glsl. The threshold map has the tone from which on each texel of the hatch is ink. Its levels
 * lie side by side in one texture; the green channel of each holds the next coarser level.
 */

export const thresholdMapSize = /* @__PURE__ */ hatchingUniform('thresholdMapSize', 'float');
const thresholdMapTexel = /* @__PURE__ */ hatchingUniform('thresholdMapTexel', 'vec2');
const thresholdMapLevels = /* @__PURE__ */ hatchingUniform('thresholdMapLevels', 'float');
const thresholdMoments = /* @__PURE__ */ hatchingUniform('thresholdMoments', 'vec3');

let map: TextureValue | undefined;

/** The node of the map, shared by all programs. */
function thresholdMap(): TextureValue {
  map ??= hatchingTexture('thresholdMap', blankThresholdMap());
  return map;
}

export interface ThresholdLevel {
  /** Its lower left corner in the texture, texels. */
  corner: Value;
  /** Its side, texels. */
  side: Value;
  /** Share of the next coarser level. */
  share: Value;
  /** Factor that restores the variance lost by interpolation. */
  contrast: Value;
  mixing: Value;
}

/** The level that compensates for strokes that are too fine by so many octaves on level 0. */
export const levelFor = (octaves: Value): Value => clamp(octaves, 0, thresholdMapLevels.sub(1));

/** The level and the share of the next one, for interpolation between their fields. */
export function chooseLevel(level: Value): ThresholdLevel {
  const finer = floor(level).toVar();
  const share = level.sub(finer).toVar();
  const rest = share.oneMinus().toVar();
  const variance = dot(thresholdMoments, vec3(rest.mul(rest), share.mul(share), rest.mul(share).mul(2)));
  const size = thresholdMapSize.mul(exp2(finer.negate())).toVar();
  // Each level has a margin of one texel.
  const corner = vec2(thresholdMapSize.sub(size).add(finer).mul(2).add(1), 1);
  return {
    corner: corner.mul(thresholdMapTexel).toVar(),
    side: thresholdMapTexel.mul(size).toVar(),
    share,
    contrast: inverseSqrt(variance).toVar(),
    mixing: rest
      .mul(share)
      .mul(4)
      .mul(min(share.mul(2), 1))
      .toVar(),
  };
}

/** The field of four samples, blended by weights. */
export function blendedField(places: readonly Value[], weights: Value, level: ThresholdLevel): Value {
  const components = [weights.x, weights.y, weights.z, weights.w];
  const blended = vec2(0).toVar();
  for (const [i, uv] of places.entries()) {
    const texel = thresholdMap()
      .sample(level.corner.add(level.side.mul(fract(uv))))
      .level(0);
    blended.addAssign(components[i].mul(texel.xy));
  }
  const g = mix(blended.x, blended.y, level.share)
    .mul(6)
    .sub(dot(weights, vec4(1)).mul(3));
  return level.contrast.mul(g).mul(inverseSqrt(dot(weights, weights)));
}
