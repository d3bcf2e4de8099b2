/**
 * White lines cut out of a black block, as in shaders/techniques/lines/carving.glsl. A gouge enters at a point, widens and leaves again:
 * each line is a row of wedges. The black between them ends in points too.
 */
import { CARVING_CONSTANTS } from '../../look/constants/lineConstants.js';
import { clamp01, mix } from '../../look/vectors.js';
import { turnOf } from './hand.js';
import { octaves } from './ruledLines.js';
import { type Along, differing, numberOf } from './strokeLengths.js';

const { SWELL, SWELL_SHARE, RARE, WIDENING } = CARVING_CONSTANTS;

/** Octaves by which the spacing of rows grows, from 0 to 2. */
export const rowOctaves = (tone: number): number =>
  Math.min(Math.max(octaves(RARE / Math.max(Math.min(tone, 1 - tone), 1e-4)), 0), 2);

/** The cuts at a place, the same for all lines. */
export interface Cut {
  /** Mean width as a share of the room. */
  middle: number;
  swell: number;
  along: Along;
  /** As in `numberOf`. */
  repeat: number;
}

/** octave: of the spacing of cuts. */
export function cutFor(tone: number, along: Along, repeat: number, octave: number): Cut {
  const white = 1 - tone;
  const rare = Math.min(white, tone);
  // The white share is the mean of clamp(middle + swell u, 0, 1) for u uniform in [−1, 1].
  const swell = differing(octave, repeat) * Math.min(SWELL, SWELL_SHARE * rare);
  const middle = rare < swell ? Math.sqrt(4 * swell * rare) - swell : rare;
  // Blended waves are flatter.
  const left = (share: number): number => share * share + (1 - share) ** 2;
  return {
    middle: white < 0.5 ? middle : 1 - middle,
    swell: swell / Math.sqrt(left(along.longer) * left(along.share)),
    ...{ along, repeat },
  };
}

/** A wave that rises slowly and falls fast, uniform in [−1, 1]. */
function gouge(x: number): number {
  const t = x - Math.floor(x);
  return 2 * Math.min(t / WIDENING, (1 - t) / (1 - WIDENING)) - 1;
}

/** The share of a line's room that is cut away, from 0 to 1. */
export function cutWidth({ middle, swell, along, repeat }: Cut, line: number): number {
  const hash = turnOf(Math.abs(numberOf(line, repeat)));
  const [first, second] = along.places.map((place) => {
    const wedges = place / along.period;
    return mix(gouge(wedges + hash), gouge(0.5 * wedges + hash), along.longer);
  });
  return clamp01(middle + swell * mix(second, first, along.share));
}
