import type { StrokeStyle } from '../StrokeStyle.js';
import { strokeStyles } from '../strokeStyles.js';
import { type FullMapDrawing, type MapDrawing, resolveMapDrawing } from './hatchImageOptions.js';

/** The options of a generated map in the form passed to the worker: plain data. */
export interface MapRequest extends Omit<MapDrawing, 'hand'> {
  /** The style of the hand (`handStyle`). */
  hand?: StrokeStyle | undefined;
}

/** The options with the named style. */
export interface HatchImageRequest extends Omit<FullMapDrawing, 'style' | 'strokeTexels'> {
  style: StrokeStyle;
}

/**
 * Fills in defaults, checks ranges, and resolves the style.
 *
 * @throws RangeError that names the option and its range
 */
export function resolveHatchImageOptions(options: MapRequest = {}): HatchImageRequest {
  const { style, strokeTexels, ...shape } = resolveMapDrawing(options);
  return { style: options.hand ?? { ...strokeStyles[style], width: strokeTexels }, ...shape };
}
