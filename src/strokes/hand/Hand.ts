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
