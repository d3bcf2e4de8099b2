/** Counterpart of shaders/techniques/lines/carving.glsl: white lines cut out of a black block, as in a woodcut. */
import { CARVING_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { tsl, type Value } from '../base/values.js';
import { turnOf } from './hand.js';
import type { Family, HatchingParameters } from './read.js';
import { alongLines, differing, numberOf, octaves } from './strokeLengths.js';

const { abs, clamp, float, fract, inverseSqrt, max, min, mix, select, sqrt, vec2, vec4 } = tsl;
const { RARE, SWELL, SWELL_SHARE, WIDENING } = CARVING_CONSTANTS;

export interface Cut {
  /** Mean width as a share of the room; beyond [0, 1] most of the row is blank, or all cut away. */
  middle: Value;
  /** Two coordinates along the lines in units of cuts, at both lengths. */
  waves: Value;
  /** Share of the second length, and of the first coordinate. */
  shares: Value;
  swell: Value;
  family: Family;
}

/** Octaves by which the spacing of rows grows. */
export const rowOctaves = (tone: Value): Value =>
  clamp(
    octaves(
      float(RARE)
        .div(max(min(tone, tone.oneMinus()), 1e-4))
        .toVar(),
    ),
    0,
    2,
  );

export function cutFor(h: HatchingParameters, family: Family, tone: Value, octave: Value): Cut {
  const white = tone.oneMinus().toVar();
  const rare = min(white, tone).toVar();
  // The white share is the mean of clamp(middle + swell u, 0, 1) for u uniform in [−1, 1].
  const swell = min(rare.mul(SWELL_SHARE), SWELL).mul(differing(family, octave)).toVar();
  const narrow = sqrt(max(swell.mul(rare).mul(4), 0)).sub(swell);
  const ofRare = select(rare.lessThan(swell), narrow, rare).toVar();
  const middle = select(white.lessThan(0.5), ofRare, ofRare.oneMinus()).toVar();
  const along = alongLines(h, family);
  const wedges = along.places.div(along.period).toVar();
  const shares = vec2(along.longer, along.share).toVar();
  // Blended waves are flatter.
  const rest = vec2(1).sub(shares).toVar();
  const left = shares.mul(shares).add(rest.mul(rest)).toVar();
  return {
    middle,
    waves: vec4(wedges, wedges.mul(0.5)).toVar(),
    shares,
    swell: swell.mul(inverseSqrt(left.x.mul(left.y))).toVar(),
    family,
  };
}

/** A wave that rises slowly and falls fast, uniform in [−1, 1]. */
function gouge(x: Value): Value {
  const t = fract(x).toVar();
  return min(
    t.div(WIDENING),
    vec4(1)
      .sub(t)
      .div(1 - WIDENING),
  )
    .mul(2)
    .sub(1);
}

export function cutWidth(cut: Cut, line: Value): Value {
  const hash = turnOf(abs(numberOf(line, cut.family)).toVar());
  const waves = gouge(cut.waves.add(hash)).toVar();
  const lengths = mix(waves.xy, waves.zw, cut.shares.x).toVar();
  return clamp(cut.middle.add(cut.swell.mul(mix(lengths.y, lengths.x, cut.shares.y))), 0, 1);
}
