import { type PaperGrain, paperGrain } from '../paperGrain.js';
import { placeStrokes } from '../placeStrokes.js';
import { rasterizeStroke } from '../rasterizeStroke.js';
import type { Stroke } from '../Stroke.js';
import type { StrokeStyle } from '../StrokeStyle.js';
import { strokeStyles } from '../strokeStyles.js';
import { findLostInk, HALF_INK } from './checkHatchImages.js';
import type { HatchImages } from './HatchImages.js';
import { type FullMapDrawing, type MapDrawing, resolveMapDrawing } from './hatchImageOptions.js';

/**
 * Draws the hatch images of a tonal art map: every tone at every level.
 *
 * The mean ink of image k is maxInk·k/(tones−1) on every level, to within half a stroke; maxInk belongs to the style. Ink is
 * averaged linearly (0 = paper, 1 = ink), so from a distance a renderer that mixes paper and ink in linear light shows these means.
 *
 * @throws RangeError if an option is out of its range, at the first step
 * @returns the images; yields progress in [0, 1]
 */
export function* generateHatchImages(options: MapRequest = {}): Generator<number, HatchImages, void> {
  const request = resolveHatchImageOptions(options);
  const strokes = yield* placeStrokes(request);
  const grains = Array.from({ length: request.levels }, (_, level) => paperGrain(request, level));
  const images: Uint8Array[][] = [];
  for (let tone = 0; tone < request.tones; tone++) {
    images.push(drawTone(strokes, tone, request, grains, images.at(-1)));
    yield 1;
  }
  // Strokes nest because finer levels repeat them. Grain breaks strokes up and hands bend them, so nesting must be enforced.
  if (request.style.grain || request.style.hand) enforceLevelNesting({ size: request.size, images });
  return { size: request.size, images, strokeTexels: request.style.width };
}

/** Draws all levels of one tone: the images of the tone before, plus its new strokes. */
function drawTone(
  strokes: Stroke[],
  tone: number,
  request: HatchImageRequest,
  grains: (PaperGrain | undefined)[],
  lighter?: Uint8Array[],
): Uint8Array[] {
  const added = strokes.filter((stroke) => stroke.tone === tone);
  return Array.from({ length: request.levels }, (_, level) => {
    const size = request.size >> level;
    const image = lighter ? lighter[level].slice() : new Uint8Array(size * size).fill(255);
    for (const stroke of added) if (stroke.level >= level) rasterizeStroke(image, size, stroke, grains[level]);
    return image;
  });
}

/**
 * Repairs the nesting of levels at all places where ink of a coarser level is missing from the finer one (`findLostInk`): a texel
 * there becomes half ink, in this tone and in every darker one. Nothing becomes lighter, so tones stay nested.
 *
 * @param images changed in place
 */
export function enforceLevelNesting({ size, images }: HatchImages): void {
  for (const [tone, row] of images.entries()) {
    for (let level = row.length - 1; level > 0; level--) {
      for (const texel of findLostInk(row[level], row[level - 1], size >> level)) {
        for (let darker = tone; darker < images.length; darker++) {
          const image = images[darker][level - 1];
          image[texel] = Math.min(HALF_INK, image[texel]);
        }
      }
    }
  }
}

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
