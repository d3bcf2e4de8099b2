/** Counterpart of shaders/techniques/lines/penStrokes.glsl: lines drawn in strokes of a pen. */
import { PEN_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { lineCoverage } from '../base/maths.js';
import { tsl, type Value } from '../base/values.js';
import { hash01, irregularity, turnOf } from './hand.js';
import type { Family, HatchingParameters } from './read.js';
import { type Along, alongLines, bitsOfLine, differing, FRINGE, numberOf, strokeHash01 } from './strokeLengths.js';

const { abs, clamp, float, floor, fract, If, int, Loop, max, min, mix, select, sign, sqrt } = tsl;
const { uint, vec2 } = tsl;
const { ALL_FROM, AXIS_HASH, AXIS_TURN, BENDING, BIRTH, BIRTH_HASH, CLOSED_FROM, GAP_HASH, LATE_HASH, LATENESS } =
  PEN_CONSTANTS;
const { LEANING, NIB } = PEN_CONSTANTS;
const { SHORTENING, SHORTENING_OF_INK, STROKE_GAP, STROKE_GROWTH, TAPER, WIDTH_HASH, WIDTH_SPREAD } = PEN_CONSTANTS;

/** The share of a line that is lost to the gaps and the tapered ends of its strokes where the gaps are widest. */
const LOST = 0.5 * STROKE_GAP + TAPER / 3;

export interface Pen {
  family: Family;
  along: Along;
  tone: Value;
  /** The size of the gaps between strokes. */
  open: Value;
  /** The tone from which on no stroke is left out. */
  allFrom: Value;
  /** The width of a stroke in its middle, as a share of the room of a line. */
  width: Value;
  /** The greatest width of any stroke there. */
  widest: Value;
  /** How far strokes lie off their lines at most, in distances between lines. */
  strays: Value;
}

/** The integral of the ink of a growing stroke: a ramp from 0 to 1, and less where it is short. */
function rampSum(x: Value): Value {
  const grown = min(x.div(STROKE_GROWTH), 1).toVar();
  const lessShort = float(0.5).sub(float(0.5).sub(grown.div(3)).mul(SHORTENING_OF_INK));
  return grown
    .mul(grown)
    .mul(lessShort)
    .mul(STROKE_GROWTH)
    .add(max(x.sub(STROKE_GROWTH), 0));
}

export function penFor(h: HatchingParameters, family: Family, tone: Value, octave: Value): Pen {
  const allFrom = differing(family, octave).mul(ALL_FROM).toVar();
  const light = max(tone.div(CLOSED_FROM).oneMinus(), 0).toVar();
  const open = light.mul(light).toVar();
  const above = max(tone.sub(allFrom), 0).toVar();
  const there = rampSum(tone).sub(rampSum(above)).div(allFrom);
  const width = tone.div(max(there.mul(open.mul(LOST).oneMinus()), 1e-4)).toVar();
  const drawn = select(tone.lessThan(allFrom), min(width, NIB), width).toVar();
  const uneven = irregularity.mul(open).toVar();
  return {
    ...{ family, along: alongLines(h, family), tone, open, allFrom, width: drawn },
    widest: drawn.mul(uneven.mul(0.5 * WIDTH_SPREAD).add(1)).toVar(),
    strays: uneven.mul(0.5 * LEANING + 0.25 * BENDING).toVar(),
  };
}

/** The hash below which strokes exist if a given share of them does. Each appears over a part BIRTH of all hashes. */
function bornBelow(share: Value): Value {
  const grown = select(
    share.lessThan(1 - 0.5 * BIRTH),
    share.add(0.5 * BIRTH),
    float(1 + BIRTH).sub(sqrt(max(share.oneMinus().mul(2 * BIRTH), 0))),
  );
  return select(share.lessThan(0.5 * BIRTH), sqrt(share.mul(2 * BIRTH)), grown).toVar();
}

/** The delay of the start of a stroke, as a share of the mean length. */
const latenessOf = (chance: Value): Value => fract(chance.mul(LATE_HASH)).mul(LATENESS).toVar();

/**
 * The strokes of a line along one axis and of one length: their width here, as a share of the room, and their offset from the line, in
 * distances between lines.
 *
 * @param place in lengths of strokes
 * @param hash of the line; `turn` and `bits` too
 */
function strokeOn(
  pen: Pen,
  born: Value,
  place: Value,
  { hash, turn, bits }: Record<'hash' | 'turn' | 'bits', Value>,
): Value {
  const along = place.add(hash).toVar();
  // Strokes start late by chance, and so differ in length: otherwise the ends of neighbours would lie in rows across the lines.
  const stroke = floor(along).toVar();
  const begin = stroke.add(latenessOf(strokeHash01(bits, stroke)));
  stroke.assign(stroke.sub(select(along.lessThan(begin), 1, 0)));
  const chance = strokeHash01(bits, stroke);
  const late = latenessOf(chance);
  const size = latenessOf(strokeHash01(bits, stroke.add(1)))
    .sub(late)
    .add(1);
  // The place on the stroke, from −1 at one end to 1 at the other.
  const way = along.sub(stroke).sub(late).mul(2).div(size).sub(1).toVar();
  // Properties of strokes are spread evenly over a surface. The first strokes to appear lie on one of three neighbouring lines.
  const even = strokeHash01(uint(hash.mul(16777216)).shiftLeft(uint(8)), stroke);
  const order = fract(turn.add(even.div(3)));
  const grown = clamp(pen.tone.sub(pen.allFrom.mul(order)).div(STROKE_GROWTH), 0, 1).toVar();
  const gap = fract(even.mul(GAP_HASH)).toVar();
  const inside = abs(way).oneMinus().sub(pen.open.mul(STROKE_GAP).mul(gap)).sub(grown.oneMinus().mul(SHORTENING));
  const taper = pen.open.mul(TAPER).toVar();
  const rest = clamp(taper.sub(inside).div(max(taper, 1e-3)), 0, 1).toVar();
  const there = grown.mul(clamp(born.sub(fract(even.mul(BIRTH_HASH))).div(BIRTH), 0, 1));
  const spread = irregularity
    .mul(WIDTH_SPREAD)
    .mul(pen.open)
    .mul(fract(even.mul(WIDTH_HASH)).sub(0.5))
    .add(1);
  const leaning = gap.sub(0.5).mul(LEANING).mul(way);
  const astray = leaning.add(
    chance
      .sub(0.5)
      .mul(BENDING)
      .mul(float(0.5).sub(way.mul(way))),
  );
  return vec2(
    pen.width.mul(there).mul(spread).mul(rest.mul(rest).oneMinus()),
    irregularity.mul(pen.open).mul(astray),
  ).toVar();
}

/** The share of the first axis on a line: lines change from one axis to the other one by one. */
const firstOnLine = (along: Along, hash: Value): Value =>
  clamp(
    along.share
      .mul(1 + AXIS_TURN)
      .sub(fract(hash.mul(AXIS_HASH)))
      .div(AXIS_TURN),
    0,
    1,
  ).toVar();

/** Most fragments lie along one axis and at one length of strokes; others blend two of each. */
function strokesOn(pen: Pen, born: Value, line: Value): Value {
  const { along } = pen;
  const number = numberOf(line, pen.family).toVar();
  const size = abs(number).toVar();
  const hash = hash01(size).toVar();
  const turn = turnOf(size);
  const bits = bitsOfLine(size);
  const first = firstOnLine(along, hash);
  const isFirst = first.greaterThanEqual(0.5).toVar();
  const other = min(first, first.oneMinus()).toVar();
  const strokes = vec2(0).toVar();
  Loop({ start: int(0), end: int(4), type: 'int', condition: '<' }, ({ i }) => {
    const isOther = i.greaterThanEqual(int(2)).toVar();
    const isLonger = i
      .equal(int(1))
      .or(i.equal(int(3)))
      .toVar();
    const ofAxis = select(isOther, other, other.oneMinus());
    const share = ofAxis.mul(select(isLonger, along.longer, along.longer.oneMinus())).toVar();
    If(share.greaterThan(0), () => {
      const place = select(isFirst.equal(isOther), along.places.y, along.places.x).toVar();
      const period = select(isLonger, along.period.mul(2), along.period).toVar();
      strokes.addAssign(strokeOn(pen, born, place.div(period), { hash, turn, bits }).mul(share));
    });
  });
  return vec2(strokes.x, sign(number).mul(strokes.y)).toVar();
}

/**
 * How many strokes of a line there are, and how thin. New strokes are fewer and thinner at once: at full width they would fill the room
 * between the old ones. In the darks they are only thinner, since a missing stroke would be a hole.
 *
 * @param share of the room of old lines that the line has
 */
export const thereOn = ({ open }: Pen, share: Value): Value => mix(1, sqrt(max(share, 0)), sqrt(open)).toVar();

/**
 * @param away signed distance from the line, pixels
 * @param room half of the line's room, pixels
 * @param there see `thereOn`
 * @param spacing of old lines, pixels
 */
export function penCoverage(
  pen: Pen,
  line: Value,
  { away, room, there, spacing }: Record<'away' | 'room' | 'there' | 'spacing', Value>,
): Value {
  const whole = room.div(max(there, 1e-4)).toVar();
  const reach = max(whole.mul(pen.widest), 0.5).add(FRINGE).add(spacing.mul(pen.strays));
  const covered = float(0).toVar();
  // Most pixels are touched by one line at most.
  If(abs(away).lessThan(reach), () => {
    const stroke = strokesOn(pen, bornBelow(there), line);
    covered.assign(lineCoverage(abs(away.sub(spacing.mul(stroke.y))), whole.mul(stroke.x).toVar(), FRINGE));
  });
  return covered;
}
