/**
 * The twin of shaders/chunks/dryMedium.glsl. Pencil, charcoal, chalk: what a stroke leaves grows with its pressure, which is the tone, and
 * catches on the tooth of the paper.
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

/** Grain whose edges are as hard as a pixel would flicker. */
const LEAST_SOFTNESS = 0.1;
/** In the darks the hand presses: at full tone up to so much less of the tooth counts, and so much less is smudged. */
const PRESSED = [0.5, 0.25] as const;

const oneMinus = (x: Value): Value => float(1).sub(x);

/**
 * What a dry medium leaves ∈ [0, 1], of a field under a tone. As with ink, its mean is the tone.
 *
 * @param pixel of what is drawn to, counted from the lower left
 */
export function inkAt(field: HatchField, tone: Value, crowding: Value, pixel: Value): Value {
  const squared = tone.mul(tone).toVar();
  // What is nothing but grain stays so.
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
  // Of the skew of one field, a sum keeps the cube of its share.
  const skew = field.mixing.mul(shares.x).mul(shares.x).mul(shares.x);
  // An edge that went by the slope of the field would be wide where the field is steep: the mean would not be the tone.
  const h = unskew(normalDistribution(g).x.toVar(), skew).toVar();
  const grained = darkenedFrom(h, drawn, max(softness, LEAST_SOFTNESS).toVar());
  // Without a tooth, crowded strokes leave nothing but their tone.
  const left = mix(grained, drawn, crowded.mul(oneMinus(grain)));
  return oneMinus(oneMinus(rubbed).mul(oneMinus(left))).toVar();
}
