/**
 * Lines that are cut white out of the block, as shaders/techniques/engraved/carving.glsl has it. A gouge goes in at a point, widens and comes
 * out again: each line is a row of wedges. What they leave between them is black, and ends in points too.
 */
import { CARVING_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { clamp01, mix } from '../../look/vectors.js';
import { turnOf } from './hand.js';
import { octaves } from './ruledLines.js';
import { type Along, differing, numberOf } from './strokeLengths.js';

const { SWELL, SWELL_SHARE, RARE, WIDENING } = CARVING_CONSTANTS;

/** Octaves by which rows lie farther apart, from 0 to 2. */
export const rowOctaves = (tone: number): number =>
  Math.min(Math.max(octaves(RARE / Math.max(Math.min(tone, 1 - tone), 1e-4)), 0), 2);

/** What the gouge does at a place, on all lines. */
export interface Cut {
  /** Width in the mean, as a share of the room. */
  middle: number;
  swell: number;
  along: Along;
  /** As `numberOf` has it. */
  repeat: number;
}

/** octave: of the distance between cuts. */
export function cutFor(tone: number, along: Along, repeat: number, octave: number): Cut {
  const white = 1 - tone;
  const rare = Math.min(white, tone);
  // The mean of clamp(middle + swell u, 0, 1), for u even within [−1, 1], is what is white.
  const swell = differing(octave, repeat) * Math.min(SWELL, SWELL_SHARE * rare);
  const middle = rare < swell ? Math.sqrt(4 * swell * rare) - swell : rare;
  // Waves that are mixed are flatter.
  const left = (share: number): number => share * share + (1 - share) ** 2;
  return {
    middle: white < 0.5 ? middle : 1 - middle,
    swell: swell / Math.sqrt(left(along.longer) * left(along.share)),
    ...{ along, repeat },
  };
}

/** Rises slowly and falls fast, evenly within [−1, 1]. */
function gouge(x: number): number {
  const t = x - Math.floor(x);
  return 2 * Math.min(t / WIDENING, (1 - t) / (1 - WIDENING)) - 1;
}

/** The share of its room that is cut away of a line, from 0 to 1. */
export function cutWidth({ middle, swell, along, repeat }: Cut, line: number): number {
  const hash = turnOf(Math.abs(numberOf(line, repeat)));
  const [first, second] = along.places.map((place) => {
    const wedges = place / along.period;
    return mix(gouge(wedges + hash), gouge(0.5 * wedges + hash), along.longer);
  });
  return clamp01(middle + swell * mix(second, first, along.share));
}
