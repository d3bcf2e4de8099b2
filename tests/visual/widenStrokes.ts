import { placeStrokes } from '../../src/strokes/placeStrokes.js';
import { rasterizeStroke } from '../../src/strokes/rasterizeStroke.js';
import { type MapRequest, resolveHatchImageOptions } from '../../src/strokes/tamImages/generateHatchImages.js';
import type { HatchImages } from '../../src/strokes/tamImages/HatchImages.js';

/**
 * The hatch images of `options` with every stroke `factor` times as wide and otherwise the same. The generator itself
 * would answer a greater width with fewer strokes, and another drawing proves nothing.
 */
export function widenStrokes(options: MapRequest, factor: number): HatchImages {
  const request = resolveHatchImageOptions(options);
  const placement = placeStrokes(request);
  let step = placement.next();
  while (!step.done) step = placement.next();
  const strokes = step.value.map((stroke) => ({ ...stroke, width: stroke.width * factor }));

  const images = Array.from({ length: request.tones }, (_, tone) =>
    Array.from({ length: request.levels }, (_, level) => {
      const size = request.size >> level;
      const image = new Uint8Array(size * size).fill(255);
      for (const stroke of strokes) {
        if (stroke.tone <= tone && stroke.level >= level) rasterizeStroke(image, size, stroke);
      }
      return image;
    }),
  );
  return { size: request.size, images };
}
