/**
 * A stroke. Its position, length and bends are measured in tiles and its width in texels; all are the same on every level. (This
 * is the third constraint in section 3.1 of Suarez et al., in the reading of Praun et al. 2001: the width is constant in texels,
 * not the length.)
 *
 * Seen along the stroke, x from −1 at its start to 1 at its end, the centre line is displaced sideways by
 * slope·length/2·x + bow·(1 − x²) + wave·x·(1 − x²).
 */
export interface Stroke {
  /** Centre along the texture's u axis, in tiles. */
  u: number;
  /** Centre along the texture's v axis, in tiles. */
  v: number;
  /** The layer of the style. Strokes of the same layer keep apart, strokes of different layers cross. */
  layer: number;
  /** Whether the stroke runs along v instead of u. */
  across: boolean;
  /** The length from end to end, in tiles; 0 is a dot. */
  length: number;
  /** The tangent of the angle to the axis. */
  slope: number;
  /** Height of the arc, in tiles. */
  bow: number;
  /** Size of the S-bend, in tiles. */
  wave: number;
  /** The width in the middle, in texels. */
  width: number;
  /** Each end narrows over this many texels, at most a quarter of the length; 0 leaves it blunt. */
  taper: number;
  /** How deeply the stroke fills the grain of the paper, from 0 (only the peaks) to 1 (all of it). */
  pressure: number;
  /** The first tone that shows the stroke; every darker one does too. */
  tone: number;
  /** The coarsest level that shows the stroke; every finer one does too. */
  level: number;
}

/** Sideways displacement of the centre line in tiles at x ∈ [−1, 1]. */
export const strokeOffset = (stroke: Stroke, x: number): number =>
  0.5 * stroke.length * stroke.slope * x + (1 - x * x) * (stroke.bow + stroke.wave * x);
