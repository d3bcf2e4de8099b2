import type { Texture, Wrapping } from 'three';
import { shownName } from '../common/ModelError.js';
import { baseName, extensionOf, readUri } from '../common/ModelFile.js';
import type { DecodedPicture, FindFile, PixelPicture, Surroundings } from '../common/Surroundings.js';
import {
  alphaOf,
  fitPictures,
  imageSize,
  isHalfThere,
  isOpaque,
  type PictureSize,
  PixelBudget,
  pixelsOf,
} from './imageSize.js';

/** A picture needed by a merged mesh. */
export interface WantedPicture {
  /** Its image is a {@link PictureLink}. */
  texture: Texture;
  /** A separate alpha map: lightness is alpha, or darkness where `userData.isInverted` is set. Its image is a {@link PictureLink}, too. */
  mask?: Texture | undefined;
  /** The alpha below which the surface is cut out; 0 without a cut-out. */
  cutOut: number;
  /** Whether the surface is blended; if its picture is mostly half-transparent, it becomes see-through. */
  isBlended?: boolean;
  /** Whether the file does not say that its picture cuts it out: one without clear edges between solid and clear parts does not. */
  mayBeWhole?: boolean;
}

/** The image of a texture before loading: the location of the picture. */
export interface PictureLink {
  url: string;
  /** The picture itself, if it is embedded in the model. */
  content?: Blob | undefined;
  width: number;
  height: number;
}

/** A mask with a lower mean alpha uses alpha as mask. */
const OPAQUE = 0.99;
const GREEN = 1;
const ALPHA = 3;

/**
 * A picture with a mask as its alpha: the mask's alpha where that varies, or else its lightness.
 *
 * @param picture undefined for plain white
 * @param isInverted whether the mask marks what is transparent
 * @returns undefined if pixels cannot be read
 */
async function masked(
  picture: DecodedPicture | undefined,
  mask: DecodedPicture,
  decodePicture: Surroundings['decodePicture'],
  isInverted = false,
): Promise<DecodedPicture | undefined> {
  const { width, height } = picture ?? mask;
  const alphas = pixelsOf(mask, width, height);
  const colors = picture ? pixelsOf(picture, width, height) : new Uint8ClampedArray(4 * width * height).fill(255);
  if (!alphas || !colors) return undefined;
  const data = colors.slice();
  const channel = (alphaOf(mask)?.mean ?? 1) < OPAQUE ? ALPHA : GREEN;
  for (let i = 0; i < data.length; i += 4)
    data[i + ALPHA] = isInverted ? 255 - alphas[i + channel] : alphas[i + channel];
  return decodePicture({ data, width, height }, { width, height, flipY: false });
}

/** A decoded, upright picture of a mesh. */
export interface MeshPicture {
  bitmap: DecodedPicture;
  wrapS: Wrapping;
  wrapT: Wrapping;
  /** The alpha below which the surface is cut out; 0 without a cut-out. */
  cutOut: number;
}

/** At most this many names are listed in a note. */
const NAMED = 2;

/** The pictures of a mesh, by index in its ranges, and what is missing. */
interface MeshPictures {
  pictures: (MeshPicture | undefined)[];
  /** Indices of see-through pictures. */
  clear: ReadonlySet<number>;
  /** Names of pictures that were not dropped along. */
  missing: string[];
  /** The number of pictures that could not be read. */
  lostPictures: number;
  notes: string[];
}

/** A picture file, and the size to draw it in. */
interface Source extends PictureSize {
  name: string;
  bytes: Uint8Array;
  /** Whether it is a TGA file, which only its name tells. */
  isTga: boolean;
  flipY: boolean;
  bitmap?: DecodedPicture | undefined;
}

/**
 * Finds and decodes the pictures of a mesh, each once, in sizes that fit together. Sizes are read from headers before anything is decoded.
 *
 * @param decodePicture decodes one picture
 * @param onPicture called before each is decoded
 */
export async function readMeshPictures(
  wanted: readonly WantedPicture[],
  findFile: FindFile,
  decodePicture: Surroundings['decodePicture'],
  onPicture: (number: number, count: number) => void,
): Promise<MeshPictures> {
  const lacks = { missing: new Set<string>(), unreadable: new Set<string>(), tooLarge: new Set<string>() };
  const budget = new PixelBudget();
  const asked = new Set<string>();
  const shared = new Map<string, Source>();
  const find = async ({ image, flipY }: Texture): Promise<Source | undefined> => {
    const { url, content } = image as PictureLink;
    const isInside = /^(blob|data):/.test(url);
    const name = isInside ? 'a picture in the file' : baseName(url);
    const key = `${flipY} ${isInside ? url : name.toLowerCase()}`;
    if (!asked.has(key)) {
      asked.add(key);
      const bytes = content ? new Uint8Array(await content.arrayBuffer()) : await readUri(url, findFile);
      const isTga = extensionOf(url) === 'tga';
      const size = bytes && (isTga ? tgaSize(bytes) : imageSize(bytes));
      if (!bytes) lacks.missing.add(name);
      else if (!size || size[0] * size[1] === 0) lacks.unreadable.add(name);
      else if (!budget.take(...size)) lacks.tooLarge.add(name);
      else {
        const [width, height] = size;
        shared.set(key, { name, bytes, isTga, flipY, width, height, isReduced: false });
      }
    }
    return shared.get(key);
  };
  const sources: { colors: Source | undefined; mask: Source | undefined }[] = [];
  for (const { texture, mask } of wanted)
    sources.push({ colors: await find(texture), mask: mask && (await find(mask)) });
  const distinct = [...shared.values()];
  const reduced = fitPictures(distinct);
  // One at a time, because each briefly needs its full size in memory.
  for (const [i, source] of distinct.entries()) {
    onPicture(i + 1, distinct.length);
    try {
      source.bitmap = await decode(source, decodePicture);
    } catch {
      lacks.unreadable.add(source.name);
    }
  }
  const pictures: (MeshPicture | undefined)[] = [];
  const clear = new Set<number>();
  for (const [i, { texture, mask: alphaMap, cutOut, isBlended, mayBeWhole }] of wanted.entries()) {
    const { colors, mask } = sources[i];
    // A texture that serves as its own mask has no colours.
    const own = alphaMap === texture ? undefined : colors?.bitmap;
    const { isInverted } = alphaMap?.userData ?? {};
    const bitmap = (mask?.bitmap && (await masked(own, mask.bitmap, decodePicture, isInverted))) ?? colors?.bitmap;
    const alpha = (isBlended || mayBeWhole) && bitmap && alphaOf(bitmap);
    if (alpha && isBlended && isHalfThere(alpha)) {
      clear.add(i);
      pictures.push(undefined);
      if (bitmap !== colors?.bitmap) bitmap.close();
    } else {
      const isWhole = mayBeWhole ? !alpha || isOpaque(alpha) || isHalfThere(alpha) : alpha && isOpaque(alpha);
      pictures.push(bitmap && { bitmap, wrapS: texture.wrapS, wrapT: texture.wrapT, cutOut: isWhole ? 0 : cutOut });
    }
  }
  for (const { bitmap } of distinct) if (!pictures.some((picture) => picture?.bitmap === bitmap)) bitmap?.close();
  const notes = [
    ...without(
      [...lacks.unreadable],
      lacks.unreadable.size === 1 ? 'no picture that a browser reads' : 'no pictures that a browser reads',
    ),
    ...without([...lacks.tooLarge], 'too large'),
    ...reduced,
  ];
  const lostPictures = lacks.unreadable.size + lacks.tooLarge.size;
  return { pictures, clear, missing: [...lacks.missing], lostPictures, notes };
}

/** A note on missing files, and what to do about them. */
export function missingNote(names: readonly string[]): string[] {
  if (names.length === 0) return [];
  return [
    names.length === 1 ? `${list(names)} is missing: drop it along` : `${list(names)} are missing: drop them along`,
  ];
}

/** All missing names, if the note lists only some of them. */
export function missingDetail(names: readonly string[]): string[] {
  return names.length > NAMED ? [`missing: ${names.map(shownName).join(', ')}`] : [];
}

const without = (names: readonly string[], why: string): string[] =>
  names.length === 0 ? [] : [`without ${list(names)}: ${why}`];

function list(names: readonly string[]): string {
  const shown = names.slice(0, NAMED).map(shownName);
  if (names.length > NAMED) return `${shown.join(', ')} and ${names.length - NAMED} more`;
  return shown.join(' and ');
}

async function decode(
  { bytes, isTga, width, height, flipY }: Source,
  decodePicture: Surroundings['decodePicture'],
): Promise<DecodedPicture | undefined> {
  const content = isTga ? await decodeTga(bytes) : new Blob([bytes as Uint8Array<ArrayBuffer>]);
  return decodePicture(content, { width, height, flipY });
}

const HEADER_BYTES = 18;
/** Image types from this one on are run-length encoded. */
const FIRST_PACKED = 9;

/** Width and height from the header of a TGA file, which has no signature. */
export function tgaSize(bytes: Uint8Array): [width: number, height: number] | undefined {
  if (bytes.length < HEADER_BYTES) return undefined;
  const view = viewOf(bytes);
  return [view.getUint16(12, true), view.getUint16(14, true)];
}

/**
 * Decodes TGA, which older programs write and browsers do not decode.
 *
 * @throws Error if the file is truncated
 */
export async function decodeTga(bytes: Uint8Array): Promise<Omit<PixelPicture, 'close'>> {
  if (!isWhole(bytes)) throw new Error('TGA: cut short');
  const { TGALoader } = await import('three/addons/loaders/TGALoader.js');
  const { data, width, height } = new TGALoader().parse(bytes.slice().buffer) as {
    data: Uint8Array;
    width: number;
    height: number;
  };
  return { data: new Uint8ClampedArray(data), width, height };
}

/** Whether a file contains all its pixels. The loader would make missing ones black. */
function isWhole(bytes: Uint8Array): boolean {
  const [width, height] = tgaSize(bytes) ?? [0, 0];
  const [idBytes, hasPalette, type] = bytes;
  const bytesOf = (bits: number): number => Math.ceil(bits / 8);
  const paletteBytes = hasPalette ? viewOf(bytes).getUint16(5, true) * bytesOf(bytes[7]) : 0;
  const pixelBytes = bytesOf(bytes[16]);
  let at = HEADER_BYTES + idBytes + paletteBytes;
  let left = width * height;
  if (type < FIRST_PACKED) return at + left * pixelBytes <= bytes.length;
  while (left > 0 && at < bytes.length) {
    const count = (bytes[at] & 0x7f) + 1;
    at += 1 + (bytes[at] & 0x80 ? 1 : count) * pixelBytes;
    left -= count;
  }
  return left <= 0 && at <= bytes.length;
}

const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
