import { baseName } from '../common/fileName.js';
import { ModelError } from '../common/ModelError.js';
import { readUri } from '../common/readUri.js';
import type { FindFile } from '../common/Surroundings.js';
import { fitPictures, type PictureSize, PixelBudget } from '../pictures/fitPictures.js';
import { imageSize } from '../pictures/imageSize.js';
import type { AccessorValues } from './GltfValues.js';
import type { GltfDocument } from './gltfDocument.js';
import { usedImages } from './gltfMaterials.js';

/** A picture to decode, and the size to draw it in. */
export interface Picture extends PictureSize {
  content: Blob;
}

/** The pictures to draw, by image index, and what is missing. */
export interface Pictures {
  pictures: (Picture | undefined)[];
  /** Names of pictures that were not dropped along. */
  missing: string[];
  /** The number of pictures that could not be read. */
  lostPictures: number;
  notes: string[];
}

/** Collects the pictures that materials use. Sizes are read from headers, before anything is decoded. */
export async function collectPictures(
  document: GltfDocument,
  values: AccessorValues,
  findFile: FindFile,
): Promise<Pictures> {
  const used = usedImages(document);
  const pictures: (Picture | undefined)[] = document.images.map(() => undefined);
  const missing: string[] = [];
  let unreadable = 0;
  let tooLarge = 0;
  const budget = new PixelBudget();
  for (const [i, image] of document.images.entries()) {
    if (!used.has(i) || !image) continue;
    const { uri, bufferView } = image;
    const bytes = uri === undefined ? viewBytes(values, bufferView) : await readUri(uri, findFile);
    const [width, height] = (bytes && imageSize(bytes)) ?? [0, 0];
    if (!bytes && uri !== undefined && !uri.startsWith('data:')) missing.push(baseName(uri));
    else if (width * height === 0) unreadable++;
    else if (!budget.take(width, height)) tooLarge++;
    else pictures[i] = { content: new Blob([bytes as Uint8Array<ArrayBuffer>]), width, height, isReduced: false };
  }
  const notes = [...describe(unreadable, tooLarge), ...fitPictures(pictures.filter((one) => one !== undefined))];
  return { pictures, missing: [...new Set(missing)], lostPictures: unreadable + tooLarge, notes };
}

function viewBytes(values: AccessorValues, view: number | undefined): Uint8Array | undefined {
  try {
    return view === undefined ? undefined : values.viewOf(view);
  } catch (error) {
    if (error instanceof ModelError) return undefined;
    throw error;
  }
}

function describe(unreadable: number, tooLarge: number): string[] {
  const pictures = (count: number): string => `${count} ${count === 1 ? 'picture' : 'pictures'}`;
  const notes: string[] = [];
  if (unreadable > 0) notes.push(`${pictures(unreadable)} left out: not PNG, JPEG or WebP`);
  if (tooLarge > 0) notes.push(`${pictures(tooLarge)} left out: too large`);
  return notes;
}
