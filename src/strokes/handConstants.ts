/** Layout of the texture that holds the strokes of a hand, for the processor and, as defines, for the shaders. */
export const HAND_TEXTURE = {
  /** Places along a stroke, one texel each. */
  PLACES: 64,
  /** Rows of the texture: one for each stroke, and the last ones for tones. */
  HAND_ROWS: 128,
  /** The last rows say how a tone is drawn where no young row, a third, two thirds and all of the young rows are there. */
  TONE_ROWS: 4,
} as const;

/** Constants of the strokes of a hand in rows, for the processor and, as defines, for the shaders. */
export const HAND_STROKE_CONSTANTS = {
  /** Strokes of a pair of cells give way to one twice as long while the share of such pairs grows by this. */
  PAIR_TURN: 0.06,
  /** Longest stroke in a pair of cells, as a share of the wanted length of a cell. */
  LONGEST_IN_PAIR: 1.25,
  /** Mean change of a coordinate of space along a row that counts its strokes along it. */
  AXIS_RISE: 0.85,
  /** Places, in tiles, within which rows are shifted along each other where no seam limits them. */
  ROW_SHIFT: 64,
  /** Strokes grow over this range of ranks, but not over more than this part of those that are there. */
  GROWTH: 0.08,
  GROWING: 0.22,
  /** A stroke is as wide as drawn from this part of its growth on, in which it only becomes longer. */
  WIDE_FROM: 0.3,
  /** Strokes that are wider in the darks are so in full at a distance from both ends, the reciprocal of this share of their length. */
  WIDENED_ENDS: 8,
  /** First bits, as powers of two, of the hash of a stroke that decide on its length, its place in its cell, and its shape. */
  SIZE_HASH: 8,
  START_HASH: 128,
  SHAPE_HASH: 2048,
  /** Rows that are drawn together to a bundle, around the middle one, and the number of cells of strokes after which others are. */
  BUNDLED_ROWS: 3,
  BUNDLE_CELLS: 4,
  /** A dark row covers this part of the share of its cells that strokes fill: their ends are narrow. */
  COVERED_OF_FILLED: 0.88,
  /** How much of the room that strokes of two lanes leave in their cells lies evenly before and after them. */
  LANE_STEADINESS: 0.75,
  /** The share of all shapes that a rank chooses from: light tones from those of the light swatch. */
  SHAPES_OF_RANK: 0.34,
} as const;

/** The largest number of rows that a pixel may lie on: those within the greatest reach of a stroke to both sides, old and young. */
export const MOST_ROWS = 15;

/** The greatest distance from the middle of a row to an edge of one of its strokes, in distances between rows. */
export const MOST_REACH = 3.5;
