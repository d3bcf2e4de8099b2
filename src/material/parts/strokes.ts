import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/**
 * Strokes that are anchored in the surface: the technique `hatching`, what `dryMedia` and `stipple` share with it, and what techniques per
 * triangle do.
 */
export const part: MaterialPart = {
  surface,
  files: import.meta.glob<string>(
    [
      './techniques/strokes/*',
      '!./techniques/strokes/{stipple,dots}.glsl',
      './chunks/{ink,largestComponents,levelByDepth,lightOrientation,thresholdMap}.glsl',
    ],
    { base: '../../../shaders', query: '?raw', import: 'default', eager: true },
  ),
};
