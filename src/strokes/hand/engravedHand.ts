import type { Hand } from './Hand.js';
import { checkHandNumbers } from './handNumbers.js';

/** The sizes of lines and outlines that a hand is scaled to. */
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

/**
 * Values at which lines are as unsteady as possible: the spread of widths, the spread of distances, and the wobble as a share of the
 * distance.
 */
const MOST_WIDTH_SPREAD = 0.3;
const MOST_SPACING_SPREAD = 0.8;
const MOST_WOBBLE = 0.2;

/** Bounds of the length of strokes, in distances between lines. */
const [SHORTEST, LONGEST] = [3, 80];

/** Factor on tapers: a fifth at both ends gives the outlines' default. */
const TAPER = 2;
/** Factor on the pressure: a spread of widths of a quarter gives the accents of the outlines' default. */
const ACCENTS = 2;
const MOST_ACCENTS = 1.5;
/** Largest wobble of outlines, as a share of their width. */
const MOST_OUTLINE_WOBBLE = 2;

const clamp = (value: number, from: number, to: number): number => Math.max(from, Math.min(to, value));

/**
 * The properties that make `engraved` lines and outlines, which are not drawn from a map, match a hand: unsteadiness, length of strokes,
 * tone and angle of crossing, and the taper, pressure and wobble of outlines.
 *
 * ```ts
 * const { material, outlines } = engravedHand(hand);
 * applyHatching(scene, { material: { technique: 'engraved', ...material }, outlines });
 * ```
 *
 * @throws TypeError or RangeError with the fault of the hand
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
