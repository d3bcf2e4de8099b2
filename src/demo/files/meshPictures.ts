import type { Wrapping } from 'three';
import type { FindFile } from './FindFile.js';
import { baseName, extensionOf } from './fileName.js';
import { imageSize } from './imageSize.js';
import type { WantedPicture } from './mergeScene.js';
import { MAX_DRAWN_PIXELS, MAX_DRAWN_SIDE, MAX_PIXELS } from './pictureLimits.js';
import { readUri } from './readUri.js';
import type { PictureLink } from './standIns.js';

/** A picture of a mesh, decoded and the right way up. */
export interface MeshPicture {
  bitmap: ImageBitmap;
  wrapS: Wrapping;
  wrapT: Wrapping;
  /** Whether its alpha cuts out the surface. */
  cutOut: boolean;
}

/** So many names are given in a note. */
const NAMED = 3;

/** The pictures of a mesh, by their index in its ranges, and what to say about those that are not there. */
export interface MeshPictures {
  pictures: (MeshPicture | undefined)[];
  /** The names of those that nobody dropped. */
  missing: string[];
  notes: string[];
}

/** Finds and decodes the pictures that a mesh asks for, each once, in a size that can be drawn. */
export async function readMeshPictures(wanted: readonly WantedPicture[], findFile: FindFile): Promise<MeshPictures> {
  const missing = new Set<string>();
  const unreadable = new Set<string>();
  const shared = new Map<string, Promise<ImageBitmap | undefined>>();
  const pixels = MAX_DRAWN_PIXELS / wanted.length;
  const pictures: MeshPictures['pictures'] = [];
  for (const { texture, cutOut } of wanted) {
    const { url, content } = texture.image as PictureLink;
    const { flipY, wrapS, wrapT } = texture;
    const isInside = /^(blob|data):/.test(url);
    const name = isInside ? 'a picture in the file' : baseName(url);
    const key = `${flipY} ${isInside ? url : name.toLowerCase()}`;
    if (!shared.has(key)) {
      const bytes = content ? new Uint8Array(await content.arrayBuffer()) : await readUri(url, findFile);
      if (!bytes) missing.add(name);
      shared.set(key, bytes ? decode(bytes, url, flipY, pixels) : Promise.resolve(undefined));
      if (bytes && !(await shared.get(key))) unreadable.add(name);
    }
    const bitmap = await shared.get(key);
    pictures.push(bitmap && { bitmap, wrapS, wrapT, cutOut });
  }
  return { pictures, missing: [...missing], notes: unreadableNote([...unreadable]) };
}

/** Says which files a model asks for that nobody dropped. */
export function missingNote(names: readonly string[]): string[] {
  if (names.length === 0) return [];
  return [`without ${list(names)}: drop ${names.length > 1 ? 'them' : 'it'} along`];
}

const unreadableNote = (names: readonly string[]): string[] =>
  names.length === 0 ? [] : [`without ${list(names)}: too large, or no picture that a browser reads`];

function list(names: readonly string[]): string {
  const more = names.length > NAMED ? ` and ${names.length - NAMED} more` : '';
  return (
    names
      .slice(0, NAMED)
      .map((name) => name.slice(0, 60))
      .join(', ') + more
  );
}

async function decode(
  bytes: Uint8Array,
  url: string,
  flipY: boolean,
  pixels: number,
): Promise<ImageBitmap | undefined> {
  try {
    const source = extensionOf(url) === 'tga' ? await decodeTga(bytes) : undefined;
    const size = source ? [source.width, source.height] : imageSize(bytes);
    if (!size || size[0] * size[1] === 0 || size[0] * size[1] > MAX_PIXELS) return undefined;
    const [width, height] = size;
    const factor = Math.min(1, MAX_DRAWN_SIDE / Math.max(width, height), Math.sqrt(pixels / (width * height)));
    return await createImageBitmap(source ?? new Blob([bytes as Uint8Array<ArrayBuffer>]), {
      resizeWidth: Math.max(1, Math.round(factor * width)),
      resizeHeight: Math.max(1, Math.round(factor * height)),
      resizeQuality: 'medium',
      // WebGL cannot turn a bitmap while it uploads it.
      imageOrientation: flipY ? 'flipY' : 'none',
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    });
  } catch {
    return undefined;
  }
}

/** TGA, which older programs write and browsers do not read. */
async function decodeTga(bytes: Uint8Array): Promise<ImageData> {
  const { TGALoader } = await import('three/addons/loaders/TGALoader.js');
  const { data, width, height } = new TGALoader().parse(bytes.slice().buffer) as {
    data: Uint8Array;
    width: number;
    height: number;
  };
  return new ImageData(new Uint8ClampedArray(data), width, height);
}
