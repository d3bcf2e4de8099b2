import { checkHand } from '../hand/checkHand.js';
import { handStyle } from '../strokes/handStyle.js';
import type { StrokeStyle } from '../strokes/StrokeStyle.js';
import { strokeStyles } from '../strokes/strokeStyles.js';
import { type FullMapDrawing, type MapDrawing, resolveMapDrawing } from './hatchImageOptions.js';

/** The options with the style that they name. */
export interface HatchImageRequest extends Omit<FullMapDrawing, 'style' | 'hand' | 'strokeTexels'> {
  style: StrokeStyle;
}

/**
 * Fills in defaults, checks ranges, and looks up how the style is drawn.
 *
 * @throws RangeError or TypeError that names the option and its range
 */
export function resolveHatchImageOptions(options: MapDrawing = {}): HatchImageRequest {
  const { style, hand, strokeTexels, ...shape } = resolveMapDrawing(options);
  if (!hand) return { style: { ...strokeStyles[style], width: strokeTexels }, ...shape };
  checkHand('TonalArtMap.generate', hand);
  return { style: handStyle(hand, strokeTexels, shape.size), ...shape };
}
