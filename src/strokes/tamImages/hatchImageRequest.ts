import type { StrokeStyle } from '../StrokeStyle.js';
import { strokeStyles } from '../strokeStyles.js';
import { type FullMapDrawing, type MapDrawing, resolveMapDrawing } from './hatchImageOptions.js';

/** The options that determine a generated map, as the worker gets them: plain data. */
export interface MapRequest extends Omit<MapDrawing, 'hand'> {
  /** The style in which the hand draws (`handStyle`). */
  hand?: StrokeStyle | undefined;
}

/** The options with the style that they name. */
export interface HatchImageRequest extends Omit<FullMapDrawing, 'style' | 'strokeTexels'> {
  style: StrokeStyle;
}

/**
 * Fills in defaults, checks ranges, and looks up how the style is drawn.
 *
 * @throws RangeError that names the option and its range
 */
export function resolveHatchImageOptions(options: MapRequest = {}): HatchImageRequest {
  const { style, strokeTexels, ...shape } = resolveMapDrawing(options);
  return { style: options.hand ?? { ...strokeStyles[style], width: strokeTexels }, ...shape };
}
