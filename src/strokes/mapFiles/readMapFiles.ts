import { meanInk } from '../tamImages/checkHatchImages.js';
import { DEFAULT_STROKE_TEXELS, type HatchImages } from '../tamImages/HatchImages.js';
import { excessOf, excessOfTones, MAX_SIDE } from '../tamImages/mapLimits.js';
import { MAP_FORMAT, MAP_VERSION, type MapDescription, THRESHOLD_STEP } from './mapFiles.js';
import { fail, PictureReader, type ReadFile, withFileName } from './PictureReader.js';

/** An image with at most this mean ink counts as the blank paper of tone 0. */
const BLANK = 0.002;

/** The content of the files of a map. */
export interface ReadMap extends HatchImages {
  /** Whether there is only one image per tone, so that the other levels must be made. */
  lacksLevels: boolean;
  /** The thresholds of every level, if they were saved. */
  thresholds: Float32Array[] | undefined;
}

/**
 * Reads a map as its JSON file describes it.
 *
 * @param name the name of the JSON file
 * @throws Error that names the wrong file and the remedy
 */
export async function readMap(name: string, read: ReadFile, onProgress: (done: number) => void): Promise<ReadMap> {
  const description = parseDescription(name, new TextDecoder().decode(await withFileName(name, read(name))));
  const { size, strokeTexels } = description;
  const lacksLevels = typeof description.images[0] === 'string';
  const names = description.images.map((row) => (typeof row === 'string' ? [row] : row));
  const pictures = new PictureReader([...names.flat(), ...(description.thresholds ?? [])], read, onProgress);
  const images: Uint8Array[][] = [];
  for (const row of names) {
    const levels: Uint8Array[] = [];
    for (const [level, file] of row.entries()) {
      const { image, ...sides } = await pictures.grey(file);
      assertLevel(file, sides, size, level);
      levels.push(image);
    }
    images.push(levels);
  }
  const thresholds: Float32Array[] = [];
  for (const [level, file] of (description.thresholds ?? []).entries()) {
    const { channels, data, ...sides } = await pictures.colours(file);
    assertLevel(file, sides, size, level);
    if (channels !== 3) fail(file, 'holds no thresholds: it is grey; save the map again');
    thresholds.push(thresholdsFromRgb(data));
  }
  if (lacksLevels) assertLightToDark(names.flat(), images);
  return {
    size,
    strokeTexels,
    images: lacksLevels ? withBlankTone(images) : images,
    lacksLevels,
    thresholds: description.thresholds && thresholds,
  };
}

function assertLevel(
  name: string,
  { width, height }: { width: number; height: number },
  size: number,
  level: number,
): void {
  const side = size >> level;
  if (width === side && height === side) return;
  fail(name, `has ${width} × ${height} pixels, but level ${level} of size ${size} needs ${side} × ${side}`);
}

/**
 * Reads images drawn by hand or by other software, one per tone.
 *
 * @param names the names of the images, the lightest tone first
 * @param sort whether to sort the images by darkness instead of keeping their order
 * @throws Error that names the wrong file and the remedy
 */
export async function readImages(
  names: readonly string[],
  read: ReadFile,
  sort: boolean,
  onProgress: (done: number) => void,
): Promise<ReadMap> {
  assertAllowed('the list of images', excessOfTones(names.length));
  const pictures = new PictureReader(names, read, onProgress);
  const files: { name: string; size: number; image: Uint8Array }[] = [];
  for (const name of names) {
    const { width, height, image } = await pictures.grey(name);
    if (width !== height || (width & (width - 1)) !== 0) {
      fail(name, `has ${width} × ${height} pixels, but a tile must be square with a power of two, such as 256 × 256`);
    }
    files.push({ name, size: width, image });
    const [first] = files;
    if (width !== first.size) {
      fail(name, `has ${width} pixels per side, but ${first.name} has ${first.size}; give every tone the same`);
    }
    assertAllowed('the list of images', excessOf(names.length, width));
  }
  if (sort) files.sort((a, b) => meanInk(a.image) - meanInk(b.image));
  const images = files.map(({ image }) => [image]);
  assertLightToDark(
    files.map((file) => file.name),
    images,
  );
  return { size: files[0].size, images: withBlankTone(images), lacksLevels: true, thresholds: undefined };
}

function assertAllowed(name: string, excess: string | undefined): void {
  if (excess) fail(name, excess);
}

function parseDescription(name: string, text: string): MapDescription {
  let found: Partial<MapDescription>;
  try {
    found = JSON.parse(text);
  } catch {
    fail(name, 'is not valid JSON; save the map again');
  }
  if (found?.format !== MAP_FORMAT) {
    fail(name, `does not describe a tonal art map; its "format" must be "${MAP_FORMAT}"`);
  }
  if (found.version !== MAP_VERSION) {
    fail(
      name,
      `is of version ${String(found.version)}, but this three-hatching reads version ${MAP_VERSION}; update three-hatching or save the map again`,
    );
  }
  const { size, images, thresholds, strokeTexels = DEFAULT_STROKE_TEXELS } = found;
  if (!Number.isInteger(size) || size! < 1 || size! > MAX_SIDE || (size! & (size! - 1)) !== 0) {
    fail(name, `has "size" ${String(size)}, but it must be a power of two up to ${MAX_SIDE}`);
  }
  if (!(typeof strokeTexels === 'number' && strokeTexels > 0)) {
    fail(name, `has "strokeTexels" ${String(strokeTexels)}, but it must be a width in texels above 0`);
  }
  const isName = (value: unknown): boolean => typeof value === 'string' && value !== '';
  const isRow = (row: unknown): boolean => Array.isArray(row) && row.length > 0 && row.every(isName);
  const isMap = Array.isArray(images) && images.length >= 2 && (images.every(isName) || images.every(isRow));
  if (!isMap) {
    fail(
      name,
      'must name at least two "images", the lightest first: a file for each tone, or a list of files, its levels',
    );
  }
  const levels = new Set(images.map((row) => row.length));
  if (Array.isArray(images![0]) && (levels.size > 1 || images![0].length > Math.log2(size!) + 1)) {
    fail(
      name,
      `must name the same number of levels for every tone, and at most ${Math.log2(size!) + 1} at size ${size}`,
    );
  }
  assertAllowed(name, excessOf(images!.length, size!));
  if (thresholds !== undefined && (!isRow(thresholds) || thresholds.length !== images[0].length)) {
    fail(name, 'must name one file of "thresholds" per level, or none');
  }
  return found as MapDescription;
}

/** The inverse of `rgbFromThresholds`. */
function thresholdsFromRgb(bytes: Uint8Array): Float32Array {
  const thresholds = new Float32Array(bytes.length / 3);
  for (let i = 0; i < thresholds.length; i++) {
    thresholds[i] = ((bytes[3 * i] << 16) | (bytes[3 * i + 1] << 8) | bytes[3 * i + 2]) * THRESHOLD_STEP;
  }
  return thresholds;
}

function assertLightToDark(names: readonly string[], images: readonly (readonly Uint8Array[])[]): void {
  const means = images.map(([finest]) => meanInk(finest));
  const isReversed = means.length > 1 && means.every((mean, i) => i === 0 || mean < means[i - 1]);
  if (isReversed) fail(names[0], 'is the darkest image but comes first; list the lightest first');
}

/** Adds blank paper as tone 0 if it is missing, since artists rarely draw it. */
function withBlankTone(images: Uint8Array[][]): Uint8Array[][] {
  return meanInk(images[0][0]) > BLANK ? [[new Uint8Array(images[0][0].length).fill(255)], ...images] : images;
}
