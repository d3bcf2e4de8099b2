/** The twin of shaders/techniques/engraved/penStrokes.glsl: lines that a pen draws in strokes. */
import { LOT_FACTORS } from '../../../../engraving/constants/lotConstants.js';
import { PEN_CONSTANTS } from '../../../../engraving/constants/penConstants.js';
import { tsl, type Value } from '../../base/values.js';
import { lineCoverage } from '../../chunks/lineCoverage.js';
import type { Family, HatchingParameters } from './Hatching.js';
import { handmade, lotOf } from './hand.js';
import { FRINGE } from './lineFringe.js';
import { type Along, alongLines, numberOf } from './strokeLengths.js';

const { abs, clamp, float, floatBitsToUint, floor, fract, If, int, Loop, max, min, select, sign, sqrt, uint, vec2 } =
  tsl;
const { ALL_FROM, BENDING, BIRTH, BIRTH_LOT, GAP_LOT, LEANING, NIB, STROKE_GAP, STROKE_GROWTH } = PEN_CONSTANTS;
const { SHORTENING, SHORTENING_OF_INK, TAPER, WIDTH_LOT, WIDTH_SPREAD } = PEN_CONSTANTS;

/** What a line loses to the gaps and the ends of its strokes where they are farthest apart. */
const LOST = 0.5 * STROKE_GAP + TAPER / 3;

export interface Pen {
  family: Family;
  along: Along;
  tone: Value;
  /** How far strokes are apart at their ends. */
  open: Value;
  /** Of a stroke in its middle, as a share of the room of a line. */
  width: Value;
}

const oneMinus = (x: Value): Value => float(1).sub(x);

/** The integral of the ink of a stroke that grows: a ramp from 0 to 1, and less where it is short. */
function rampSum(x: Value): Value {
  const grown = min(x.div(STROKE_GROWTH), 1).toVar();
  const lessShort = float(0.5).sub(float(0.5).sub(grown.div(3)).mul(SHORTENING_OF_INK));
  return grown
    .mul(grown)
    .mul(lessShort)
    .mul(STROKE_GROWTH)
    .add(max(x.sub(STROKE_GROWTH), 0));
}

export function penFor(h: HatchingParameters, family: Family, tone: Value): Pen {
  const open = oneMinus(tone).mul(oneMinus(tone)).toVar();
  const above = max(tone.sub(ALL_FROM), 0).toVar();
  const there = rampSum(tone).sub(rampSum(above)).div(ALL_FROM);
  const width = tone.div(max(there.mul(oneMinus(open.mul(LOST))), 1e-4)).toVar();
  const drawn = select(tone.lessThan(ALL_FROM), min(width, NIB), width).toVar();
  return { family, along: alongLines(h, family), tone, open, width: drawn };
}

/** The lot below which strokes have been born where so large a share of them is, each over a part BIRTH of all lots. */
function bornBelow(share: Value): Value {
  const grown = select(
    share.lessThan(1 - 0.5 * BIRTH),
    share.add(0.5 * BIRTH),
    float(1 + BIRTH).sub(sqrt(max(oneMinus(share).mul(2 * BIRTH), 0))),
  );
  return select(share.lessThan(0.5 * BIRTH), sqrt(share.mul(2 * BIRTH)), grown).toVar();
}

/** A number in [0, 1) that belongs to a stroke: random from line to line, and far from those of its neighbours on the line. */
function lotOfStroke(line: Value, stroke: Value): Value {
  const { GOLDEN_RATIO, THIRD_FACTOR, THUE_MORSE } = LOT_FACTORS;
  const spread = floatBitsToUint(line).mul(uint(GOLDEN_RATIO)).toVar();
  const ofLine = spread.bitXor(spread.shiftRight(uint(15))).mul(uint(THIRD_FACTOR));
  spread.assign(ofLine.add(uint(int(stroke)).mul(uint(THUE_MORSE))));
  return float(spread.shiftRight(uint(8)))
    .div(16777216)
    .toVar();
}

/** Width of the strokes on a line at this place, as a share of its room, and how far they stray from it, in distances between lines. */
function strokeOn(pen: Pen, born: Value, line: Value, place: Value, period: Value): Value {
  const number = numberOf(line, pen.family).toVar();
  const size = abs(number).toVar();
  const along = place.div(period).add(lotOf(size)).toVar();
  const stroke = floor(along).toVar();
  const lot = lotOfStroke(size, stroke);
  const other = fract(lot.mul(GAP_LOT)).toVar();
  // From −1 at one end to 1 at the other.
  const way = along.sub(stroke).mul(2).sub(1).toVar();
  const grown = clamp(pen.tone.sub(lot.mul(ALL_FROM)).div(STROKE_GROWTH), 0, 1).toVar();
  const left = oneMinus(abs(way)).sub(pen.open.mul(STROKE_GAP).mul(other)).sub(oneMinus(grown).mul(SHORTENING));
  const rest = clamp(oneMinus(left.div(max(pen.open.mul(TAPER), 1e-3))), 0, 1).toVar();
  const there = grown.mul(clamp(born.sub(fract(lot.mul(BIRTH_LOT))).div(BIRTH), 0, 1));
  const spread = handmade
    .mul(WIDTH_SPREAD)
    .mul(pen.open)
    .mul(fract(lot.mul(WIDTH_LOT)).sub(0.5))
    .add(1);
  const leaning = other.sub(0.5).mul(LEANING).mul(way);
  const astray = leaning.add(
    lot
      .sub(0.5)
      .mul(BENDING)
      .mul(float(0.5).sub(way.mul(way))),
  );
  return vec2(
    pen.width
      .mul(there)
      .mul(spread)
      .mul(oneMinus(rest.mul(rest))),
    handmade.mul(pen.open).mul(sign(number)).mul(astray),
  ).toVar();
}

/** Most places lie along one axis and at one length of strokes; others share theirs. */
function strokesOn(pen: Pen, born: Value, line: Value): Value {
  const { along } = pen;
  const isFirst = along.share.greaterThanEqual(0.5).toVar();
  const other = min(along.share, oneMinus(along.share)).toVar();
  const strokes = vec2(0).toVar();
  Loop({ start: int(0), end: int(4), type: 'int', condition: '<' }, ({ i }) => {
    const isOther = i.greaterThanEqual(int(2)).toVar();
    const isLonger = i
      .equal(int(1))
      .or(i.equal(int(3)))
      .toVar();
    const ofAxis = select(isOther, other, oneMinus(other));
    const share = ofAxis.mul(select(isLonger, along.longer, oneMinus(along.longer))).toVar();
    If(share.greaterThan(0), () => {
      const place = select(isFirst.equal(isOther), along.places.y, along.places.x).toVar();
      const period = select(isLonger, along.period.mul(2), along.period).toVar();
      strokes.addAssign(strokeOn(pen, born, line, place, period).mul(share));
    });
  });
  return strokes;
}

/**
 * @param away from the line, signed, in pixels
 * @param share of the room of old lines that the line has
 * @param spacing of old lines, pixels
 */
export function penCoverage(pen: Pen, away: Value, share: Value, spacing: Value, line: Value): Value {
  // Young strokes are fewer and thinner at once: as wide as the old ones, they would fill the room between them.
  const grown = sqrt(max(share, 0)).toVar();
  const born = bornBelow(grown);
  const stroke = strokesOn(pen, born, line);
  const halfWidth = spacing.mul(0.5).mul(grown).mul(stroke.x).toVar();
  return lineCoverage(abs(away.sub(spacing.mul(stroke.y))), halfWidth, FRINGE);
}
