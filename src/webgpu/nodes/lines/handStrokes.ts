/**
 * Counterpart of shaders/chunks/handStrokes.glsl: whole strokes of a hand. The level sets of a function are rows, another function tells the place along a row, and a row is divided into cells of one stroke each.
 */
import { DataTexture, HalfFloatType, LinearFilter, RGFormat } from 'three';
import { LINE_CONSTANTS, PEN_CONSTANTS } from '../../../look/constants/lineConstants.js';
import { HASH_FACTORS, SCREEN_CONSTANTS } from '../../../look/constants/patternConstants.js';
import { HAND_STROKE_CONSTANTS, HAND_TEXTURE, MOST_ROWS } from '../../../strokes/handConstants.js';
import { identity, lineCoverage, safeNormalize } from '../base/maths.js';
import { hatchingTexture, hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { readViewToAnchor } from '../chunks/anchor.js';
import {
  centreOfScreen,
  type ScreenMap,
  screenGradient,
  screenMapOf,
  viewUnitsPerPixel,
} from '../chunks/screenGradient.js';
import { castShadowsOf } from '../chunks/strokeShadows.js';
import { objectToField } from './emit.js';
import { vFieldNormal } from './fields.js';
import { lineBits, turnOf } from './hand.js';
import type { Family, HatchingParameters } from './read.js';
import {
  alongLines,
  bitsOfLine,
  crossed,
  FRINGE,
  numberOf,
  octaveOf,
  octaves,
  powerOf2,
  screenSpaceShare,
  strokeHash01,
  strokeLength,
  trianglePerPixelOf,
} from './strokeLengths.js';

const { abs, Break, ceil, clamp, dot, float, floor, fract, If, int, length, log2, Loop, max, min, mix, pow, select } =
  tsl;
const { positionView, sqrt, uint, vec2, vec3 } = tsl;
const { PARTS_OF_TILE } = LINE_CONSTANTS;
const { AXIS_HASH, AXIS_TURN } = PEN_CONSTANTS;
const { SECOND_FACTOR, THIRD_FACTOR, THUE_MORSE } = HASH_FACTORS;
const { HAND_ROWS, PLACES, TONE_ROWS } = HAND_TEXTURE;
const { AXIS_RISE, BUNDLE_CELLS, BUNDLED_ROWS, COVERED_OF_FILLED, GROWING, GROWTH, LONGEST_IN_PAIR, PAIR_TURN } =
  HAND_STROKE_CONSTANTS;
const { LANE_STEADINESS, ROW_SHIFT, SHAPE_HASH, SHAPES_OF_RANK, SIZE_HASH, START_HASH, WIDE_FROM, WIDENED_ENDS } =
  HAND_STROKE_CONSTANTS;

/** Placeholder with the format and the filter that the texture of a hand has. */
function blankStrokes(): DataTexture {
  const texture = new DataTexture(new Uint16Array(2), 1, 1, RGFormat, HalfFloatType);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export { castShadowsOf };

const handStrokes = /* @__PURE__ */ hatchingTexture('handStrokes', /* @__PURE__ */ blankStrokes());
const handReach = /* @__PURE__ */ hatchingUniform('handReach', 'vec4');
const handRows = /* @__PURE__ */ hatchingUniform('handRows', 'vec2');
const handLanes = /* @__PURE__ */ hatchingUniform('handLanes', 'vec2');

/** @param column, row texels of the hand's texture */
const texelAt = (column: Value, row: Value): Value =>
  handStrokes
    .sample(vec2(column.div(PLACES), row.div(HAND_ROWS)))
    .level(0)
    .xy.toVar();

/** The cells of a family's rows. */
interface Cells {
  /** Two coordinates along the rows, in tiles. */
  places: Value;
  /** Share of the first coordinate. */
  share: Value;
  /** Places after which cells repeat across a seam of the bake. */
  repeat: Value;
  /** Length of a cell. */
  period: Value;
  /** Share of the pairs of cells that hold one stroke together. */
  paired: Value;
  /** Part of such a pair that its stroke may fill. */
  longest: Value;
  /** Change of the places from one pixel to the next along a row, on the screen. */
  perPixelOfRow: Value;
  /** Change of the places, straight across a row on the screen, while the family's function grows by 1. */
  askew: Value;
  isOfForm: boolean;
  /** Null where shadows cut strokes. */
  onSurface: OnSurface | null;
}

/** Steps on the surface, and its normal, view space. */
interface OnSurface {
  /** Along a row while each of the places grows by 1. */
  steps: readonly [Value, Value];
  /** Straight across rows while the family's function grows by 1. */
  stepAcross: Value;
  normal: Value;
}

/** Whether a family is the first, which takes strokes of the light swatch too. */
const isFirst = (h: HatchingParameters, { value }: Family): Value => value.equal(h.firstFamily().value);

/** The family across one that follows the form, whose function tells the place along its lines. */
function familyAcross(h: HatchingParameters, { value }: Family): Family {
  const first = h.firstFamily();
  return value === first.value ? h.crossingFamily(true, [float(1), float(0)]) : first;
}

/** The coordinates along the rows of a family, with their gradients on the screen. */
function placesOf(
  h: HatchingParameters,
  family: Family,
): Pick<Cells, 'places' | 'share' | 'repeat'> & Record<'rise' | 'first' | 'second', Value> {
  if (family.isOfForm) {
    const { value, rise, gradient, coarsest } = familyAcross(h, family);
    const onScreen = screenGradient(gradient, h.onScreen).toVar();
    const repeat = powerOf2(float(coarsest).toVar()).toVar();
    return {
      places: vec2(value).toVar(),
      share: float(1),
      repeat,
      rise: rise.toVar(),
      first: onScreen,
      second: onScreen,
    };
  }
  const { places, share, first, second } = alongLines(h, family);
  return {
    ...{ places, share, repeat: float(ROW_SHIFT), rise: float(AXIS_RISE) },
    first: screenGradient(first, h.onScreen).toVar(),
    second: screenGradient(second, h.onScreen).toVar(),
  };
}

/** Tiles from one pixel to the next, on a surface that faces the viewer. */
const tilesPerPixel = ({ builder }: HatchingParameters): Value =>
  viewUnitsPerPixel().mul(length(objectToField.mul(readViewToAnchor(builder).mul(vec3(1, 0, 0)))));

/** The Jacobian of the map from pixels to the tangent plane in view space. @param normal view space, of any length */
function tangentOnScreen(normal: Value): ScreenMap {
  const centre = centreOfScreen();
  const facing = abs(dot(normal, vec3(centre, 1)));
  const least = length(normal).mul(SCREEN_CONSTANTS.LEAST_FACING);
  return screenMapOf(normal.mul(viewUnitsPerPixel().div(max(facing, least))).toVar(), centre, identity());
}

const viewStep = (step: Value, [x, y]: ScreenMap): Value => x.mul(step.x).add(y.mul(step.y));

/** The view-space step along a row while a place grows by 1. @param change of the place, on the screen @param ofRow its way there */
function stepOf(inView: ScreenMap, change: Value, ofRow: Value, least: Value): Value {
  const perPixel = dot(change, ofRow).toVar();
  const pixels = select(perPixel.lessThan(0), float(-1), float(1)).div(max(abs(perPixel), least));
  return viewStep(ofRow.mul(pixels).toVar(), inView).toVar();
}

/** @param across unit, straight across a row on the screen @param changes of the places, on the screen, and `least`, the least of them */
function onSurfaceAt(
  { builder }: HatchingParameters,
  family: Family,
  across: Value,
  { first, second, least }: Record<'first' | 'second' | 'least', Value>,
): OnSurface {
  const normal = safeNormalize(vFieldNormal)
    .mul(objectToField.mul(readViewToAnchor(builder)))
    .toVar();
  const inView = tangentOnScreen(normal);
  const ofRow = vec2(across.y.negate(), across.x).toVar();
  return {
    steps: [stepOf(inView, first, ofRow, least), stepOf(inView, second, ofRow, least)],
    stepAcross: viewStep(across.div(max(family.perPixel, 1e-12)).toVar(), inView).toVar(),
    normal: safeNormalize(normal).toVar(),
  };
}

function cellsFor(h: HatchingParameters, family: Family): Cells {
  const { places, share, repeat, rise, first, second } = placesOf(h, family);
  // The length of a stroke does not depend on the slant at which it is seen, so that no stroke is cut where the form turns away.
  const perPixel = max(tilesPerPixel(h).mul(rise), 1e-12).toVar();
  const gradient = screenGradient(family.gradient, h.onScreen).toVar();
  const across = gradient.div(max(length(gradient), 1e-12)).toVar();
  const least = perPixel.mul(0.1).toVar();
  const perPixelOfRow = max(vec2(crossed(first, across), crossed(second, across)), least).toVar();
  const askew = vec2(dot(first, across), dot(second, across)).div(max(family.perPixel, 1e-12)).toVar();
  const onObject = octaves(strokeLength.div(PARTS_OF_TILE).mul(rise).toVar());
  const onScreen = octaves(strokeLength.mul(perPixel).toVar());
  const octave = mix(onObject, onScreen, screenSpaceShare).toVar();
  const period = powerOf2(floor(octave)).toVar();
  // Strokes of one cell and of two have the wanted length in the mean.
  const wanted = clamp(powerOf2(octave).div(period), 1, 2).toVar();
  // Strokes of two lanes fill their cells evenly.
  const most = select(handLanes.x.greaterThan(0), float(2), min(wanted.mul(LONGEST_IN_PAIR), 2)).toVar();
  const paired = wanted.sub(1).mul(2).div(most.add(wanted).sub(2)).toVar();
  const { isOfForm } = family;
  const onSurface = h.castShadows ? onSurfaceAt(h, family, across, { first, second, least }) : null;
  const longest = most.mul(0.5).toVar();
  return { places, share, repeat, period, paired, longest, perPixelOfRow, askew, isOfForm, onSurface };
}

/** The rank below which strokes are there if a given share of them is, and the range over which they grow: few strokes are whole too. */
function bornBelow(share: Value): Value {
  const few = share.div(1 - 0.5 * GROWING).toVar();
  const most = share.add(0.5 * GROWTH).toVar();
  const all = float(1 + GROWTH).sub(sqrt(max(share.oneMinus().mul(2 * GROWTH), 0)));
  return select(
    few.mul(GROWING).lessThan(GROWTH),
    vec2(few, max(few.mul(GROWING), 1e-6)),
    vec2(select(most.lessThanEqual(1), most, all), GROWTH),
  ).toVar();
}

/** A row as a pixel sees it. */
interface Row {
  /** Its number among the old rows; young ones lie half way between two. */
  number: Value;
  /** Distance of old rows, in mean distances. */
  apart: Value;
  /** Signed distance from it, in distances between rows. */
  away: Value;
  /** −1 where rows are numbered, and run, the other way. */
  way: Value;
  turn: Value;
  /** Random bits, and others that are spread evenly over neighbouring rows. */
  bits: Value;
  evenBits: Value;
  /** Differing bits of the second lane, and by how many cells its cells begin later. */
  ofLane: Value;
  late: Value;
  /** Rank below which its strokes are there, and the range of ranks over which they grow. */
  born: Value;
  /** What is added to half widths. */
  widening: Value;
  /** The same in the shadows that are read along strokes; null where shadows cut them. */
  inShadow: ShadedRow | null;
}

interface ShadedRow extends Pick<Row, 'born' | 'widening'> {
  /** The nearest point of the row, view space. */
  middle: Value;
  /** The share of the light that shadows take at a place. @param viewPosition of it */
  shadowAt(viewPosition: Value): Value;
}

/**
 * The number of a cell among those of a row that differ: the same on both sides of a seam, unless a cell is longer than what the seam repeats
 * after.
 */
const numberOfCell = (cell: Value, repeat: Value, isOfForm: boolean): Value =>
  isOfForm ? select(repeat.greaterThan(1), cell.sub(repeat.mul(floor(cell.div(repeat)))), cell).toVar() : cell;

/** The number of a row within its bundle, 0 for the middle one. Whole rows lie far from where the fraction jumps. */
function fromMiddle(row: Value): Value {
  const shifted = row.add(0.5 * BUNDLED_ROWS).toVar();
  return shifted.sub(floor(shifted.div(BUNDLED_ROWS)).mul(BUNDLED_ROWS)).sub(0.5 * BUNDLED_ROWS);
}

/** How far a stroke lies aside of its row, in mean distances. @param lot of the bundles of its row, from 0 to BUNDLED_ROWS − 1 */
function bundledAside({ number, apart }: Row, lot: Value): Value {
  const ofAll = fromMiddle(number.mul(2).add(lot)).mul(0.5).toVar();
  const ofOld = mix(fromMiddle(number.add(lot)), ofAll, apart.sub(1));
  const drawn = select(fract(number).equal(0), ofOld, ofAll);
  return handRows.y.negate().mul(apart).mul(drawn);
}

const grownAt = (born: Value, rank: Value): Value => clamp(born.x.sub(rank).div(born.y), 0, 1);

/** The coordinate along which strokes are counted, and its share of them. */
interface Counted extends Record<'place' | 'share' | 'perPixelOfRow', Value> {
  /** The step along a row while it grows by 1, view space; null where shadows cut strokes. */
  step: Value | null;
}

/** The share of a pixel that the strokes of a row cover, counted along one coordinate. @param spacing pixels */
function strokeCoverage(
  row: Row,
  cells: Cells,
  { place, share, perPixelOfRow, step }: Counted,
  isDark: Value,
  spacing: Value,
): Value {
  const { isOfForm, paired, period, repeat } = cells;
  const covered = float(0).toVar();
  // Rows are shifted by chance: any rule would show where their strokes end.
  const shift = strokeHash01(row.bits, float(0));
  const x = row.way.mul(place).add(shift.mul(repeat)).div(period).sub(row.late).toVar();
  const most = repeat.div(period).toVar();
  const half = most.mul(0.5).toVar();
  const pair = floor(x.mul(0.5)).toVar();
  // Each pair of strokes gives way to one twice as long at a moment of its own.
  const moment = strokeHash01(row.bits.bitXor(uint(SECOND_FACTOR)).toVar(), numberOfCell(pair, half, isOfForm));
  const turned = paired
    .mul(1 + PAIR_TURN)
    .sub(moment)
    .div(PAIR_TURN)
    .toVar();
  const isPair = turned.greaterThan(0.5).toVar();
  const there = clamp(select(isPair, turned.mul(2).sub(1), float(1).sub(turned.mul(2))), 0, 1).toVar();
  const cell = select(isPair, pair, floor(x)).toVar();
  const inCell = select(isPair, x.mul(0.5).sub(pair), x.sub(cell)).toVar();
  const repeatOfCell = select(isPair, half, most).toVar();
  const number = numberOfCell(cell, repeatOfCell, isOfForm);
  const chance = strokeHash01(row.bits.bitXor(row.ofLane), number);
  // Ranks are spread evenly over a surface: the first strokes lie on one of three neighbouring rows.
  const even = strokeHash01(row.evenBits.bitXor(row.ofLane), number);
  const rank = fract(row.turn.add(even.div(3))).toVar();
  const onAxis = share
    .mul(1 + AXIS_TURN)
    .sub(fract(chance.mul(AXIS_HASH)))
    .div(AXIS_TURN);
  there.assign(min(there, onAxis));
  const shorter = handRows.x.mul(fract(chance.mul(SIZE_HASH)));
  const size = handReach.w
    .mul(shorter.oneMinus())
    .mul(select(isPair, cells.longest, float(1)))
    .toVar();
  const steadiness = select(handLanes.x.greaterThan(0), float(LANE_STEADINESS), float(0));
  const begin = size.oneMinus().mul(mix(fract(chance.mul(START_HASH)), 0.5, steadiness));
  const inFull = inCell.sub(begin).div(size).toVar();
  const cellLength = select(isPair, period.mul(2), period).toVar();
  If(there.greaterThan(0).and(inFull.greaterThan(0)).and(inFull.lessThan(1)), () => {
    const aside = row.way.mul(row.away).toVar();
    If(handRows.y.greaterThan(0), () => {
      // Strokes side by side are of one bundle, and others farther along: no gap runs all along the rows.
      const block = floor(cell.add(0.5).sub(shift.mul(repeatOfCell)).div(BUNDLE_CELLS)).toVar();
      const ofBlock = numberOfCell(block, repeatOfCell.div(BUNDLE_CELLS).toVar(), isOfForm);
      const lot = floor(strokeHash01(uint(SECOND_FACTOR), ofBlock).mul(BUNDLED_ROWS)).toVar();
      aside.assign(aside.sub(bundledAside(row, lot)));
    });
    const part: GrownPart = {
      grown: grownAt(row.born, rank).toVar(),
      left: float(1).toVar(),
      widening: row.widening,
    };
    const { inShadow } = row;
    if (inShadow && step) {
      part.widening = row.widening.toVar();
      const whole = row.way.mul(size).mul(cellLength).mul(step).toVar();
      const widest = handReach.y.add(handReach.z).add(max(row.widening, inShadow.widening));
      const isNear = spacing.mul(abs(aside).sub(widest)).lessThanEqual(FRINGE);
      endAtShadows(part, { inShadow, isNear, rank, inFull }, (at) => inShadow.middle.add(whole.mul(at.sub(inFull))));
    }
    there.assign(min(there, part.grown));
    const { left } = part;
    // A stroke that is not there in full is shorter, and ends as the hand ends it.
    const t = inFull.sub(0.5).div(there.mul(left)).add(0.5).toVar();
    If(there.greaterThan(0).and(t.greaterThan(0)).and(t.lessThan(1)), () => {
      const ofRank = mix(isDark.mul(0.5), 1, rank).mul(1 - SHAPES_OF_RANK);
      const chosen = ofRank.add(fract(chance.mul(SHAPE_HASH)).mul(SHAPES_OF_RANK));
      const shape = min(floor(handReach.x.mul(chosen)), handReach.x.sub(1));
      const stroke = texelAt(t.mul(PLACES - 1).add(0.5), shape.add(0.5));
      const fromEnd = min(t, t.oneMinus()).toVar();
      const widened = stroke.y.add(part.widening.mul(min(fromEnd.mul(WIDENED_ENDS), 1)));
      const halfWidth = widened
        .mul(min(there.div(WIDE_FROM), 1))
        .mul(spacing)
        .toVar();
      // Blunt ends are round, as the tip of a pen leaves them.
      const toEnd = fromEnd.mul(there).mul(left).mul(size).mul(cellLength).div(perPixelOfRow);
      const cap = max(toEnd.div(max(halfWidth, 0.5)).oneMinus(), 0).toVar();
      const rounded = halfWidth.mul(sqrt(cap.mul(cap).oneMinus())).toVar();
      covered.assign(lineCoverage(spacing.mul(abs(aside.sub(stroke.x))), rounded, FRINGE));
    });
  });
  return covered;
}

/** How far a stroke has grown, the part that shadows leave of the half that the pixel sees, and what is added to its half widths. */
interface GrownPart {
  grown: Value;
  left: Value;
  widening: Value;
}

/**
 * Ends a stroke at the edges of shadows.
 *
 * @param part variables, as far as no shadow falls; they are changed
 * @param isNear whether the stroke may touch the pixel
 * @param inFull the place along the stroke in full, from 0 to 1
 * @param placeAt another such place, view space
 */
function endAtShadows(
  { grown, left, widening }: GrownPart,
  { inShadow, isNear, rank, inFull }: { inShadow: ShadedRow } & Record<'isNear' | 'rank' | 'inFull', Value>,
  placeAt: (at: Value) => Value,
): void {
  const shaded = grownAt(inShadow.born, rank).toVar();
  const isOther = grown.notEqual(shaded).or(widening.notEqual(inShadow.widening));
  If(isNear.and(isOther), () => {
    // The shadows at its middle, and at the middle of the third at this end.
    const shadows = vec2(0).toVar();
    const end = select(inFull.lessThan(0.5), float(1 / 6), float(5 / 6)).toVar();
    Loop({ start: int(0), end: int(2), type: 'int', condition: '<', name: 'place' }, ({ place }) => {
      const isMiddle = place.equal(int(0)).toVar();
      const there = inShadow.shadowAt(placeAt(select(isMiddle, float(0.5), end)).toVar());
      shadows.assign(select(isMiddle, vec2(there, 0), vec2(shadows.x, there)));
      // A stroke is there as far as its middle is.
      If(mix(grown, shaded, shadows.x).greaterThan(0).not(), () => {
        Break();
      });
    });
    const parts = mix(vec2(grown), vec2(shaded), shadows).toVar();
    grown.assign(parts.x);
    // An end that is not there loses a sixth of the stroke, so that what is left is no fleck.
    left.assign(
      max(parts.y.div(max(grown, 1e-6)).oneMinus(), 0)
        .div(3)
        .oneMinus(),
    );
    widening.assign(mix(widening, inShadow.widening, shadows.x));
  });
}

/** How a family draws a tone. */
interface Drawn {
  /** Of old and of young rows: the rank below which strokes are there, and the range of ranks over which they grow. */
  bornOld: Value;
  bornYoung: Value;
  /** What is added to half widths. */
  widening: Value;
}

/**
 * The tone that rows have whose strokes fill their cells as the hand's do, where those that fill less of them have a given tone. A row
 * darkens by as much as it fills less, and where rows overlap each lets through what the others leave.
 */
function filledTone(tone: Value, filled: Value): Value {
  const ofCells = handReach.w.mul(handRows.x.mul(0.5).oneMinus()).mul(COVERED_OF_FILLED).toVar();
  const left = ofCells.mul(filled).toVar();
  const dark = pow(tone.oneMinus(), log2(ofCells.oneMinus()).div(log2(left.oneMinus()))).oneMinus();
  return select(tone.lessThan(left), tone.div(filled), dark);
}

/** @param filled how much of the share of their cells that the hand's strokes fill is filled. @param young the share of the strokes of young rows */
function drawnAs(tone: Value, filled: Value, young: Value): Drawn {
  const wanted = filledTone(clamp(tone, 0, 1).toVar(), filled);
  const row = young.mul(TONE_ROWS - 1).add(HAND_ROWS - TONE_ROWS + 0.5);
  const drawn = texelAt(wanted.mul(PLACES - 1).add(0.5), row);
  return { bornOld: bornBelow(drawn.x), bornYoung: bornBelow(young.mul(drawn.x).toVar()), widening: drawn.y };
}

/** A row in shadows. @param away distance from it, in units of the family's function */
function shadedRow(
  { castShadows }: HatchingParameters,
  { onSurface }: Cells,
  drawn: Drawn,
  { isYoung, away }: Record<'isYoung' | 'away', Value>,
): ShadedRow | null {
  if (!castShadows || !onSurface) return null;
  return {
    born: select(isYoung, drawn.bornYoung, drawn.bornOld).toVar(),
    widening: drawn.widening,
    middle: positionView.sub(onSurface.stepAcross.mul(away)).toVar(),
    shadowAt: (place) => castShadows.at(place, onSurface.normal),
  };
}

/** The darkness of a family. */
export function ruledLines(h: HatchingParameters, family: Family, tone: Value): Value {
  const trianglePerPixel = trianglePerPixelOf(family);
  const octave = min(octaveOf(h, family, trianglePerPixel), family.coarsest).toVar();
  const period = powerOf2(ceil(octave)).toVar();
  const spaced = powerOf2(octave).toVar();
  // Mean distance of rows, pixels.
  const spacing = spaced.div(trianglePerPixel).toVar();
  const apart = period.div(spaced).toVar();
  // Of the young rows, half way between the old ones, as many strokes are there as keep the mean distance.
  const young = clamp(apart.sub(1), 0, 1).toVar();
  const cells = cellsFor(h, family);
  // Strokes fill less of their cells where pairs have given way to one: as if the tone were darker.
  const filled = float(1)
    .sub(cells.paired.mul(cells.longest.oneMinus()))
    .mul(1 - 0.5 * PAIR_TURN);
  const { castShadows } = h;
  const drawn = drawnAs(castShadows ? tone.x : tone, filled, young);
  const inShadow = castShadows ? drawnAs(tone.y, filled, young) : null;
  const ofLight = drawn.bornYoung.x.greaterThan(0);
  const isYoungThere = (inShadow ? ofLight.or(inShadow.bornYoung.x.greaterThan(0)) : ofLight).toVar();
  const isDark = select(isFirst(h, family), float(0), float(1)).toVar();
  const x = family.value.div(period).toVar();
  const widening = inShadow ? max(drawn.widening, inShadow.widening) : drawn.widening;
  const widest = handReach.y.add(handReach.z).add(widening);
  const reach = widest.add(float(FRINGE).div(spacing)).div(apart).toVar();
  const first = ceil(x.sub(reach).mul(2)).toVar();
  const lanes = select(handLanes.x.greaterThan(0), int(2), int(1)).toVar();
  const last = x.add(reach).toVar();
  const blank = float(1).toVar();
  Loop({ start: int(0), end: int(2 * MOST_ROWS), type: 'int', condition: '<' }, ({ i }) => {
    const nth = i.div(lanes).toVar();
    const isSecond = i.sub(nth.mul(lanes)).greaterThan(int(0)).toVar();
    const line = first.add(float(nth)).mul(0.5).toVar();
    If(line.lessThanEqual(last).not(), () => {
      Break();
    });
    const isYoung = fract(line).notEqual(0).toVar();
    If(isYoung.not().or(isYoungThere), () => {
      const signed = numberOf(line.mul(period).toVar(), family);
      const way = cells.isOfForm ? select(signed.lessThan(0), float(-1), float(1)).toVar() : float(1);
      const number = select(signed.equal(0), float(0), way.mul(signed)).toVar();
      const turn = turnOf(number);
      const born = select(isYoung, drawn.bornYoung, drawn.bornOld).toVar();
      const ofShadow = inShadow && select(isYoung, inShadow.bornYoung, inShadow.bornOld).x;
      // The ranks of a row begin at its turn, unless some of them lie beyond 1.
      If(turn.lessThan(ofShadow ? max(born.x, ofShadow) : born.x).or(turn.greaterThan(2 / 3)), () => {
        const aside = x.sub(line).toVar();
        const row: Row = {
          ...{ apart, way, widening: drawn.widening },
          number: number.div(period).toVar(),
          away: aside
            .mul(apart)
            .add(select(isSecond, way.negate(), way).mul(handLanes.x))
            .toVar(),
          evenBits: lineBits(THUE_MORSE, number).bitAnd(uint(0xffffff00)).toVar(),
          ...{ turn, born },
          bits: bitsOfLine(number),
          ofLane: select(isSecond, uint(THIRD_FACTOR), uint(0)).toVar(),
          late: select(isSecond, handLanes.y, float(0)).toVar(),
          inShadow: inShadow && shadedRow(h, cells, inShadow, { isYoung, away: aside.mul(period).toVar() }),
        };
        // The places of the nearest point of the row: strokes end straight across their rows.
        const places = cells.places.sub(cells.askew.mul(aside.mul(period))).toVar();
        const print = (counted: Counted): void => {
          blank.mulAssign(strokeCoverage(row, cells, counted, isDark, spacing).oneMinus());
        };
        const { share, perPixelOfRow, isOfForm } = cells;
        const steps = cells.onSurface?.steps ?? null;
        if (isOfForm) print({ place: places.x, share, perPixelOfRow: perPixelOfRow.x, step: steps?.[0] ?? null });
        else {
          Loop({ start: int(0), end: int(2), type: 'int', condition: '<', name: 'axis' }, ({ axis }) => {
            const isOfFirst = axis.equal(int(0)).toVar();
            If(isOfFirst.or(share.lessThan(1)), () => {
              print({
                place: select(isOfFirst, places.x, places.y).toVar(),
                share: select(isOfFirst, share, share.oneMinus()).toVar(),
                perPixelOfRow: select(isOfFirst, perPixelOfRow.x, perPixelOfRow.y).toVar(),
                step: steps && select(isOfFirst, steps[0], steps[1]).toVar(),
              });
            });
          });
        }
      });
    });
    If(blank.greaterThan(0).not(), () => {
      Break();
    });
  });
  return blank.oneMinus();
}
