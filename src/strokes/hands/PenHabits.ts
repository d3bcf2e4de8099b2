import type { SwatchTone } from 'three-hatching';

/** How somebody draws, in numbers. Lengths are in millimetres, angles in degrees, clockwise on the sheet. */
export interface PenHabits {
  /** Mean length of a stroke, and its deviation as a share of it. */
  length: number;
  lengthSpread: number;
  /** Width of a stroke where it is widest. */
  width: number;
  /** The deviation of the width between strokes and, slowly, along each, as a share of it. */
  pressure: number;
  /** The shares of the length over which a stroke grows from its start and narrows to its end. */
  taperStart: number;
  taperEnd: number;
  /** The width of the two tips as a share of the stroke's. */
  tips: readonly [start: number, end: number];
  /** Height of the arc over the chord, as a share of it, and its deviation. */
  curvature: number;
  curvatureSpread: number;
  /** How far the line strays from its arc, and the length after which it strays the other way. */
  wobble: number;
  wobbleLength: number;
  /** The direction of the first layer, and the deviation of strokes from their layer's direction. */
  angle: number;
  angleSpread: number;
  /** The distance of neighbours in each swatch. */
  spacing: Readonly<Record<SwatchTone, number>>;
  /** The deviation of that distance, as a share of it. */
  spacingSpread: number;
  /** Strokes are drawn in bundles of this many, with a gap of so many distances between bundles; 1 stroke is no bundle. */
  bundle: number;
  bundleGap: number;
  /** How far the ends of neighbours stray along the layer, as a share of the length. */
  raggedness: number;
  /** The share of the length that runs beside the next stroke of the row; negative leaves gaps. */
  overlap: number;
  /** The second layer, and the lightest swatch that has it. */
  crossing?: { angle: number; from: SwatchTone } | undefined;
  /** Whether strokes go to and fro without lifting the pen. */
  isZigzag: boolean;
}
