/**
 * One drawn mark. Its place, length and bends are measured in tiles, so they are the same at every level; its width is
 * measured in texels, so it is the same on every level too (the paper's third constraint of section 3.1, read as
 * Praun et al. 2001 do: what is constant in texels is the width, not the length).
 *
 * Seen along the stroke, x from −1 at its start to 1 at its end, the centre line is displaced sideways by
 * slope·length/2·x + bow·(1 − x²) + wave·x·(1 − x²).
 */
export interface Stroke {
  /** Centre along the texture's u axis, in tiles. */
  u: number;
  /** Centre along the texture's v axis, in tiles. */
  v: number;
  /** The layer of its style that it belongs to: strokes of one layer keep apart, those of others they cross. */
  layer: number;
  /** False: the stroke runs along u. True: along v. */
  across: boolean;
  /** From end to end, in tiles; 0 draws a dot. */
  length: number;
  /** Sideways per forward: the tangent of the angle to the axis. */
  slope: number;
  /** Height of the arc, in tiles. */
  bow: number;
  /** Size of the S-bend, in tiles. */
  wave: number;
  /** In the middle, in texels. */
  width: number;
  /** Each end narrows over this many texels, but over a quarter of the length at most; 0 leaves it blunt. */
  taper: number;
  /** How far it fills the grain of a paper that has grain: from 0, only its peaks, to 1, all of it. */
  pressure: number;
  /** The first tone that shows the stroke; every darker one does too. */
  tone: number;
  /** The coarsest level that shows the stroke; every finer one does too. */
  level: number;
}

/** Sideways displacement of the centre line in tiles at x ∈ [−1, 1]. */
export const strokeOffset = (stroke: Stroke, x: number): number =>
  0.5 * stroke.length * stroke.slope * x + (1 - x * x) * (stroke.bow + stroke.wave * x);
