import type { FindFile } from './FindFile.js';
import { baseName } from './fileName.js';
import type { GltfValues } from './GltfValues.js';
import type { GltfDocument } from './gltfDocument.js';
import { usedImages } from './gltfMaterials.js';
import { imageSize } from './imageSize.js';
import { ModelError } from './ModelError.js';
import { MAX_DRAWN_PIXELS, MAX_DRAWN_SIDE, MAX_PIXELS } from './pictureLimits.js';
import { readUri } from './readUri.js';

/** A picture to be decoded, and the size it is to be drawn in. */
export interface Picture {
  content: Blob;
  width: number;
  height: number;
  /** Whether that is smaller than it is. */
  isReduced: boolean;
}

/** Pixels of all pictures of a file together, which are decoded one after the other. */
const MAX_TOTAL_PIXELS = 2 ** 28;

/** The pictures that are drawn, by the index of their image, and what to say about the others. */
export interface Pictures {
  pictures: (Picture | undefined)[];
  /** The names of those that nobody dropped. */
  missing: string[];
  notes: string[];
}

/** Collects the pictures that materials use. They are judged by their headers alone, before anything is decoded. */
export async function collectPictures(
  document: GltfDocument,
  values: GltfValues,
  findFile: FindFile,
): Promise<Pictures> {
  const used = usedImages(document);
  const pictures: (Picture | undefined)[] = document.images.map(() => undefined);
  const missing: string[] = [];
  let unreadable = 0;
  let tooLarge = 0;
  let total = 0;
  for (const [i, image] of document.images.entries()) {
    if (!used.has(i) || !image) continue;
    const { uri, bufferView } = image;
    const bytes = uri === undefined ? viewBytes(values, bufferView) : await readUri(uri, findFile);
    const [width, height] = (bytes && imageSize(bytes)) ?? [0, 0];
    if (!bytes && uri !== undefined && !uri.startsWith('data:')) missing.push(baseName(uri));
    else if (width * height === 0) unreadable++;
    else if (width * height > MAX_PIXELS || total + width * height > MAX_TOTAL_PIXELS) tooLarge++;
    else {
      total += width * height;
      pictures[i] = { content: new Blob([bytes as Uint8Array<ArrayBuffer>]), width, height, isReduced: false };
    }
  }
  const side = reduce(pictures);
  return { pictures, missing: [...new Set(missing)], notes: describe(unreadable, tooLarge, side) };
}

function viewBytes(values: GltfValues, view: number | undefined): Uint8Array | undefined {
  try {
    return view === undefined ? undefined : values.viewOf(view);
  } catch (error) {
    if (error instanceof ModelError) return undefined;
    throw error;
  }
}

/** Makes pictures smaller until they fit together. @returns the longest side left, if any was made smaller */
function reduce(pictures: readonly (Picture | undefined)[]): number | undefined {
  const given = pictures.flatMap((picture) => (picture ? [{ picture, ...picture }] : []));
  for (let side = MAX_DRAWN_SIDE; ; side /= 2) {
    let total = 0;
    let isReduced = false;
    for (const { picture, width, height } of given) {
      const factor = Math.min(1, side / Math.max(width, height));
      picture.width = Math.max(1, Math.round(factor * width));
      picture.height = Math.max(1, Math.round(factor * height));
      picture.isReduced = factor < 1;
      isReduced ||= picture.isReduced;
      total += picture.width * picture.height;
    }
    if (total <= MAX_DRAWN_PIXELS || side <= 1) return isReduced ? side : undefined;
  }
}

function describe(unreadable: number, tooLarge: number, side: number | undefined): string[] {
  const pictures = (count: number): string => `${count} ${count === 1 ? 'picture' : 'pictures'}`;
  const notes: string[] = [];
  if (unreadable > 0) notes.push(`${pictures(unreadable)} left out: not PNG, JPEG or WebP`);
  if (tooLarge > 0) notes.push(`${pictures(tooLarge)} left out: too large`);
  if (side !== undefined) notes.push(`pictures reduced to ${side.toLocaleString('en')} pixels`);
  return notes;
}
