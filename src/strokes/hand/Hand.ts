/** The intended darkness of a swatch. */
export type SwatchTone = 'light' | 'middle' | 'dark';

/** A stroke drawn by a person: a polyline with a width at every point. */
export interface HandStroke {
  /** x0, y0, x1, y1, … in millimetres on the sheet, x to the right and y down, in the order of drawing; two points or more. */
  points: readonly number[];
  /** The width at every point, in millimetres. */
  widths: readonly number[];
  /** The swatch that it belongs to. Default `'middle'`. */
  swatch?: SwatchTone | undefined;
}

/** The numbers learnt from the strokes of a hand. Lengths are in millimetres, angles in degrees. */
export interface HandNumbers {
  /** Mean length of a stroke. */
  length: number;
  /** Standard deviation of the lengths, as a share of `length`. */
  lengthSpread: number;
  /**
   * Mean curvature: the height of a stroke's arc over its chord, as a share of the chord. Positive arcs rise to the right-hand side of
   * the direction in which most strokes of the layer are drawn.
   */
  curvature: number;
  /** The length over which a stroke grows from its start to its full width, as a share of its length. */
  taperStart: number;
  /** The length over which it narrows towards its end, as a share of its length. */
  taperEnd: number;
  /** Mean full width. */
  width: number;
  /** Standard deviation of the width along and between strokes without their tapers, as a share of `width`: the pressure. */
  widthSpread: number;
  /** Root mean square distance of a stroke from its own smooth arc. */
  wobble: number;
  /** Standard deviation of the angles of strokes of one layer. */
  angleSpread: number;
  /** Mean distance between the centre lines of neighbouring strokes of one layer, across them, in the middle swatch. */
  spacing: number;
  /** Standard deviation of that distance, as a share of `spacing`: 0 is ruled, 1 is random. */
  spacingSpread: number;
  /** How much strokes stand in groups: 1 − median / mean of the distances between neighbours. 0 is even; towards 1, bundles with gaps. */
  clustering: number;
  /** The share of a stroke's length that runs beside the next stroke of its row end to end; negative leaves gaps. */
  overlap: number;
  /** The angle from the first layer to the second, −90 to 90, clockwise on the sheet; 0 where nothing is crossed. */
  crossingAngle: number;
  /** The tone from 0 (paper) to 1 from which strokes are crossed; 1: never. */
  crossingFrom: number;
}

/** A person's hand: strokes, and the numbers learnt from them. It is plain data and survives JSON. */
export interface Hand {
  /** The version of this format: 1. */
  version: 1;
  /** A name for people. */
  name?: string | undefined;
  strokes: readonly HandStroke[];
  numbers: HandNumbers;
  /** Whether maps may also draw the strokes mirrored: more variety, but bends to one side are lost. Default false. */
  mirror?: boolean | undefined;
}

/** The sizes of lines and outlines that a hand is scaled to. */
export interface HandLinesOptions {
  /** The `lineSpacing` of the material. Default 4.5. */
  lineSpacing?: number | undefined;
  /** The `outlineWidth` of the outlines, in CSS pixels. Default 1.8. */
  outlineWidth?: number | undefined;
}

/** Properties of materials and outlines. */
export interface HandLines {
  /** Properties of a `HatchingMaterial` with `technique: 'pen'`. */
  material: { irregularity: number; strokeLength: number; crossFrom: number; crossAngle?: number };
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
 * The properties that make lines and outlines, which are not drawn from a map, match a hand: unsteadiness, length of strokes,
 * tone and angle of crossing, and the taper, pressure and wobble of outlines.
 *
 * ```ts
 * const { material, outlines } = handLines(hand);
 * applyHatching(scene, { material: { technique: 'pen', ...material }, outlines });
 * ```
 *
 * @throws TypeError or RangeError with the fault of the hand
 */
export function handLines(
  hand: Pick<Hand, 'numbers'>,
  { lineSpacing = 4.5, outlineWidth = 1.8 }: HandLinesOptions = {},
): HandLines {
  checkHandNumbers('handLines', hand);
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
      irregularity: (shares[0] + shares[1] + shares[2]) / 3,
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

/** The range of a number of a hand. */
interface HandNumberRange {
  from: number;
  to: number;
}

/** The range of each number of a hand, in its unit. Lengths in millimetres may be anything that a pen draws. */
export const HAND_NUMBER_RANGES: Readonly<Record<keyof HandNumbers, HandNumberRange>> = {
  length: { from: 0.001, to: 10_000 },
  lengthSpread: { from: 0, to: 2 },
  curvature: { from: -1, to: 1 },
  taperStart: { from: 0, to: 1 },
  taperEnd: { from: 0, to: 1 },
  width: { from: 0.001, to: 10_000 },
  widthSpread: { from: 0, to: 2 },
  wobble: { from: 0, to: 10_000 },
  angleSpread: { from: 0, to: 90 },
  spacing: { from: 0.001, to: 10_000 },
  spacingSpread: { from: 0, to: 3 },
  clustering: { from: 0, to: 1 },
  overlap: { from: -2, to: 1 },
  crossingAngle: { from: -90, to: 90 },
  crossingFrom: { from: 0, to: 1 },
};

/** The names of the numbers of a hand. */
export const HAND_NUMBER_NAMES = /* @__PURE__ */ Object.keys(HAND_NUMBER_RANGES) as (keyof HandNumbers)[];

/**
 * Checks that a value has the numbers of a hand. Its strokes are not checked.
 *
 * @param caller the function named in the error
 * @throws TypeError or RangeError with the fault
 */
export function checkHandNumbers(caller: string, hand: unknown): asserts hand is Pick<Hand, 'numbers'> {
  checkIsObject(caller, hand);
  const { numbers } = hand as Partial<Hand>;
  if (typeof numbers !== 'object' || numbers === null) {
    throw new TypeError(
      `${caller}: hand.numbers is ${String(numbers)}, but must be an object with the learnt numbers.`,
    );
  }
  for (const number of HAND_NUMBER_NAMES) {
    const value: unknown = numbers[number];
    const { from, to } = HAND_NUMBER_RANGES[number];
    if (typeof value !== 'number' || !(value >= from && value <= to)) {
      throw new RangeError(
        `${caller}: hand.numbers.${number} is ${String(value)}, but must be a number from ${from} to ${to}.`,
      );
    }
  }
}

/** @throws TypeError if a value cannot be a hand */
export function checkIsObject(caller: string, hand: unknown): asserts hand is object {
  if (typeof hand === 'object' && hand !== null && !Array.isArray(hand)) return;
  throw new TypeError(
    `${caller}: hand is ${Array.isArray(hand) ? 'an array' : String(hand)}, but must be { version, strokes, numbers }; learnHand makes one from strokes.`,
  );
}
