import { smoothstep } from '../../look/vectors.js';
import { cutFor, cutWidth } from '../shading/carving.js';
import { lineLeft } from '../shading/groundShadow.js';
import { handWidth } from '../shading/hand.js';
import { penMargin } from '../shading/penLines.js';
import { drawnShare, type Pen, penFor, strokeAt } from '../shading/penStrokes.js';
import { powerOf2, roomOf } from '../shading/ruledLines.js';
import type { Along } from '../shading/strokeLengths.js';

/** What draws the lines: ink in one go, a pen in strokes, or a gouge that cuts them white. */
export type LineMedium = 'ink' | 'pen' | 'woodcut';

/** A family at a place, as far as its lines depend on it. */
export interface FamilyMeasure {
  /** What the family prints. */
  tone: number;
  /** Of the distance between lines. */
  octave: number;
  coarsest: number;
  /** Units of the function per pixel on the flat triangle, where the lines lie as they lie. */
  perPixel: number;
  /** What the hand makes of lines, from 0 to 1; 0 where each line is as wide as the others. */
  widths: number;
  /** The share of the shadow on a ground that has not dissolved; 1 where lines do not dissolve. */
  left: number;
  /** Whether a pen's lines may move aside, so that they are evenly apart. */
  isEven: boolean;
  /** Of media that draw in strokes. */
  strokes: StrokePlace | null;
}

/** A place along the strokes of a family. */
export interface StrokePlace {
  medium: Exclude<LineMedium, 'ink'>;
  along: Along;
  handmade: number;
  /** Of the distance between cuts of a woodcut, which lie farther apart than asked where white or black is rare. */
  cutOctave: number;
  /** By how much values change across seams. */
  repeat: number;
  /** Of the function. */
  value: number;
  /** The direction on the picture in which the function rises, unit. */
  uphill: readonly [number, number];
}

/** A line of a family. */
export interface Line {
  value: number;
  /** The power of two in it, as an exponent. */
  rank: number;
}

/** What a line is at a place. */
export interface LineMark {
  /** Half the width, pixels. */
  half: number;
  /** Above 0 where there is a line at all. */
  margin: number;
  /** How far its middle lies beside it, towards higher values, pixels. */
  shift: number;
}

/** A pen of one width draws no line below the first tone, which would stand alone, and lays them no closer than for the second. */
export const LEAST_PEN_TONE = 0.07;
const MOST_PEN_TONE = 0.95;

/** What is left of a cell of the block is drawn where it is at least this share of the width of the pen. */
const LEAST_BLACK = 0.4;

/**
 * Lines of a print grow together from the first tone on, and over one another: by so many pixels, and by a share of their room as far as a
 * hand lays them unevenly.
 */
const SOLID_FROM = 0.96;
const OVERLAPPING = 0.15;
const UNEVEN = 0.15;

const NOTHING: LineMark = { half: 0, margin: -1, shift: 0 };

/** A line as print has it: its width is the tone. */
export function printedMark(measure: FamilyMeasure, line: Line): LineMark {
  const { tone, octave, perPixel, widths, left, strokes } = measure;
  if (strokes?.medium === 'pen') return printedStroke(measure, strokes, line);
  if (strokes) return blockBetweenCuts(measure, strokes, line, printedOctave(measure));
  const room = roomOf(line.rank, octave) / perPixel;
  // Wider than all its room it would cover nothing more.
  const half = 0.5 * room * Math.min(tone * handWidth(line.value, widths) * lineLeft(line.value, left), 1);
  // Lines that differ in width would leave slits where all is covered.
  const solid = tone > SOLID_FROM && room > 0 ? smoothstep(SOLID_FROM, 1, tone) : 0;
  const closed = half + solid * (0.5 * room * (1 + UNEVEN * widths) + OVERLAPPING - half);
  return { half: closed, margin: closed, shift: 0 };
}

/** A line as a pen of one width draws it. pen: its width, pixels. */
export function plottedMark(measure: FamilyMeasure, line: Line, pen: number): LineMark {
  const { strokes, perPixel, isEven, tone } = measure;
  const half = pen / 2;
  if (strokes?.medium === 'woodcut') {
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

/** The octave of the finest lines that print may need at a place. */
export const printedOctave = ({ octave, strokes }: FamilyMeasure): number =>
  // Cells of the block are no wider than half of what lies between two cuts: narrow ends are not ragged where a surface ends.
  strokes?.medium === 'woodcut' ? octave - 1 : octave;

/** The octave of the finest lines that a pen may need at a place. */
export function plottedOctave(measure: FamilyMeasure, pen: number): number {
  const { perPixel, strokes, octave } = measure;
  // Cells of the block are no wider than the pen, so that it fills them.
  if (strokes?.medium === 'woodcut') return Math.min(Math.log2(pen * perPixel), octave);
  // Half an octave to spare, for tones between the corners of a triangle.
  return Math.log2(penSpacing(measure, pen)) - 0.5;
}

/** The rank of the finest lines that are traced at an octave: what is left of a block lies between lines and those that are born between them. */
export const finestRank = (octave: number, medium: LineMedium): number =>
  Math.ceil(octave) - (medium === 'woodcut' ? 2 : 1);

/** How far apart a pen draws lines, in units of the function. pen: its width, pixels. */
export const penSpacing = (measure: FamilyMeasure, pen: number): number => penDistance(measure, pen) * measure.perPixel;

/** The same on the picture, pixels. */
export const penDistance = (measure: FamilyMeasure, pen: number): number => pen / penTone(measure);

/** The tone that lines must have where a pen draws them, so that what it draws of them has the tone in the mean. */
function penTone(measure: FamilyMeasure): number {
  const { strokes, tone } = measure;
  const drawn = strokes ? drawnShare(penOf(measure, strokes)) : 1;
  return Math.min(Math.max(tone, LEAST_PEN_TONE) / drawn, MOST_PEN_TONE);
}

const penOf = ({ tone, octave }: FamilyMeasure, { along, handmade, repeat }: StrokePlace): Pen =>
  penFor(tone, along, handmade, repeat, octave);

/** The value that a line has at a place: across seams of the form another one than where it begins. */
function sameLine({ value, repeat }: StrokePlace, line: Line): number {
  if (repeat === Infinity) return line.value;
  // An odd multiple of its power of two, but for the line through 0.
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

/** Where cells of the block give way to others twice as wide, both reach into one another so far, as a share of an octave. */
const OVERLAP = 0.02;
/** Cells of the block reach into one another by so much, so that no slits are left between them, pixels. */
const CLOSED_BY = 0.2;

/**
 * What is left of the block between cuts, in the cell of the block around a line. Lines lie in the middle of cells, and cuts where cells
 * meet: in cells so narrow that they run along the surface with it, black of any width is drawn without a gap.
 *
 * @param wanted the octave of the distance between every other cell
 */
function blockBetweenCuts(
  { tone, perPixel }: FamilyMeasure,
  strokes: StrokePlace,
  line: Line,
  wanted: number,
): LineMark {
  const band = Math.min(wanted - (line.rank + 1), line.rank + 2 - wanted) + OVERLAP;
  if (band <= 0 || tone <= 0) return NOTHING;
  const { along, repeat, cutOctave } = strokes;
  const middle = sameLine(strokes, line);
  const room = 2 ** line.rank;
  const cut = cutFor(tone, along, repeat, cutOctave);
  // Old cuts are multiples of a period, and those that are born between them of its half.
  const half = 2 ** (Math.ceil(cutOctave) - 1);
  const oldRoom = 0.5 * powerOf2(cutOctave);
  const below = half * Math.floor(middle / half);
  const isOldBelow = Math.round(below / half) % 2 === 0;
  const leftOf = (at: number, isOld: boolean): number =>
    Math.abs(middle - at) - (isOld ? oldRoom : half - oldRoom) * cutWidth(cut, at);
  const [down, up] = [leftOf(below, isOldBelow), leftOf(below + half, !isOldBelow)].map(
    (left) => Math.min(left, room) / perPixel + (left >= room ? CLOSED_BY : 0),
  );
  const black = 0.5 * (down + up);
  return { half: black, margin: Math.min(black, band), shift: 0.5 * (up - down) };
}
