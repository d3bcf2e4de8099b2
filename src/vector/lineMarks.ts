import { smoothstep } from '../look/vectors.js';
import { cutFor, cutWidth } from './shading/carving.js';
import { lineLeft } from './shading/groundShadow.js';
import { handWidth } from './shading/hand.js';
import { type HandRows, type RowStroke, type RowsInShadow, rowsFor, strokesOnRow } from './shading/handStrokes.js';
import { penMargin } from './shading/penLines.js';
import { drawnShare, type Pen, penFor, strokeAt } from './shading/penStrokes.js';
import { powerOf2, roomOf } from './shading/ruledLines.js';
import type { Along } from './shading/strokeLengths.js';

/** How lines are drawn: as ink in one go, in strokes of a pen, or white with a gouge. */
export type LineTechnique = 'engraving' | 'pen' | 'woodcut';

/** The properties of a family at a place that its lines depend on. */
export interface FamilyMeasure {
  /** The tone that the family prints. */
  tone: number;
  /** The octave of the spacing of lines. */
  octave: number;
  coarsest: number;
  /** Units of the function per pixel on the flat triangle, on which lines lie. */
  perPixel: number;
  /** Variation of widths by the hand, from 0 to 1. */
  widths: number;
  /** The share of the shadow on a ground that has not dissolved; 1 where lines do not dissolve. */
  left: number;
  /** Whether a pen's lines may move aside to be evenly spaced. */
  isEven: boolean;
  /** Null for media without strokes. */
  strokes: StrokePlace | null;
  /** Null where no hand draws. */
  hand: HandPlace | null;
}

/** A place on the rows of a hand. */
export interface HandPlace extends HandRows {
  /** The unit direction on the picture in which the function rises. */
  uphill: readonly [number, number];
}

/** A place along the strokes of a family. */
export interface StrokePlace {
  technique: Exclude<LineTechnique, 'engraving'>;
  along: Along;
  irregularity: number;
  /** The octave of the spacing of a woodcut's cuts, which is wider where white or black is rare. */
  cutOctave: number;
  /** The step of values across seams. */
  repeat: number;
  /** The value of the function. */
  value: number;
  /** The unit direction on the picture in which the function rises. */
  uphill: readonly [number, number];
}

/** A line of a family. */
export interface Line {
  value: number;
  /** The power of two in its value, as an exponent. */
  rank: number;
}

/** The appearance of a line at a place. */
export interface LineMark {
  /** Half the width, pixels. */
  half: number;
  /** Above 0 where there is a line. */
  margin: number;
  /** Offset of its middle towards higher values, pixels. */
  shift: number;
}

/** Tones below the first are not drawn by a pen, since its lines would stand alone; at tones above the second its lines get no closer. */
export const LEAST_PEN_TONE = 0.07;
const MOST_PEN_TONE = 0.95;

/** A black cell of a woodcut is drawn if it is at least this share of the width of the pen. */
const LEAST_BLACK = 0.4;

/**
 * The tone from which on lines of a print merge, and by how much they overlap: pixels, and a share of their room as far as the hand lays
 * them unevenly.
 */
const SOLID_FROM = 0.96;
const OVERLAPPING = 0.15;
const UNEVEN = 0.15;

const NOTHING: LineMark = { half: 0, margin: -1, shift: 0 };

/** A line of a print: its width is the tone. */
export function printedMark(measure: FamilyMeasure, line: Line): LineMark {
  const { tone, octave, perPixel, widths, left, strokes } = measure;
  if (strokes?.technique === 'pen') return printedStroke(measure, strokes, line);
  if (strokes) return blockBetweenCuts(measure, strokes, line, printedOctave(measure));
  const room = roomOf(line.rank, octave) / perPixel;
  // A line wider than its room would cover no more.
  const half = 0.5 * room * Math.min(tone * handWidth(line.value, widths) * lineLeft(line.value, left), 1);
  // Lines of different widths would leave slits where everything is covered.
  const solid = tone > SOLID_FROM && room > 0 ? smoothstep(SOLID_FROM, 1, tone) : 0;
  const closed = half + solid * (0.5 * room * (1 + UNEVEN * widths) + OVERLAPPING - half);
  return { half: closed, margin: closed, shift: 0 };
}

/** A line as a pen of one width draws it. pen: its width, pixels. */
export function plottedMark(measure: FamilyMeasure, line: Line, pen: number): LineMark {
  const { strokes, perPixel, isEven, tone } = measure;
  const half = pen / 2;
  if (strokes?.technique === 'woodcut') {
    const black = blockBetweenCuts(measure, strokes, line, plottedOctave(measure, pen));
    return { half, margin: Math.min(black.margin, black.half - LEAST_BLACK * half), shift: black.shift };
  }
  if (tone <= LEAST_PEN_TONE) return { half, margin: tone - LEAST_PEN_TONE, shift: 0 };
  const spacing = penSpacing(measure, pen);
  const margin = penMargin(line.value, line.rank, spacing, isEven);
  if (!strokes) return { half, margin, shift: 0 };
  const stroke = strokeAt(penOf(measure, strokes), 1, sameLine(strokes, line));
  return { half, margin: Math.min(margin, stroke.presence - 0.5), shift: (spacing / perPixel) * stroke.astray };
}

/** The octave of the finest lines that a print may need at a place. */
export const printedOctave = ({ octave, strokes }: FamilyMeasure): number =>
  // Cells of the block are no wider than half the spacing of cuts, so that narrow ends are not ragged where a surface ends.
  strokes?.technique === 'woodcut' ? octave - 1 : octave;

/** The octave of the finest lines that a pen may need at a place. */
export function plottedOctave(measure: FamilyMeasure, pen: number): number {
  // A pen draws the same strokes of a hand as a print.
  if (measure.hand) return printedOctave(measure);
  const { perPixel, strokes, octave } = measure;
  // Cells of the block are no wider than the pen, so that it fills them.
  if (strokes?.technique === 'woodcut') return Math.min(Math.log2(pen * perPixel), octave);
  // Half an octave of margin, for tones between the corners of a triangle.
  return Math.log2(penSpacing(measure, pen)) - 0.5;
}

/** The rank of the finest lines that are traced at an octave: the cells of a block lie between old lines and new ones. */
export const finestRank = (octave: number, technique: LineTechnique): number =>
  Math.ceil(octave) - (technique === 'woodcut' ? 2 : 1);

/** The spacing of a pen's lines, in units of the function. pen: its width, pixels. */
const penSpacing = (measure: FamilyMeasure, pen: number): number => penDistance(measure, pen) * measure.perPixel;

/** The spacing of a pen's lines on the picture, pixels. */
export const penDistance = (measure: FamilyMeasure, pen: number): number => pen / penTone(measure);

/** The tone of lines where a pen draws them, so that all it draws has the right tone in the mean. */
function penTone(measure: FamilyMeasure): number {
  const { strokes, tone } = measure;
  const drawn = strokes ? drawnShare(penOf(measure, strokes)) : 1;
  return Math.min(Math.max(tone, LEAST_PEN_TONE) / drawn, MOST_PEN_TONE);
}

/** The share of the length of placed lines that their strokes cover; 1 for lines in one go. */
export const drawnShareOf = (measure: FamilyMeasure): number =>
  measure.strokes ? drawnShare(unrepeatedPen(measure, measure.strokes)) : 1;

/** The stroke of a placed line at a place: its presence from 0 to 1, and its offset in distances between lines along the way uphill on the picture. */
export function strokeOnLine(
  measure: FamilyMeasure,
  line: number,
): { presence: number; astray: number; uphill: readonly [number, number] } {
  const { strokes } = measure;
  if (!strokes) return { presence: 1, astray: 0, uphill: [0, 0] };
  return { ...strokeAt(unrepeatedPen(measure, strokes), 1, line), uphill: strokes.uphill };
}

/** How far a place lies within the black of a woodcut, pixels; below 0 within a cut. */
export function blackAround({ tone, perPixel, strokes }: FamilyMeasure): number {
  if (!strokes || tone <= 0) return -1;
  return Math.min(...besideCuts(strokes, tone, strokes.value)) / perPixel;
}

/** Numbers of placed lines do not repeat across seams. */
const unrepeatedPen = (measure: FamilyMeasure, strokes: StrokePlace): Pen =>
  penOf(measure, { ...strokes, repeat: Infinity });

const penOf = ({ tone, octave }: FamilyMeasure, { along, irregularity, repeat }: StrokePlace): Pen =>
  penFor(tone, along, irregularity, repeat, octave);

/**
 * The strokes of a hand on a row, as a place sees them.
 *
 * @param row its value there
 * @param inShadow null where shadows are part of the tone
 * @param beyond as in `strokesOnRow`
 */
export function handStrokes(
  { tone, octave, perPixel, hand }: FamilyMeasure,
  row: number,
  inShadow: RowsInShadow | null,
  beyond = 0,
): RowStroke[] {
  if (!hand || !(Math.max(tone, inShadow?.tone ?? 0) > 0)) return [];
  return strokesOnRow(rowsFor(hand, tone, octave, perPixel, inShadow), row, beyond);
}

/** The value of a line at a place: across seams of the form it differs from that where the line begins. */
export function sameLine({ value, repeat }: { value: number; repeat: number }, line: Line): number {
  if (repeat === Infinity) return line.value;
  // An odd multiple of its power of two, except for the line through 0.
  const unit = 2 ** (line.rank + 1);
  return line.value === 0 ? 0 : unit * (Math.round(value / unit - 0.5) + 0.5);
}

function printedStroke(measure: FamilyMeasure, strokes: StrokePlace, line: Line): LineMark {
  const { octave, perPixel } = measure;
  const spacing = powerOf2(octave);
  const share = roomOf(line.rank, octave) / spacing;
  if (share <= 0) return NOTHING;
  const stroke = strokeAt(penOf(measure, strokes), share, sameLine(strokes, line));
  const half = (0.5 * spacing * stroke.width) / perPixel;
  return { half, margin: half, shift: (spacing * stroke.astray) / perPixel };
}

/** Overlap of cells of the block with cells twice as wide where they alternate, as a share of an octave. */
const OVERLAP = 0.02;
/** Overlap of neighbouring cells of the block, so that no slits are left between them, pixels. */
const CLOSED_BY = 0.2;

/**
 * The black that is left between cuts, in the cell of the block around a line. Lines lie in the middle of cells, and cuts where cells meet:
 * cells so narrow that they follow the surface draw black of any width without a gap.
 *
 * @param wanted the octave of twice the width of cells
 */
function blockBetweenCuts(
  { tone, perPixel }: FamilyMeasure,
  strokes: StrokePlace,
  line: Line,
  wanted: number,
): LineMark {
  const band = Math.min(wanted - (line.rank + 1), line.rank + 2 - wanted) + OVERLAP;
  if (band <= 0 || tone <= 0) return NOTHING;
  const room = 2 ** line.rank;
  const [down, up] = besideCuts(strokes, tone, sameLine(strokes, line)).map(
    (left) => Math.min(left, room) / perPixel + (left >= room ? CLOSED_BY : 0),
  );
  const black = 0.5 * (down + up);
  return { half: black, margin: Math.min(black, band), shift: 0.5 * (up - down) };
}

/** How far a value lies from the edges of the cuts below and above it, in units of the function; below 0 within a cut. */
function besideCuts({ along, repeat, cutOctave }: StrokePlace, tone: number, value: number): [number, number] {
  const cut = cutFor(tone, along, repeat, cutOctave);
  // Old cuts are multiples of a period, and new ones between them of its half.
  const half = 2 ** (Math.ceil(cutOctave) - 1);
  const oldRoom = 0.5 * powerOf2(cutOctave);
  const below = half * Math.floor(value / half);
  const isOldBelow = Math.round(below / half) % 2 === 0;
  const leftOf = (at: number, isOld: boolean): number =>
    Math.abs(value - at) - (isOld ? oldRoom : half - oldRoom) * cutWidth(cut, at);
  return [leftOf(below, isOldBelow), leftOf(below + half, !isOldBelow)];
}
