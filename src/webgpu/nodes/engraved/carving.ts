/** The twin of shaders/techniques/engraved/carving.glsl: lines that are cut white out of the block, as in a woodcut. */
import { CARVING_CONSTANTS } from '../../../look/constants/engravedConstants.js';
import { tsl, type Value } from '../base/values.js';
import type { Family, HatchingParameters } from './Hatching.js';
import { turnOf } from './hand.js';
import { octaves } from './octaves.js';
import { alongLines, differing, numberOf } from './strokeLengths.js';

const { abs, clamp, float, fract, inverseSqrt, max, min, mix, select, sqrt, vec2, vec4 } = tsl;
const { RARE, SWELL, SWELL_SHARE, WIDENING } = CARVING_CONSTANTS;

export interface Cut {
  /** Width in the mean, as a share of the room; beyond [0, 1] most of the row is blank, or all cut away. */
  middle: Value;
  /** Two coordinates along the lines in wedges, at the two lengths. */
  waves: Value;
  /** Of the second length, and of the first coordinate. */
  shares: Value;
  swell: Value;
  family: Family;
}

/** Octaves by which rows lie farther apart. */
export const rowOctaves = (tone: Value): Value =>
  clamp(
    octaves(
      float(RARE)
        .div(max(min(tone, float(1).sub(tone)), 1e-4))
        .toVar(),
    ),
    0,
    2,
  );

export function cutFor(h: HatchingParameters, family: Family, tone: Value, octave: Value): Cut {
  const white = float(1).sub(tone).toVar();
  const rare = min(white, tone).toVar();
  // The mean of clamp(middle + swell u, 0, 1), for u even within [−1, 1], is what is white.
  const swell = min(rare.mul(SWELL_SHARE), SWELL).mul(differing(family, octave)).toVar();
  const narrow = sqrt(max(swell.mul(rare).mul(4), 0)).sub(swell);
  const ofRare = select(rare.lessThan(swell), narrow, rare).toVar();
  const middle = select(white.lessThan(0.5), ofRare, float(1).sub(ofRare)).toVar();
  const along = alongLines(h, family);
  const wedges = along.places.div(along.period).toVar();
  const shares = vec2(along.longer, along.share).toVar();
  // Waves that are mixed are flatter.
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

/** Rises slowly and falls fast, evenly within [−1, 1]. */
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
