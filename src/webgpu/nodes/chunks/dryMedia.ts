/** Pencil, charcoal and chalk on the tooth of paper. */
import { TOOTH_MAP_BUMP, TOOTH_MAP_SIZE } from '../../../material/tam/patternSizes.js';
import { normalDistribution } from '../base/maths.js';
import { blankTooth, hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { crowdedShare, darkenedFrom, type HatchField, unskew } from './ink.js';

const { dot, fract, inverseSqrt, max, mix, pow, select, smoothstep, vec2 } = tsl;

/**
 * Counterpart of shaders/chunks/dryMedia.glsl: pencil, charcoal, chalk. The darkness of a stroke grows with its pressure, which is the
 * tone, and depends on the tooth of the paper.
 */

const paperGrain = /* @__PURE__ */ hatchingUniform('paperGrain', 'float');
const softness = /* @__PURE__ */ hatchingUniform('softness', 'float');
const smudge = /* @__PURE__ */ hatchingUniform('smudge', 'float');

/** Grain with edges as sharp as a pixel would flicker. */
const LEAST_SOFTNESS = 0.1;
/** The shares by which tooth and smudge decrease up to full tone, where the hand presses harder. */
const PRESSED = [0.5, 0.25] as const;

/**
 * The darkness ∈ [0, 1] of a dry medium for a field and a tone. As with ink, its mean is the tone.
 *
 * @param pixel of the render target, counted from the lower left
 */
export function inkAt(field: HatchField, tone: Value, crowding: Value, pixel: Value): Value {
  const squared = tone.mul(tone).toVar();
  // With tooth 1, grain is not reduced.
  const grain = paperGrain.mul(squared.mul(PRESSED[0]).mul(paperGrain.oneMinus()).oneMinus()).toVar();
  // A smudged tone and a drawn one, printed over one another, give the tone.
  const blank = max(tone.oneMinus(), 1e-6).toVar();
  const share = smudge.mul(squared.mul(PRESSED[1]).oneMinus()).toVar();
  const rubbed = pow(blank, share).oneMinus().toVar();
  const drawn = pow(blank, share.oneMinus()).oneMinus().toVar();
  const crowded = crowdedShare(crowding).toVar();
  const shares = vec2(grain.oneMinus().mul(crowded.oneMinus()), grain).toVar();
  shares.assign(shares.mul(inverseSqrt(max(dot(shares, shares), 1e-8))));
  const g = dot(shares, vec2(field.g, toothField(pixel)));
  // The skew of a sum is that of one field times the cube of its share.
  const skew = field.mixing.mul(shares.x).mul(shares.x).mul(shares.x);
  // The edge has a fixed width: one that depends on the slope of the field would be too wide where the field is steep, and shift the mean.
  const h = unskew(normalDistribution(g).x.toVar(), skew).toVar();
  const grained = darkenedFrom(h, drawn, max(softness, LEAST_SOFTNESS).toVar());
  // Without tooth, crowded strokes become a flat tone.
  const left = mix(grained, drawn, crowded.mul(grain.oneMinus()));
  return rubbed.oneMinus().mul(left.oneMinus()).oneMinus().toVar();
}

/**
 * Counterpart of shaders/chunks/tooth.glsl: the tooth of paper, fixed to the screen. In the tiles of a larger picture it is fixed to the
 * whole picture.
 */

const toothMap = /* @__PURE__ */ hatchingTexture('toothMap', blankTooth);
const toothOffset = /* @__PURE__ */ hatchingUniform('toothOffset', 'vec2');
const paperGrainSize = /* @__PURE__ */ hatchingUniform('paperGrainSize', 'float');

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
  const variance = between
    .mul(between.oneMinus())
    .mul(2 * TOOTH_UNSHARED)
    .oneMinus()
    .toVar();
  return encoded
    .mul(6)
    .sub(3)
    .mul(inverseSqrt(variance.x.mul(variance.y)));
}

/** @param pixel of the render target, counted from the lower left */
export function toothField(pixel: Value): Value {
  const detail = smoothstep(DETAIL_FROM, DETAIL_TO, paperGrainSize).mul(DETAIL).toVar();
  const coarse = toothOf(pixel, paperGrainSize).toVar();
  // At another scale the map counts as independent: variances add.
  const fine = detail.mul(toothOf(pixel, paperGrainSize.div(DETAIL_FINER)));
  const both = coarse.add(fine).mul(inverseSqrt(detail.mul(detail).add(1)));
  return select(detail.equal(0), coarse, both);
}
