import type { Hand } from './Hand.js';
import { checkHandNumbers } from './handNumbers.js';

/** By what a hand is scaled to lines and outlines. */
export interface EngravedHandOptions {
  /** The `lineSpacing` of the material. Default 4.5. */
  lineSpacing?: number | undefined;
  /** The `outlineWidth` of the outlines, in CSS pixels. Default 1.8. */
  outlineWidth?: number | undefined;
}

/** Properties of materials and outlines. */
export interface EngravedHand {
  /** Properties of a `HatchingMaterial` with `technique: 'engraved'`. */
  material: { handmade: number; strokeLength: number; crossFrom: number; crossAngle?: number };
  /** Properties of outlines. */
  outlines: { taper: number; accents: number; wobble: number };
}

/** What makes a hand as unsteady as lines get: a spread of widths, of distances, and a wobble as a share of the distance. */
const MOST_WIDTH_SPREAD = 0.3;
const MOST_SPACING_SPREAD = 0.8;
const MOST_WOBBLE = 0.2;

/** Strokes as long as so many distances of lines, at least and at most. */
const [SHORTEST, LONGEST] = [3, 80];

/** Tapers of a fifth at both ends are those of the outlines' default. */
const TAPER = 2;
/** A pressure whose widths spread by a quarter gives the accents of the outlines' default. */
const ACCENTS = 2;
const MOST_ACCENTS = 1.5;
/** The wobble of outlines, as a share of their width, is at most this. */
const MOST_OUTLINE_WOBBLE = 2;

const clamp = (value: number, from: number, to: number): number => Math.max(from, Math.min(to, value));

/**
 * The properties by which the lines of `engraved` and outlines, which are not drawn from a map, come from the same hand: how unsteady it
 * is, how long its strokes are, from which tone and at which angle they cross, and how outlines taper, press and wobble.
 *
 * ```ts
 * const { material, outlines } = engravedHand(hand);
 * applyHatching(scene, { material: { technique: 'engraved', ...material }, outlines });
 * ```
 *
 * @throws TypeError or RangeError that says in a sentence what is wrong with the hand
 */
export function engravedHand(
  hand: Pick<Hand, 'numbers'>,
  { lineSpacing = 4.5, outlineWidth = 1.8 }: EngravedHandOptions = {},
): EngravedHand {
  checkHandNumbers('engravedHand', hand);
  const { numbers } = hand;
  const { width, widthSpread, wobble, spacing, spacingSpread, length, taperStart, taperEnd } = numbers;
  const shares = [
    widthSpread / MOST_WIDTH_SPREAD,
    wobble / spacing / MOST_WOBBLE,
    spacingSpread / MOST_SPACING_SPREAD,
  ].map((share) => Math.min(1, share));
  const isCrossed = numbers.crossingAngle !== 0 && numbers.crossingFrom < 1;
  return {
    material: {
      handmade: (shares[0] + shares[1] + shares[2]) / 3,
      strokeLength: lineSpacing * clamp(length / spacing, SHORTEST, LONGEST),
      crossFrom: isCrossed ? numbers.crossingFrom : 1,
      ...(isCrossed && { crossAngle: (Math.abs(numbers.crossingAngle) * Math.PI) / 180 }),
    },
    outlines: {
      taper: TAPER * (taperStart + taperEnd),
      accents: Math.min(MOST_ACCENTS, ACCENTS * widthSpread),
      wobble: outlineWidth * Math.min(MOST_OUTLINE_WOBBLE, wobble / width),
    },
  };
}
