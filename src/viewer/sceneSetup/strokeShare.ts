import { MathUtils } from 'three';

/** On a sheet smaller than this (in CSS pixels), strokes become finer with the drawing, down to a share of their width. */
export const FULL_SHEET = { width: 640, height: 520 };
export const LEAST_STROKE_SHARE = 0.55;

/** How wide strokes are on a sheet of this size, as a share of what the settings say. */
export const strokeShare = (width: number, height: number): number =>
  MathUtils.clamp(Math.min(width / FULL_SHEET.width, height / FULL_SHEET.height), LEAST_STROKE_SHARE, 1);
