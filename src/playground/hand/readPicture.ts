import { learnHandAsync, traceStrokes } from 'three-hatching';
import type { Report } from '../../viewer/drawing/buildModel.js';
import { ModelError, shownName } from '../../viewer/files/common/ModelError.js';
import type { OwnHand } from '../session/DrawingState.js';
import { LEAST_STROKES, learnOwnHand, ownHandOf } from './ownHand.js';
import { layOut } from './swatches.js';

/** The maximum size of a picture file, in bytes. */
const MOST_BYTES = 64 * 1024 * 1024;
/** Larger pictures are reduced to this many pixels, at which strokes are still several pixels wide. */
const MOST_PIXELS = 3_000_000;

/** A message of the library without the leading function name. */
const withoutCaller = (message: string): string => message.replace(/^\w+: /, '');

/** The hand with the strokes in the picture of a swatch. @throws ModelError with a sentence for the user, if there are none */
export async function readPicture(file: File, report: Report, signal: AbortSignal): Promise<OwnHand | undefined> {
  report('reading the picture', 0);
  const image = await decode(file);
  signal.throwIfAborted();
  const onProgress = (progress: number): void => report('finding the strokes in the picture', progress);
  try {
    const strokes = layOut(await traceStrokes(image, { signal, onProgress, swatch: 'middle' }));
    if (strokes.length < LEAST_STROKES) return learnOwnHand(strokes, {});
    return ownHandOf(await learnHandAsync(strokes, { signal }), strokes, {});
  } catch (error) {
    if (signal.aborted) throw error;
    throw new ModelError(`${shownName(file.name)}: ${withoutCaller((error as Error).message)}`);
  }
}

async function decode(file: File): Promise<ImageData> {
  const name = shownName(file.name);
  if (file.size > MOST_BYTES) {
    throw new ModelError(`${name} is larger than 64 MB: take a smaller picture of the strokes.`);
  }
  const bitmap = await createImageBitmap(file).catch(() => undefined);
  if (!bitmap) throw new ModelError(`${name} is no picture that this browser can read: PNG and JPEG are.`);
  const { width, height } = bitmap;
  const scale = Math.min(1, Math.sqrt(MOST_PIXELS / (width * height)));
  const size = [width, height].map((side) => Math.max(1, Math.round(scale * side))) as [number, number];
  const context = new OffscreenCanvas(...size).getContext('2d', { willReadFrequently: true });
  if (!context) throw new ModelError(`${name} needs more memory than this page can get.`);
  // Transparent pictures are drawn on white.
  context.fillStyle = 'white';
  context.fillRect(0, 0, ...size);
  context.imageSmoothingQuality = 'high';
  context.drawImage(bitmap, 0, 0, ...size);
  bitmap.close();
  return context.getImageData(0, 0, ...size);
}
