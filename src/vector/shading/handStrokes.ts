/**
 * Whole strokes of a hand, as in shaders/chunks/handStrokes.glsl. The level sets of a function are rows, another function tells the place
 * along a row, and a row is divided into cells of one stroke each. A fragment searches for rows near it; here the strokes on a given row are
 * computed.
 */
import { LINE_CONSTANTS, PEN_CONSTANTS } from '../../look/constants/lineConstants.js';
import { HASH_FACTORS } from '../../look/constants/patternConstants.js';
import { clamp01, combined, mix, type Vec3 } from '../../look/vectors.js';
import { HAND_STROKE_CONSTANTS, HAND_TEXTURE } from '../../strokes/handConstants.js';
import type { StrokeProfiles } from '../../strokes/strokeProfiles.js';
import { hash01, turnOf } from './hand.js';
import { bitsOfLine, strokeHash01 } from './penStrokes.js';
import { octaves, powerOf2 } from './ruledLines.js';
import { type ScreenMap, screenGradient, stepInView } from './screenGradient.js';
import { axesAlong, axisOf, crossed, numberOf, type StrokeLength } from './strokeLengths.js';

const { PLACES, TONE_ROWS } = HAND_TEXTURE;
const { PAIR_TURN, LONGEST_IN_PAIR, AXIS_RISE, ROW_SHIFT, GROWTH, GROWING, WIDE_FROM } = HAND_STROKE_CONSTANTS;
const { WIDENED_ENDS, SIZE_HASH, START_HASH, SHAPE_HASH, SHAPES_OF_RANK } = HAND_STROKE_CONSTANTS;
const { BUNDLED_ROWS, BUNDLE_CELLS, COVERED_OF_FILLED, LANE_STEADINESS } = HAND_STROKE_CONSTANTS;
const { PARTS_OF_TILE } = LINE_CONSTANTS;
const { AXIS_HASH, AXIS_TURN } = PEN_CONSTANTS;
const { SECOND_FACTOR, THIRD_FACTOR } = HASH_FACTORS;

type Pair = readonly [number, number];

const fract = (x: number): number => x - Math.floor(x);

/** A coordinate along rows. */
interface RowCoordinate {
  /** A number that tells it from others. */
  id: number;
  /** Its value, tiles. */
  place: number;
  /** The share of the strokes that are counted along it. */
  share: number;
  /** Its change from one pixel to the next along a row, on the screen. */
  perPixel: number;
  /** Its change, straight across a row on the screen, while the family's function grows by 1. */
  askew: number;
  /** The step along a row while it grows by 1, view space. */
  step: Vec3;
}

/** The cells of a family's rows at a place. */
export interface Cells {
  coordinates: readonly RowCoordinate[];
  /** The step straight across rows while the family's function grows by 1, view space. */
  stepAcross: Vec3;
  /** Places after which cells repeat across a seam of the bake, and whether there are seams. */
  repeat: number;
  hasSeams: boolean;
  /** Length of a cell. */
  period: number;
  /** Share of the pairs of cells that hold one stroke together, and the part of such a pair that its stroke may fill. */
  paired: number;
  longest: number;
}

/** A place of rows as the camera sees it. */
export interface SeenRows {
  /** Of the smooth surface. */
  map: ScreenMap;
  /** View units per pixel. */
  unitsPerPixel: number;
}

/** The length of a cell, and whether rows have two lanes of them. */
interface CellLength extends StrokeLength {
  hasLanes: boolean;
}

/** How a function changes at a place. */
export interface FunctionAt {
  value: number;
  /** Field space, per tile. */
  gradient: Vec3;
  /** Its change along the surface, per tile. */
  rise: number;
  /** The octave beyond which its level sets do not run on across seams. */
  coarsest: number;
}

/**
 * The cells of rows along the form.
 *
 * @param gradient of the family's function
 * @param along the function that tells the place along a row
 */
export function cellsAlongForm(gradient: Vec3, along: FunctionAt, seen: SeenRows, length: CellLength): Cells {
  const coordinates = [{ id: 0, place: along.value, share: 1, gradient: along.gradient }];
  const seams = { repeat: powerOf2(along.coarsest), hasSeams: true };
  return { ...seams, ...cellsFor(gradient, coordinates, along.rise, seen, length) };
}

/**
 * The cells of rows that a field cuts: each stroke is counted along one of the two axes along which the rows run most.
 *
 * @param gradient of the family's function
 * @param place and `normal` in field space
 */
export function cellsAlongAxes(gradient: Vec3, place: Vec3, normal: Vec3, seen: SeenRows, length: CellLength): Cells {
  const { first, second, share } = axesAlong(normal, gradient);
  const coordinates = [
    { id: first, place: place[first], share, gradient: axisOf(first) },
    { id: second, place: place[second], share: 1 - share, gradient: axisOf(second) },
  ];
  return { repeat: ROW_SHIFT, hasSeams: false, ...cellsFor(gradient, coordinates, AXIS_RISE, seen, length) };
}

function cellsFor(
  gradient: Vec3,
  along: readonly { id: number; place: number; share: number; gradient: Vec3 }[],
  rise: number,
  { map, unitsPerPixel }: SeenRows,
  { strokeLength, screenSpaceShare, hasLanes }: CellLength,
): Omit<Cells, 'repeat' | 'hasSeams'> {
  // The length of a stroke does not depend on the slant at which it is seen, so that no stroke is cut where the form turns away.
  const [x, y, z] = map.viewToPlace;
  const perPixel = Math.max(unitsPerPixel * Math.hypot(x[0], y[0], z[0]) * rise, 1e-12);
  const onScreen = screenGradient(gradient, map);
  const size = Math.hypot(...onScreen);
  const across: Pair = [onScreen[0] / Math.max(size, 1e-12), onScreen[1] / Math.max(size, 1e-12)];
  const coordinates = along
    .filter(({ share }) => share > 0)
    .map(({ id, place, share, gradient: ofPlace }): RowCoordinate => {
      const change = screenGradient(ofPlace, map);
      const alongRow = crossed(change, across);
      const isBack = change[1] * across[0] - change[0] * across[1] < 0;
      const pixels = (isBack ? -1 : 1) / Math.max(alongRow, 0.1 * perPixel);
      return {
        ...{ id, place, share },
        perPixel: Math.max(alongRow, 0.1 * perPixel),
        step: stepInView([-across[1] * pixels, across[0] * pixels], map),
        askew: (change[0] * across[0] + change[1] * across[1]) / Math.max(size, 1e-12),
      };
    });
  const octave = mix(
    octaves((strokeLength / PARTS_OF_TILE) * rise),
    octaves(strokeLength * perPixel),
    screenSpaceShare,
  );
  const period = powerOf2(Math.floor(octave));
  // Strokes of one cell and of two have the wanted length in the mean.
  const wanted = Math.min(Math.max(powerOf2(octave) / period, 1), 2);
  // Strokes of two lanes fill their cells evenly.
  const most = hasLanes ? 2 : Math.min(LONGEST_IN_PAIR * wanted, 2);
  const stepAcross = stepInView(
    [onScreen[0] / Math.max(size * size, 1e-24), onScreen[1] / Math.max(size * size, 1e-24)],
    map,
  );
  return { coordinates, stepAcross, period, paired: (2 * (wanted - 1)) / (most + wanted - 2), longest: 0.5 * most };
}

/** The rank below which strokes are there if a given share of them is, and the range over which they grow: few strokes are whole too. */
function bornBelow(share: number): Pair {
  const few = share / (1 - 0.5 * GROWING);
  if (few * GROWING < GROWTH) return [few, Math.max(few * GROWING, 1e-6)];
  const most = share + 0.5 * GROWTH;
  return [most <= 1 ? most : 1 + GROWTH - Math.sqrt(Math.max(2 * GROWTH * (1 - share), 0)), GROWTH];
}

/** The number of a cell among those of a row that differ: the same on both sides of a seam. */
const numberOfCell = (cell: number, { hasSeams }: Cells, repeat: number): number =>
  hasSeams && repeat > 1 ? cell - repeat * Math.floor(cell / repeat) : cell;

/** The number of a row within its bundle, 0 for the middle one. */
function fromMiddle(row: number): number {
  const shifted = row + 0.5 * BUNDLED_ROWS;
  return shifted - BUNDLED_ROWS * Math.floor(shifted / BUNDLED_ROWS) - 0.5 * BUNDLED_ROWS;
}

/** How a tone is drawn: the share of the strokes that are there, and what is added to their half widths. */
function drawnTone({ tones }: StrokeProfiles, tone: number, young: number): { share: number; widening: number } {
  const [x, y] = [clamp01(tone) * (PLACES - 1), young * (TONE_ROWS - 1)];
  const [column, row] = [Math.min(Math.floor(x), PLACES - 2), Math.min(Math.floor(y), TONE_ROWS - 2)];
  const of = (member: 'share' | 'widening'): number =>
    mix(
      mix(tones[row][column][member], tones[row][column + 1][member], x - column),
      mix(tones[row + 1][column][member], tones[row + 1][column + 1][member], x - column),
      y - row,
    );
  return { share: of('share'), widening: of('widening') };
}

/**
 * The tone that rows have whose strokes fill a share of their cells, where those that fill less have a given tone. A row darkens by as much as
 * it fills less, and where rows overlap each lets through what the others leave.
 *
 * @param ofCells the share that strokes of the first fill
 * @param filled the part of it that those of the second fill
 */
function filledTone(tone: number, ofCells: number, filled: number): number {
  const left = ofCells * filled;
  return tone < left ? tone / filled : 1 - (1 - tone) ** (Math.log2(1 - ofCells) / Math.log2(1 - left));
}

/** What the rows of a family depend on at a place, beside their tone and distance. */
export interface HandRows {
  profiles: StrokeProfiles;
  cells: Cells;
  /** The value of the family's function. */
  value: number;
  /** The step of values across seams; Infinity without seams. */
  repeat: number;
  /** 0 where strokes of the light swatch begin, 1 for families that cross in the darks. */
  isDark: 0 | 1;
}

/** A family where shadows fall. */
export interface RowsInShadow {
  /** Its tone in the shadows of all lights that cast one. */
  tone: number;
  /** The share of their light that is taken at a step from the place, view space. */
  takenAt(step: Vec3): number;
}

/** How a family draws a tone. */
interface Drawn {
  /** The rank below which strokes of old and of young rows are there, and the range of ranks over which they grow. */
  bornOld: Pair;
  bornYoung: Pair;
  widening: number;
}

/** The rows of a family at a place. */
export interface Rows extends HandRows, Drawn {
  /** The distance of old rows: a power of two, in units of the function; and in mean distances. */
  period: number;
  apart: number;
  /** The mean distance of rows, pixels. */
  spacing: number;
  /** In the shadows of all lights; null where they are part of the tone. */
  inShadow: (Drawn & Pick<RowsInShadow, 'takenAt'>) | null;
}

/**
 * The rows of a family.
 *
 * @param octave of their mean distance
 * @param tone without the shadows of `inShadow`
 * @param perPixel change of the family's function from one pixel to the next
 */
export function rowsFor(
  hand: HandRows,
  tone: number,
  octave: number,
  perPixel: number,
  inShadow: RowsInShadow | null = null,
): Rows {
  const { cells, profiles } = hand;
  const period = powerOf2(Math.ceil(octave));
  const apart = period / powerOf2(octave);
  const young = clamp01(apart - 1);
  // Strokes fill less of their cells where pairs have given way to one: as if the tone were darker.
  const filled = (1 - cells.paired * (1 - cells.longest)) * (1 - 0.5 * PAIR_TURN);
  const ofCells = COVERED_OF_FILLED * profiles.filled * (1 - 0.5 * profiles.shorter);
  const drawnAs = (one: number): Drawn => {
    const { share, widening } = drawnTone(profiles, filledTone(clamp01(one), ofCells, filled), young);
    return { bornOld: bornBelow(share), bornYoung: bornBelow(young * share), widening };
  };
  return {
    ...hand,
    ...drawnAs(tone),
    ...{ period, apart },
    spacing: powerOf2(octave) / perPixel,
    inShadow: inShadow && { ...drawnAs(inShadow.tone), takenAt: inShadow.takenAt },
  };
}

/** The two lanes of a row whose strokes run beside each other; the first is that of other rows. */
type Lane = 0 | 1;

const ONE_LANE: readonly Lane[] = [0];
const TWO_LANES: readonly Lane[] = [0, 1];

/** A stroke of a row where a pixel sees it. */
export interface RowStroke {
  /** Its coordinate along the row, its lane, the length of its cell, and the number of the cell. */
  coordinate: number;
  lane: Lane;
  length: number;
  cell: number;
  /** The place along it, from 0 to 1. */
  t: number;
  /** Offset of its middle from the row towards higher values, and half of its width, pixels. */
  shift: number;
  half: number;
}

/** Whether two strokes of a row have the same cell. */
export const isSameCell = (a: RowStroke, b: RowStroke): boolean =>
  a.cell === b.cell && a.length === b.length && a.coordinate === b.coordinate && a.lane === b.lane;

/** Whether two places lie on the same stroke. Cells of a short repeat have the same number in turn, so the place along it counts too. */
export const isSameStroke = (a: RowStroke, b: RowStroke): boolean => isSameCell(a, b) && Math.abs(a.t - b.t) < 0.5;

/** A row as a pixel sees it. */
interface Row {
  /** Among the old rows; young ones lie half way between two. */
  number: number;
  /** −1 where rows are numbered, and run, the other way. */
  way: 1 | -1;
  hash: number;
  turn: number;
  bits: number;
  born: Pair;
  bornInShadow: Pair;
  /** The step to its nearest point, view space. */
  middle: Vec3;
}

/**
 * The strokes of a row nearest to a place, at most one for each coordinate and lane.
 *
 * @param line the value of the row
 * @param beyond how far before the start and after the end of a stroke it still counts, as a share of its length; it has no width there
 */
export function strokesOnRow(rows: Rows, line: number, beyond = 0): RowStroke[] {
  const { cells, period, value } = rows;
  const place = line / period;
  const isYoung = place !== Math.floor(place);
  if (isYoung && place - Math.floor(place) !== 0.5) return [];
  const born = isYoung ? rows.bornYoung : rows.bornOld;
  const { inShadow } = rows;
  const bornInShadow = inShadow ? (isYoung ? inShadow.bornYoung : inShadow.bornOld) : born;
  if (isYoung && !(born[0] > 0 || bornInShadow[0] > 0)) return [];
  const signed = numberOf(line, rows.repeat);
  const way = cells.hasSeams && signed < 0 ? -1 : 1;
  const number = signed === 0 ? 0 : way * signed;
  const row: Row = {
    ...{ number: number / period, way, born, bornInShadow },
    middle: combined(line - value, cells.stepAcross, 0, cells.stepAcross),
    hash: hash01(number),
    turn: turnOf(number),
    bits: bitsOfLine(number),
  };
  const strokes: RowStroke[] = [];
  for (const coordinate of cells.coordinates) {
    // The place of the nearest point of the row: strokes end straight across their rows.
    const nearest = coordinate.place - coordinate.askew * (value - line);
    for (const lane of rows.profiles.laneOffset > 0 ? TWO_LANES : ONE_LANE) {
      const stroke = strokeOn(rows, row, { ...coordinate, place: nearest }, lane, beyond);
      if (stroke) strokes.push(stroke);
    }
  }
  return strokes;
}

const grownAt = ([below, range]: Pair, rank: number): number => clamp01((below - rank) / range);

/** The stroke of a lane of a row at one of the coordinates along it; undefined for none. */
function strokeOn(
  rows: Rows,
  row: Row,
  { id, place, share, perPixel, step }: RowCoordinate,
  lane: Lane,
  beyond: number,
): RowStroke | undefined {
  const { profiles, cells, apart, spacing, isDark } = rows;
  const { count, filled, shorter, bundled, laneOffset, laneShift } = profiles;
  const ofLane = lane * THIRD_FACTOR;
  // Rows are shifted by chance: any rule would show where their strokes end.
  const x = (row.way * place + strokeHash01(row.bits, 0) * cells.repeat) / cells.period - lane * laneShift;
  const most = cells.repeat / cells.period;
  const pair = Math.floor(0.5 * x);
  // Each pair of strokes gives way to one twice as long at a moment of its own.
  const moment = strokeHash01(row.bits ^ SECOND_FACTOR, numberOfCell(pair, cells, 0.5 * most));
  const turned = (cells.paired * (1 + PAIR_TURN) - moment) / PAIR_TURN;
  const isPair = turned > 0.5;
  const cell = isPair ? pair : Math.floor(x);
  const inCell = isPair ? 0.5 * x - pair : x - cell;
  const repeat = isPair ? 0.5 * most : most;
  const number = numberOfCell(cell, cells, repeat);
  const chance = strokeHash01(row.bits ^ ofLane, number);
  // Ranks are spread evenly over a surface: the first strokes lie on one of three neighbouring rows.
  const rank = fract(row.turn + strokeHash01((row.hash * 2 ** 32) ^ ofLane, number) / 3);
  const greatest = Math.min(
    clamp01(isPair ? 2 * turned - 1 : 1 - 2 * turned),
    ((1 + AXIS_TURN) * share - fract(AXIS_HASH * chance)) / AXIS_TURN,
  );
  if (!(greatest > 0)) return undefined;
  const size = filled * (1 - shorter * fract(SIZE_HASH * chance)) * (isPair ? cells.longest : 1);
  const length = (isPair ? 2 : 1) * cells.period;
  const begin = mix(fract(START_HASH * chance), 0.5, laneOffset > 0 ? LANE_STEADINESS : 0);
  const inFull = (inCell - (1 - size) * begin) / size;
  if (!(inFull > -beyond && inFull < 1 + beyond)) return undefined;
  const { grown, left, widening } = grownPart(rows, row, rank, inFull, (at) =>
    combined(1, row.middle, row.way * size * length * (at - inFull), step),
  );
  const there = Math.min(greatest, grown);
  if (!(there > 0)) return undefined;
  // A stroke that is not there in full is shorter, and ends as the hand ends it.
  const t = 0.5 + (inFull - 0.5) / (there * left);
  if (!(t > -beyond && t < 1 + beyond)) return undefined;
  const chosen = mix(0.5 * isDark, 1, rank) * (1 - SHAPES_OF_RANK) + SHAPES_OF_RANK * fract(SHAPE_HASH * chance);
  const shape = Math.min(Math.floor(count * chosen), count - 1);
  let aside = lane === 0 ? -laneOffset : laneOffset;
  if (bundled > 0) {
    // Strokes side by side are of one bundle, and others farther along: no gap runs all along the rows.
    const along = Math.floor((cell + 0.5 - strokeHash01(row.bits, 0) * repeat) / BUNDLE_CELLS);
    const lot = Math.floor(
      BUNDLED_ROWS * strokeHash01(SECOND_FACTOR, numberOfCell(along, cells, repeat / BUNDLE_CELLS)),
    );
    aside += bundledAside(row.number, apart, bundled, lot);
  }
  const [offset, width] = profileAt(profiles.strokes, shape, clamp01(t));
  const fromEnd = Math.max(Math.min(t, 1 - t), 0);
  const halfWidth = (width + widening * Math.min(1, WIDENED_ENDS * fromEnd)) * Math.min(1, there / WIDE_FROM) * spacing;
  // Blunt ends are round, as the tip of a pen leaves them.
  const cap = Math.max(1 - (fromEnd * there * left * size * length) / perPixel / Math.max(halfWidth, 0.5), 0);
  return {
    ...{ coordinate: id, lane, length, cell: number, t },
    shift: row.way * (aside + offset) * spacing,
    half: halfWidth * Math.sqrt(Math.max(1 - cap * cap, 0)),
  };
}

/**
 * How far a stroke has grown, the part of the half at a place that shadows leave, and its widening. It is there as far as its middle is; an
 * end that is not there loses a sixth of the stroke.
 *
 * @param inFull the place along the stroke in full, from 0 to 1
 * @param stepTo the step to another such place, view space
 */
function grownPart(
  { widening, inShadow }: Rows,
  { born, bornInShadow }: Row,
  rank: number,
  inFull: number,
  stepTo: (at: number) => Vec3,
): { grown: number; left: number; widening: number } {
  const lit = grownAt(born, rank);
  const shaded = grownAt(bornInShadow, rank);
  if (!inShadow || (lit === shaded && widening === inShadow.widening)) return { grown: lit, left: 1, widening };
  const middle = inShadow.takenAt(stepTo(1 / 2));
  const grown = mix(lit, shaded, middle);
  if (!(grown > 0)) return { grown: 0, left: 1, widening };
  const end = inShadow.takenAt(stepTo(inFull < 0.5 ? 1 / 6 : 5 / 6));
  const gone = Math.max(1 - mix(lit, shaded, end) / grown, 0);
  return { grown, left: 1 - gone / 3, widening: mix(widening, inShadow.widening, middle) };
}

/** How far a stroke lies aside of its row, in mean distances. lot: of the bundles of its row, from 0 to BUNDLED_ROWS − 1. */
function bundledAside(number: number, apart: number, bundled: number, lot: number): number {
  const ofAll = 0.5 * fromMiddle(2 * number + lot);
  const drawn = fract(number) === 0 ? mix(fromMiddle(number + lot), ofAll, apart - 1) : ofAll;
  return -bundled * apart * drawn;
}

/** Offset and half width of a stroke of the hand at a place along it, in mean distances between rows. */
function profileAt(strokes: Float32Array, shape: number, t: number): Pair {
  const place = t * (PLACES - 1);
  const first = Math.min(Math.floor(place), PLACES - 2);
  const at = 2 * (shape * PLACES + first);
  const part = place - first;
  return [mix(strokes[at], strokes[at + 2], part), mix(strokes[at + 1], strokes[at + 3], part)];
}
