/** The styles that the generator can draw. */
export type StrokeStyleName = 'hatching' | 'crossHatching' | 'stippling';

/** How a style draws. Lengths are in tiles, widths in texels of every level, as in `Stroke`. */
export interface StrokeStyle {
  /** Lines are drawn between these lengths; [0, 0] draws dots. */
  length: readonly [shortest: number, longest: number];
  /** In the middle of the stroke. */
  width: number;
  /**
   * Between these widths the level nesting can be kept. A thinner stroke (with `widthSpread`) may fall between texels so
   * that none is half covered; a wider one reaches texels of a coarse level that it does not on the finer one.
   */
  widthRange: readonly [narrowest: number, widest: number];
  /** Each stroke's width differs from `width` by at most this part of it. */
  widthSpread: number;
  /** Texels over which each end narrows. */
  taper: number;
  /** Each stroke's angle to its axis is at most this, as a tangent. */
  slope: number;
  /** Greatest arc of a stroke. */
  bow: number;
  /** Greatest S-bend of a stroke. */
  wave: number;
  /** Mean ink of the darkest image. */
  maxInk: number;
  /** Mean ink from which the second, perpendicular layer is drawn; undefined: never. */
  crossFrom: number | undefined;
  /** For each stroke, the best of so many proposals is drawn. 1 draws at random. */
  proposals: number;
  /** What is different in a threshold map. */
  thresholds: ThresholdStyle;
}

/**
 * How a style draws thresholds, where the ink of strokes is not given but follows from what their swelling adds. Inks are
 * therefore those of the strokes as images draw them.
 */
export interface ThresholdStyle {
  /** Strokes are added up to this ink. From there on they only swell, so that even gaps remain between them and close. */
  maxInk: number;
  /** Ink from which on the second layer is drawn: the tone is then about a half. */
  crossFrom: number | undefined;
  /** Ink that is added while a stroke swells from a hairline to its width. */
  swell: number;
  proposals: number;
}

const hatching: StrokeStyle = {
  length: [0.28, 0.6],
  width: 1.9,
  widthRange: [1.2, 2.6],
  widthSpread: 0.12,
  taper: 22,
  slope: 0.016,
  bow: 0.0025,
  wave: 0.003,
  maxInk: 0.95,
  crossFrom: undefined,
  proposals: 400,
  thresholds: { maxInk: 0.54, crossFrom: undefined, swell: 0.15, proposals: 400 },
};

export const strokeStyles: Record<StrokeStyleName, StrokeStyle> = {
  hatching,
  crossHatching: {
    ...hatching,
    crossFrom: 0.45,
    thresholds: { maxInk: 0.6, crossFrom: 0.32, swell: 0.15, proposals: 400 },
  },
  stippling: {
    length: [0, 0],
    width: 2.4,
    widthRange: [1.65, 2.5],
    widthSpread: 0.12,
    taper: 0,
    slope: 0,
    bow: 0,
    wave: 0,
    maxInk: 0.85,
    crossFrom: undefined,
    proposals: 24,
    thresholds: { maxInk: 0.5, crossFrom: undefined, swell: 0.05, proposals: 48 },
  },
};
