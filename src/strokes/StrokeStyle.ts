import type { StrokeProfile } from './Stroke.js';
import type { PlacingHabit } from './StrokeDensityField.js';

/** The parameters of a style of strokes. Lengths are in tiles, widths in texels of every level, as in `Stroke`. */
export interface StrokeStyle {
  /** Range of stroke lengths; [0, 0] draws dots. */
  length: readonly [shortest: number, longest: number];
  /** Width in the middle of the stroke. */
  width: number;
  /**
   * The widths for which levels nest. A thinner stroke (with `widthSpread`) may fall between texels and cover half of none; a wider one
   * reaches texels of a coarse level that it does not reach on the finer level.
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
  /** The directions of strokes, in the order in which they begin. The layers that have begun have equal ink. */
  layers: readonly StrokeLayer[];
  /** The number of random proposals per stroke, of which the best is drawn. With 1, strokes are placed at random. */
  proposals: number;
  /** The parameters that differ when thresholds are drawn. */
  thresholds: ThresholdStyle;
  /** The grain of the paper, if it shows. */
  grain?: Grain;
  /** The strokes of a hand, drawn in place of generic ones, with their own bends and widths. */
  hand?: HandShapes;
}

/** The strokes of a hand, as a map is drawn with them. */
export interface HandShapes {
  /** The chord, in tiles, and the shape of each. */
  shapes: readonly { length: number; profile: StrokeProfile }[];
  /** Standard deviation of their angles within a layer, in radians. */
  angleSpread: number;
  /** Largest relative change of the length of a copy. */
  scaleSpread: number;
  /** Whether the strokes are arcs instead of straight. */
  isCurved: boolean;
  /** Whether copies may be mirrored. */
  mirror: boolean;
  habit: PlacingHabit;
  /** The share of strokes placed beside the previous one, in a bundle. */
  bundled: number;
  /** The distance of the strokes of a bundle, in texels. */
  bundleSpacing: number;
}

/** The strokes of one direction, which cross those of other layers. */
export interface StrokeLayer {
  /** Whether the strokes run along v instead of u. */
  across: boolean;
  /** Their angle to that axis, as a tangent. */
  slope: number;
  /** The mean ink at which the layer begins. */
  from: number;
  /** The ink at which the layer begins in thresholds, measured as in `ThresholdStyle`. */
  thresholdsFrom: number;
}

/**
 * The parameters for drawing thresholds. In thresholds strokes swell as the tone rises, so their final ink is unknown while they are
 * placed. Therefore all inks here are those of the strokes in hatch images.
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
  /** For thresholds: texels by which that noise is blurred along the strokes, so that grains are streaks of them. */
  streak: number;
  /** For thresholds: how much more ink the deepest places of the grain need than its peaks. */
  roughness: number;
}
