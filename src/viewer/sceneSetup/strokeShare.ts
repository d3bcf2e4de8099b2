import { MathUtils } from 'three';

/** On a sheet smaller than this, in CSS pixels, strokes become thinner along with the drawing, down to a minimum share. */
export const FULL_SHEET = { width: 640, height: 520 };
export const LEAST_STROKE_SHARE = 0.55;

/** The width of strokes on a sheet of this size, as a share of the settings' width. */
export const strokeShare = (width: number, height: number): number =>
  MathUtils.clamp(Math.min(width / FULL_SHEET.width, height / FULL_SHEET.height), LEAST_STROKE_SHARE, 1);
