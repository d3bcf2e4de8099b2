import { readFile, stat } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, relative } from 'node:path';
import { compileFunction } from 'node:vm';
import type { DecoderModule } from 'draco3d';
import { baseName } from '../../viewer/files/common/fileName.js';
import { MAX_BYTES } from '../../viewer/files/common/ModelFile.js';
import type { PictureSource, PictureWish, PixelPicture, Surroundings } from '../../viewer/files/common/Surroundings.js';
import { decodePicture, UndecodedError } from './decodePicture.js';

/**
 * What the readers need from Node in place of a browser: files beside the model, and decoders of PNG, JPEG, WebP and Draco. Fetches
 * nothing.
 */
export class NodeSurroundings implements Surroundings {
  /** The formats of pictures that were requested and cannot be decoded here. */
  readonly undecoded = new Set<string>();

  /** @param folder the folder of the model */
  constructor(private readonly folder: string) {}

  readonly decodePicture = async (source: PictureSource, wish: PictureWish): Promise<PixelPicture | undefined> => {
    if (!(source instanceof Blob)) return fitPixels(source, wish);
    try {
      return fitPixels(await decodePicture(new Uint8Array(await source.arrayBuffer())), wish);
    } catch (error) {
      if (!(error instanceof UndecodedError)) throw error;
      this.undecoded.add(error.format);
      return undefined;
    }
  };

  /**
   * Finds a file in the model's folder or below it, by its path or by its name. Never reads outside that folder, whatever the model's URIs
   * say.
   */
  readonly findFile = async (uri: string): Promise<Uint8Array | undefined> => {
    const path = plainPath(uri);
    for (const one of [path, baseName(path)]) {
      const place = join(this.folder, one);
      const inside = relative(this.folder || '.', place);
      if (inside === '' || inside.startsWith('..') || one.includes('\0')) continue;
      const found = await stat(place).catch(() => undefined);
      if (found?.isFile() && found.size <= MAX_BYTES) return readFile(place);
    }
    return undefined;
  };

  /** The Draco decoder that comes with three.js: a script, run with the globals that it expects of Node. */
  readonly loadDraco = async (): Promise<DecoderModule> => {
    const require = createRequire(import.meta.url);
    const script = require.resolve('three/addons/libs/draco/gltf/draco_wasm_wrapper.js');
    const wasmBinary = await readFile(require.resolve('three/addons/libs/draco/gltf/draco_decoder.wasm'));
    const module: { exports: unknown } = { exports: {} };
    const names = ['module', 'exports', 'require', '__dirname', '__filename'];
    const run = compileFunction(await readFile(script, 'utf8'), names, { filename: script });
    run(module, module.exports, require, dirname(script), script);
    const start = module.exports as (options: object) => Promise<DecoderModule>;
    // Damaged parts are reported in a sentence, not on the console.
    return start({ wasmBinary, print: () => {}, printErr: () => {} });
  };
}

function plainPath(uri: string): string {
  try {
    return decodeURIComponent(uri).replaceAll('\\', '/');
  } catch {
    return uri;
  }
}

/** Resizes a picture by averaging pixels, and flips it if asked to. */
export function fitPixels(picture: Omit<PixelPicture, 'close'>, { width, height, flipY }: PictureWish): PixelPicture {
  const isFitting = picture.width === width && picture.height === height && !flipY;
  const data = isFitting ? picture.data : new Uint8ClampedArray(4 * width * height);
  for (let y = 0; !isFitting && y < height; y++) {
    const row = flipY ? height - 1 - y : y;
    const [top, bottom] = span(row, height, picture.height);
    for (let x = 0; x < width; x++) {
      const [left, right] = span(x, width, picture.width);
      const sums = [0, 0, 0, 0];
      for (let j = top; j < bottom; j++) {
        for (let i = left; i < right; i++)
          for (let k = 0; k < 4; k++) sums[k] += picture.data[4 * (j * picture.width + i) + k];
      }
      const count = (bottom - top) * (right - left);
      for (let k = 0; k < 4; k++) data[4 * (y * width + x) + k] = sums[k] / count;
    }
  }
  return { data, width, height, close: () => {} };
}

/** The range of source pixels that one of `count` target pixels covers, of `given`: the first, and the one after the last. */
function span(place: number, count: number, given: number): [number, number] {
  const from = Math.floor((place * given) / count);
  return [from, Math.max(from + 1, Math.floor(((place + 1) * given) / count))];
}
