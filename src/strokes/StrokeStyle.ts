/** How a style draws. Lengths are in tiles, widths in texels of every level, as in `Stroke`. */
export interface StrokeStyle {
  /** Range of stroke lengths; [0, 0] draws dots. */
  length: readonly [shortest: number, longest: number];
  /** Width in the middle of the stroke. */
  width: number;
  /**
   * Widths for which levels nest. A thinner stroke (with `widthSpread`) may fall between texels so that it half covers none
   * of them; a wider one reaches texels of a coarse level that it does not reach on the finer one.
   */
  widthRange: readonly [narrowest: number, widest: number];
  /** Largest relative deviation of a stroke's width from `width`. */
  widthSpread: number;
  /** Texels over which each end narrows. */
  taper: number;
  /** Largest angle of a stroke to the direction of its layer, as a tangent. */
  slope: number;
  /** Largest height of a stroke's arc. */
  bow: number;
  /** Largest S-bend of a stroke. */
  wave: number;
  /** Mean ink of the darkest image. */
  maxInk: number;
  /** The directions of strokes, in the order in which they set in. Layers that are drawn have equal ink. */
  layers: readonly StrokeLayer[];
  /** Random proposals per stroke, of which the best is drawn. 1 draws at random. */
  proposals: number;
  /** What differs when thresholds are drawn. */
  thresholds: ThresholdStyle;
  /** The grain of the paper, if it shows. */
  grain?: Grain;
}

/** One direction of strokes, which cross those of other layers. */
export interface StrokeLayer {
  /** Whether the strokes run along v instead of u. */
  across: boolean;
  /** Their angle to that axis, as a tangent. */
  slope: number;
  /** Mean ink at which the layer sets in. */
  from: number;
  /** The same for thresholds, counted as in `ThresholdStyle`. */
  thresholdsFrom: number;
}

/**
 * How a style draws thresholds. There, strokes swell as tone rises, so their final ink is not known while they are placed.
 * All inks here count strokes as the hatch images draw them.
 */
export interface ThresholdStyle {
  /** Strokes are added up to this ink. Beyond it they only swell, so that even gaps remain between them and close. */
  maxInk: number;
  /** Mean ink added to the image while a stroke swells from a hairline to its width. */
  swell: number;
  proposals: number;
}

/** How the grain of rough paper breaks up strokes. */
export interface Grain {
  /** Texels by which the noise of the paper is blurred: grains are about twice as wide. */
  radius: number;
  /** Texels over which a stroke fades at its edge. */
  edge: number;
  /** How sharply the depth of the grain separates ink from paper: 1 gives greys, 10 gives specks. */
  contrast: number;
  /** Range of stroke pressure: the share of the paper that a stroke blackens along its middle. */
  pressure: readonly [least: number, most: number];
  /** For thresholds: how much more ink the deepest places of the grain need than its peaks. */
  roughness: number;
}
