import type { ThresholdLevel } from '../../strokes/tamImages/encodeThresholds.js';
import type { HatchImages } from '../../strokes/tamImages/HatchImages.js';
import type { MapDrawing } from '../../strokes/tamImages/hatchImageOptions.js';
import type { MapRequest } from '../../strokes/tamImages/hatchImageRequest.js';
import { runTask } from '../../worker/runTask.js';
import type { TaskOptions } from '../../worker/TaskOptions.js';

/** The share of the progress for drawing the images; the rest is for the thresholds. */
const IMAGES_SHARE = 0.7;

/** Draws the images and thresholds of a map, in a worker if possible. */
export async function drawHatchImages(
  drawing: MapDrawing,
  { onProgress, ...options }: TaskOptions,
): Promise<{ images: HatchImages; thresholds: ThresholdLevel[] }> {
  // What prepares hands is fetched with the first of them.
  const request = drawing.hand
    ? await (await import('./prepareInSlices.js')).prepareInSlices(drawing, options.signal)
    : (drawing as MapRequest);
  const again = (): MapRequest => request;
  const partOf = (from: number, share: number): TaskOptions => ({
    ...options,
    onProgress: onProgress && ((progress) => onProgress(from + share * progress)),
  });
  const images = await runTask('generateHatchImages', request, partOf(0, IMAGES_SHARE), again);
  const thresholds = await runTask('generateThresholds', request, partOf(IMAGES_SHARE, 1 - IMAGES_SHARE), again);
  return { images, thresholds };
}
