import { requestOfHand } from '../../../src/strokes/handStyle.js';
import { rasterizeStroke } from '../../../src/strokes/rasterizeStroke.js';
import type { Stroke } from '../../../src/strokes/Stroke.js';
import type { StrokeStyleName } from '../../../src/strokes/strokeStyleNames.js';
import { strokeStyles } from '../../../src/strokes/strokeStyles.js';
import { generateHatchImages, type MapRequest } from '../../../src/strokes/tamImages/generateHatchImages.js';
import type { HatchImages } from '../../../src/strokes/tamImages/HatchImages.js';
import type { MapDrawing } from '../../../src/strokes/tamImages/hatchImageOptions.js';

/** The styles, for test matrices. */
export const styleNames = Object.keys(strokeStyles) as StrokeStyleName[];

/** Runs a generator to its end. */
export function finish<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
  }
}

const drawn = new Map<string, HatchImages>();

/** The request that the worker gets for a map. */
export const requestOf = (drawing: MapDrawing): MapRequest => finish(requestOfHand(drawing));

/** Hatch images with these options, drawn once per test file. */
export function hatchImages(options: MapRequest): HatchImages {
  // Profiles refer to each other in cycles.
  const key = JSON.stringify(options, (name, value) => (name === 'turned' || name === 'mirrored' ? undefined : value));
  const known = drawn.get(key) ?? finish(generateHatchImages(options));
  drawn.set(key, known);
  return known;
}

/** An image of these strokes alone, in this order. */
export function drawStrokes(strokes: readonly Stroke[], size: number): Uint8Array {
  const image = new Uint8Array(size * size).fill(255);
  for (const stroke of strokes) rasterizeStroke(image, size, stroke);
  return image;
}
