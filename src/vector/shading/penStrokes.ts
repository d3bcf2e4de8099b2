/**
 * Lines drawn in strokes of a pen, as in shaders/techniques/lines/penStrokes.glsl. Each stroke begins thin, swells and tapers off. Light
 * tones have fewer strokes, of the width of the nib.
 */

import { PEN_CONSTANTS } from '../../look/constants/lineConstants.js';
import { HASH_FACTORS } from '../../look/constants/patternConstants.js';
import { clamp01, mix } from '../../look/vectors.js';
import { bitsOf, hash01, turnOf } from './hand.js';
import { type Along, differing, numberOf } from './strokeLengths.js';

const { ALL_FROM, STROKE_GROWTH, SHORTENING, SHORTENING_OF_INK, NIB, CLOSED_FROM, LATENESS, LATE_HASH } = PEN_CONSTANTS;
const { BIRTH, STROKE_GAP, TAPER, LEANING, BENDING, WIDTH_SPREAD } = PEN_CONSTANTS;
const { GAP_HASH, BIRTH_HASH, WIDTH_HASH, AXIS_HASH, AXIS_TURN } = PEN_CONSTANTS;
const { GOLDEN_RATIO, THIRD_FACTOR, THUE_MORSE } = HASH_FACTORS;

/** The share of a line that is lost to the gaps and the tapered ends of its strokes where the gaps are widest. */
const LOST = 0.5 * STROKE_GAP + TAPER / 3;

/** The strokes at a place, the same for all lines. */
export interface Pen {
  along: Along;
  tone: number;
  /** The size of the gaps between strokes. */
  open: number;
  /** The tone from which on no stroke is left out. */
  allFrom: number;
  /** The width of a stroke in its middle, as a share of the room of a line. */
  width: number;
  /** From 0, lines as by a ruling machine, to 1. */
  irregularity: number;
  /** As in `numberOf`. */
  repeat: number;
}

/** The integral of the ink of a growing stroke: a ramp from 0 to 1, and less where it is short. */
function rampSum(x: number): number {
  const grown = Math.min(x / STROKE_GROWTH, 1);
  const sum = grown * grown * (0.5 - SHORTENING_OF_INK * (0.5 - grown / 3));
  return STROKE_GROWTH * sum + Math.max(x - STROKE_GROWTH, 0);
}

/** The share of strokes that exist. */
const thereAt = (tone: number, allFrom: number): number =>
  (rampSum(tone) - rampSum(Math.max(tone - allFrom, 0))) / allFrom;

/** octave: of the spacing of lines. */
export function penFor(tone: number, along: Along, irregularity: number, repeat: number, octave: number): Pen {
  const allFrom = ALL_FROM * differing(octave, repeat);
  const open = Math.max(1 - tone / CLOSED_FROM, 0) ** 2;
  const width = tone / Math.max(thereAt(tone, allFrom) * (1 - LOST * open), 1e-4);
  return { along, tone, open, allFrom, width: tone < allFrom ? Math.min(width, NIB) : width, irregularity, repeat };
}

/** The mean share of a line's length that strokes of one width cover: they have gaps, but do not taper. */
export const drawnShare = ({ tone, open, allFrom }: Pen): number =>
  Math.max(thereAt(tone, allFrom) * (1 - 0.5 * STROKE_GAP * open), 1e-4);

/** The hash below which strokes exist if a given share of them does. Each appears over a part BIRTH of all hashes. */
function bornBelow(share: number): number {
  if (share < 0.5 * BIRTH) return Math.sqrt(2 * BIRTH * share);
  return share < 1 - 0.5 * BIRTH ? share + 0.5 * BIRTH : 1 + BIRTH - Math.sqrt(2 * BIRTH * Math.max(1 - share, 0));
}

/** Random bits of a line, from which the hashes of its strokes are made. */
export function bitsOfLine(line: number): number {
  const word = bitsOf(line);
  const spread = Math.imul(word ^ (word >>> 12), GOLDEN_RATIO);
  return Math.imul(spread ^ (spread >>> 13), THIRD_FACTOR);
}

/** A hash of a stroke in [0, 1), far from those of its neighbours on the line. */
export const strokeHash01 = (bits: number, stroke: number): number =>
  ((bits + Math.imul(stroke, THUE_MORSE)) >>> 8) / 16777216;

const fract = (x: number): number => x - Math.floor(x);

/** A stroke at a place. */
export interface Stroke {
  /** Width as a share of the room of an old line; and the share of it that a stroke of one width has: 0 in gaps, 1 within. */
  width: number;
  presence: number;
  /** Offset from its line towards higher values, in distances between lines. */
  astray: number;
}

/** A line whose strokes are computed. */
interface PennedLine {
  hash: number;
  /** 0, a third or two thirds, in turn. */
  turn: number;
  bits: number;
  /** −1 or 1, the direction in which its strokes stray. */
  sign: number;
}

/** The delay of the start of a stroke, as a share of the mean length. */
const latenessOf = (chance: number): number => LATENESS * fract(LATE_HASH * chance);

/** place: in lengths of strokes. born: the hash below which strokes exist. */
function strokeOn(
  { tone, open, allFrom, width, irregularity }: Pen,
  born: number,
  place: number,
  line: PennedLine,
): Stroke {
  const along = place + line.hash;
  // Strokes start late by chance, and so differ in length: otherwise the ends of neighbours would lie in rows across the lines.
  let stroke = Math.floor(along);
  if (along < stroke + latenessOf(strokeHash01(line.bits, stroke))) stroke--;
  const chance = strokeHash01(line.bits, stroke);
  const late = latenessOf(chance);
  const size = 1 + latenessOf(strokeHash01(line.bits, stroke + 1)) - late;
  // From −1 at one end to 1 at the other.
  const way = (2 * (along - stroke - late)) / size - 1;
  // Properties of strokes are spread evenly over a surface. The first strokes to appear lie on one of three neighbouring lines.
  const even = strokeHash01(line.hash * 2 ** 32, stroke);
  let there = clamp01((tone - allFrom * fract(line.turn + even / 3)) / STROKE_GROWTH);
  const gap = fract(GAP_HASH * even);
  const inside = 1 - Math.abs(way) - open * STROKE_GAP * gap - SHORTENING * (1 - there);
  const taper = open * TAPER;
  const rest = clamp01((taper - inside) / Math.max(taper, 1e-3));
  there *= clamp01((born - fract(BIRTH_HASH * even)) / BIRTH);
  const spread = 1 + irregularity * WIDTH_SPREAD * open * (fract(WIDTH_HASH * even) - 0.5);
  const astray = LEANING * (gap - 0.5) * way + BENDING * (chance - 0.5) * (0.5 - way * way);
  return {
    width: width * there * spread * (1 - rest * rest),
    presence: Math.min(there, clamp01(0.5 + 20 * inside)),
    astray: irregularity * open * line.sign * astray,
  };
}

const mixed = (a: Stroke, b: Stroke, t: number): Stroke => ({
  width: mix(a.width, b.width, t),
  presence: mix(a.presence, b.presence, t),
  astray: mix(a.astray, b.astray, t),
});

/**
 * The stroke on a line at the place.
 *
 * @param share of the room of an old line that the line has: new lines have thinner strokes, and fewer in light tones
 */
export function strokeAt(pen: Pen, share: number, line: number): Stroke {
  // At full width new strokes would fill the room between the old ones. In the darks a missing stroke would be a hole.
  const there = mix(1, Math.sqrt(Math.max(share, 0)), Math.sqrt(pen.open));
  const born = bornBelow(there);
  const { places, period, longer, share: firstOfAll } = pen.along;
  const number = numberOf(line, pen.repeat);
  const size = Math.abs(number);
  const penned: PennedLine = {
    hash: hash01(size),
    turn: turnOf(size),
    bits: bitsOfLine(size),
    sign: Math.sign(number),
  };
  // Lines change from one axis to the other one by one.
  const first = clamp01(((1 + AXIS_TURN) * firstOfAll - fract(AXIS_HASH * penned.hash)) / AXIS_TURN);
  const alongAxis = (place: number): Stroke => {
    const stroke = strokeOn(pen, born, place / period, penned);
    return longer > 0 ? mixed(stroke, strokeOn(pen, born, place / (2 * period), penned), longer) : stroke;
  };
  const stroke = mixed(alongAxis(places[1]), alongAxis(places[0]), first);
  return { ...stroke, width: (share / Math.max(there, 1e-4)) * stroke.width };
}
