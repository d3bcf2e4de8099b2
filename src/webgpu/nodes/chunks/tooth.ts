/**
 * Counterpart of shaders/chunks/tooth.glsl: the tooth of paper, fixed to the screen. In the tiles of a larger picture it is fixed to the
 * whole picture.
 */
import { TOOTH_MAP_BUMP, TOOTH_MAP_SIZE } from '../../../material/tam/patternSizes.js';
import { blankTooth } from '../base/blankTextures.js';
import { hatchingTexture } from '../base/textures.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { float, fract, inverseSqrt, select, smoothstep } = tsl;

/** A standard normal field, low where paper fibres rise. */
const toothMap = /* @__PURE__ */ hatchingTexture('toothMap', blankTooth);
/** Offset of this picture in a larger one, pixels. */
const toothOffset = /* @__PURE__ */ hatchingUniform('toothOffset', 'vec2');
/** Pixels per bump. */
const toothSize = /* @__PURE__ */ hatchingUniform('toothSize', 'float');

/** The share of variance that neighbouring texels of the map do not share. */
const TOOTH_UNSHARED = 3 / 19;

/**
 * Bumps larger than DETAIL_FROM pixels, as in a print, get smaller ones on top, or the interpolation of the map would show: DETAIL_FINER
 * times as fine, and of strength DETAIL from DETAIL_TO pixels on.
 */
const DETAIL_FROM = 3;
const DETAIL_TO = 9;
const DETAIL = 0.6;
const DETAIL_FINER = 3.7;

/** @param pixel of the render target, counted from the lower left. @param size pixels per bump */
function toothOf(pixel: Value, size: Value): Value {
  const texel = pixel.add(toothOffset).div(size).mul(TOOTH_MAP_BUMP).toVar();
  const encoded = toothMap.sample(texel.div(TOOTH_MAP_SIZE)).level(0).x;
  // Restores the variance lost by interpolation.
  const between = fract(texel.sub(0.5)).toVar();
  const variance = float(1)
    .sub(between.mul(between.oneMinus()).mul(2 * TOOTH_UNSHARED))
    .toVar();
  return encoded
    .mul(6)
    .sub(3)
    .mul(inverseSqrt(variance.x.mul(variance.y)));
}

/** @param pixel of the render target, counted from the lower left */
export function toothField(pixel: Value): Value {
  const detail = smoothstep(DETAIL_FROM, DETAIL_TO, toothSize).mul(DETAIL).toVar();
  const coarse = toothOf(pixel, toothSize).toVar();
  // At another scale the map counts as independent: variances add.
  const fine = detail.mul(toothOf(pixel, toothSize.div(DETAIL_FINER)));
  const both = coarse.add(fine).mul(inverseSqrt(detail.mul(detail).add(1)));
  return select(detail.equal(0), coarse, both);
}
