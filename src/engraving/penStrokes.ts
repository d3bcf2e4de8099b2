/**
 * Lines that a pen draws in strokes, as shaders/techniques/engraved/penStrokes.glsl has it. Each begins thin, swells and is lifted again. Light
 * tones have fewer strokes, of the width of the nib.
 */

import { LOT_FACTORS } from './constants/lotConstants.js';
import { PEN_CONSTANTS } from './constants/penConstants.js';
import { bitsOf, lotOf } from './hand.js';
import { type Along, numberOf } from './strokeLengths.js';
import { clamp01, mix } from './vectors.js';

const {
  ALL_FROM,
  STROKE_GROWTH,
  SHORTENING,
  SHORTENING_OF_INK,
  NIB,
  BIRTH,
  STROKE_GAP,
  TAPER,
  LEANING,
  BENDING,
  WIDTH_SPREAD,
} = PEN_CONSTANTS;
const { GAP_LOT, BIRTH_LOT, WIDTH_LOT } = PEN_CONSTANTS;
const { GOLDEN_RATIO, THIRD_FACTOR, THUE_MORSE } = LOT_FACTORS;

/** What a line loses to the gaps and the ends of its strokes where they are farthest apart. */
const LOST = 0.5 * STROKE_GAP + TAPER / 3;

/** What a pen does at a place, on all lines. */
export interface Pen {
  along: Along;
  tone: number;
  /** How far strokes are apart at their ends. */
  open: number;
  /** Of a stroke in its middle, as a share of the room of a line. */
  width: number;
  /** From 0, a ruling machine, to 1. */
  handmade: number;
  /** As `numberOf` has it. */
  repeat: number;
}

/** The integral of the ink of a stroke that grows: a ramp from 0 to 1, and less where it is short. */
function rampSum(x: number): number {
  const grown = Math.min(x / STROKE_GROWTH, 1);
  const sum = grown * grown * (0.5 - SHORTENING_OF_INK * (0.5 - grown / 3));
  return STROKE_GROWTH * sum + Math.max(x - STROKE_GROWTH, 0);
}

/** The share of strokes that are there. */
const thereAt = (tone: number): number => (rampSum(tone) - rampSum(Math.max(tone - ALL_FROM, 0))) / ALL_FROM;

export function penFor(tone: number, along: Along, handmade: number, repeat: number): Pen {
  const open = (1 - tone) ** 2;
  const width = tone / Math.max(thereAt(tone) * (1 - LOST * open), 1e-4);
  return { along, tone, open, width: tone < ALL_FROM ? Math.min(width, NIB) : width, handmade, repeat };
}

/** The share of its length that strokes of one width cover of a line in the mean: they do not narrow, but have their gaps. */
export const drawnShare = ({ tone, open }: Pen): number =>
  Math.max(thereAt(tone) * (1 - 0.5 * STROKE_GAP * open), 1e-4);

/** The lot below which strokes have been born where so large a share of them is, each over a part BIRTH of all lots. */
function bornBelow(share: number): number {
  if (share < 0.5 * BIRTH) return Math.sqrt(2 * BIRTH * share);
  return share < 1 - 0.5 * BIRTH ? share + 0.5 * BIRTH : 1 + BIRTH - Math.sqrt(2 * BIRTH * Math.max(1 - share, 0));
}

/** A number in [0, 1) that belongs to a stroke: random from line to line, and far from those of its neighbours on the line. */
function lotOfStroke(line: number, stroke: number): number {
  const spread = Math.imul(bitsOf(line), GOLDEN_RATIO);
  const ofLine = Math.imul(spread ^ (spread >>> 15), THIRD_FACTOR);
  return ((ofLine + Math.imul(stroke, THUE_MORSE)) >>> 8) / 16777216;
}

const fract = (x: number): number => x - Math.floor(x);

/** A stroke where it passes a place. */
export interface Stroke {
  /** As a share of the room that an old line has, and the share of it that a stroke of one width has there: 0 in gaps, 1 within. */
  width: number;
  presence: number;
  /** How far it strays from its line towards higher values, in distances between lines. */
  astray: number;
}

function strokeOn({ tone, open, width, handmade, repeat }: Pen, born: number, line: number, turns: number): Stroke {
  const number = numberOf(line, repeat);
  const along = turns + lotOf(Math.abs(number));
  const stroke = Math.floor(along);
  const lot = lotOfStroke(Math.abs(number), stroke);
  const other = fract(GAP_LOT * lot);
  // From −1 at one end to 1 at the other.
  const way = 2 * (along - stroke) - 1;
  let there = clamp01((tone - ALL_FROM * lot) / STROKE_GROWTH);
  const inside = 1 - Math.abs(way) - open * STROKE_GAP * other - SHORTENING * (1 - there);
  const rest = clamp01(1 - inside / Math.max(open * TAPER, 1e-3));
  there *= clamp01((born - fract(BIRTH_LOT * lot)) / BIRTH);
  const spread = 1 + handmade * WIDTH_SPREAD * open * (fract(WIDTH_LOT * lot) - 0.5);
  const astray = LEANING * (other - 0.5) * way + BENDING * (lot - 0.5) * (0.5 - way * way);
  return {
    width: width * there * spread * (1 - rest * rest),
    presence: Math.min(there, clamp01(0.5 + 20 * inside)),
    astray: handmade * open * Math.sign(number) * astray,
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
 * @param share of the room of an old line that the line has: younger ones have fewer strokes, which are thinner
 */
export function strokeAt(pen: Pen, share: number, line: number): Stroke {
  // As wide as the old ones, they would fill the room between them.
  const grown = Math.sqrt(Math.max(share, 0));
  const born = bornBelow(grown);
  const { places, period, longer, share: ofFirst } = pen.along;
  const alongAxis = (place: number): Stroke => {
    const stroke = strokeOn(pen, born, line, place / period);
    return longer > 0 ? mixed(stroke, strokeOn(pen, born, line, place / (2 * period)), longer) : stroke;
  };
  const stroke = mixed(alongAxis(places[1]), alongAxis(places[0]), ofFirst);
  return { ...stroke, width: grown * stroke.width };
}
