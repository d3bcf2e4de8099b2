/**
 * Counterpart of shaders/chunks/dryMedium.glsl: pencil, charcoal, chalk. The darkness of a stroke grows with its pressure, which is the
 * tone, and depends on the tooth of the paper.
 */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { crowdedShare, darkenedFrom, type HatchField, unskew } from './ink.js';
import { normalDistribution } from './normalDistribution.js';
import { toothField } from './tooth.js';

const { dot, float, inverseSqrt, max, mix, pow, vec2 } = tsl;

const tooth = /* @__PURE__ */ hatchingUniform('tooth', 'float');
const softness = /* @__PURE__ */ hatchingUniform('softness', 'float');
const smudge = /* @__PURE__ */ hatchingUniform('smudge', 'float');

/** Grain with edges as sharp as a pixel would flicker. */
const LEAST_SOFTNESS = 0.1;
/** The shares by which tooth and smudge decrease up to full tone, where the hand presses harder. */
const PRESSED = [0.5, 0.25] as const;

const oneMinus = (x: Value): Value => float(1).sub(x);

/**
 * The darkness ∈ [0, 1] of a dry medium for a field and a tone. As with ink, its mean is the tone.
 *
 * @param pixel of the render target, counted from the lower left
 */
export function inkAt(field: HatchField, tone: Value, crowding: Value, pixel: Value): Value {
  const squared = tone.mul(tone).toVar();
  // With tooth 1, grain is not reduced.
  const grain = tooth.mul(oneMinus(squared.mul(PRESSED[0]).mul(oneMinus(tooth)))).toVar();
  // A smudged tone and a drawn one, printed over one another, give the tone.
  const blank = max(oneMinus(tone), 1e-6).toVar();
  const share = smudge.mul(oneMinus(squared.mul(PRESSED[1]))).toVar();
  const rubbed = oneMinus(pow(blank, share)).toVar();
  const drawn = oneMinus(pow(blank, oneMinus(share))).toVar();
  const crowded = crowdedShare(crowding).toVar();
  const shares = vec2(oneMinus(grain).mul(oneMinus(crowded)), grain).toVar();
  shares.assign(shares.mul(inverseSqrt(max(dot(shares, shares), 1e-8))));
  const g = dot(shares, vec2(field.g, toothField(pixel)));
  // The skew of a sum is that of one field times the cube of its share.
  const skew = field.mixing.mul(shares.x).mul(shares.x).mul(shares.x);
  // The edge has a fixed width: one that depends on the slope of the field would be too wide where the field is steep, and shift the mean.
  const h = unskew(normalDistribution(g).x.toVar(), skew).toVar();
  const grained = darkenedFrom(h, drawn, max(softness, LEAST_SOFTNESS).toVar());
  // Without tooth, crowded strokes become a flat tone.
  const left = mix(grained, drawn, crowded.mul(oneMinus(grain)));
  return oneMinus(oneMinus(rubbed).mul(oneMinus(left))).toVar();
}
