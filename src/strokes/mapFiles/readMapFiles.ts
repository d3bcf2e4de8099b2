import { meanInk } from '../tamImages/checkHatchImages.js';
import {
  DEFAULT_STROKE_TEXELS,
  excessOf,
  excessOfTones,
  type HatchImages,
  MAX_SIDE,
} from '../tamImages/HatchImages.js';
import { decodePng, type Pixels } from './decodePng.js';
import { MAP_FORMAT, MAP_VERSION, type MapDescription, THRESHOLD_STEP } from './mapFiles.js';

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

/** Reads a file by its name. Error messages continue a sentence that begins with the name. */
type ReadFile = (name: string) => Promise<Uint8Array>;

/** A grey picture. */
interface GreyPicture {
  width: number;
  height: number;
  /** width·height bytes, top row first, 255 = paper. */
  image: Uint8Array;
}

/**
 * Reads the pictures of a map. All files are fetched at once. They are decoded one at a time, on request, since decoding may take 250 MB:
 * after a picture of a wrong size, no other is requested.
 */
class PictureReader {
  private readonly files = new Map<string, Promise<Uint8Array>>();
  private readonly greys = new Map<string, GreyPicture>();
  private opened = 0;

  /**
   * @param names the names of all pictures, in the order in which they will be requested; names may repeat
   * @param onProgress called with the share of `names` that were requested so far
   */
  constructor(
    private readonly names: readonly string[],
    read: ReadFile,
    private readonly onProgress: (done: number) => void,
  ) {
    for (const name of new Set(names)) {
      const file = withFileName(name, read(name));
      // Errors are reported when the picture is requested, which does not happen after another has failed.
      file.catch(() => {});
      this.files.set(name, file);
    }
  }

  /** Opens a picture and makes it grey. A second call with the same name returns the same picture. */
  async grey(name: string): Promise<GreyPicture> {
    let grey = this.greys.get(name);
    if (!grey) {
      grey = greyOf(await this.decode(name));
      this.greys.set(name, grey);
    }
    this.count();
    return grey;
  }

  /** Opens a picture with its colours. */
  async colours(name: string): Promise<Pixels> {
    const pixels = await this.decode(name);
    this.count();
    return pixels;
  }

  private async decode(name: string): Promise<Pixels> {
    return withFileName(name, decodePng(await this.files.get(name)!, MAX_SIDE));
  }

  private count(): void {
    this.onProgress(++this.opened / this.names.length);
  }
}

/** The luminance of each pixel, computed from the bytes without linearising them. */
function greyOf({ width, height, channels, data }: Pixels): GreyPicture {
  if (channels === 1) return { width, height, image: data };
  const image = new Uint8Array(data.length / 3);
  for (let i = 0; i < image.length; i++) {
    image[i] = Math.round(0.2126 * data[3 * i] + 0.7152 * data[3 * i + 1] + 0.0722 * data[3 * i + 2]);
  }
  return { width, height, image };
}

/** @throws Error that names a file, its fault and the remedy */
function fail(name: string, fault: string): never {
  throw new Error(`TonalArtMap.load: ${name} ${fault}.`);
}

/** Waits for work on a file, and prefixes errors with the name of the file. */
async function withFileName<Result>(name: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (error) {
    fail(name, error instanceof Error ? error.message : String(error));
  }
}
