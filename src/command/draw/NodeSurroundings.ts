import { readFile, stat } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, relative } from 'node:path';
import { compileFunction } from 'node:vm';
import type { DecoderModule } from 'draco3d';
import { PNG_SIGNATURE, pngChunk } from '../../strokes/mapFiles/pngFormat.js';
import { baseName, MAX_BYTES } from '../../viewer/files/common/ModelFile.js';
import type { PictureSource, PictureWish, PixelPicture, Surroundings } from '../../viewer/files/common/Surroundings.js';

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

type Pixels = Omit<PixelPicture, 'close'>;
/** Silences the decoders' output. */
const SILENT = { print: () => {}, printErr: () => {} };

/** Formats of pictures by their signature. Those without `decode` are decoded by browsers alone. */
const FORMATS: readonly { name: string; beginning: RegExp; decode?: (bytes: Uint8Array) => Promise<Pixels> }[] = [
  { name: 'PNG', beginning: /^\x89PNG/, decode: decodePng },
  { name: 'JPEG', beginning: /^\xff\xd8/, decode: decodeJpeg },
  { name: 'WebP', beginning: /^RIFF....WEBP/s, decode: decodeWebp },
  { name: 'GIF', beginning: /^GIF8/ },
  { name: 'BMP', beginning: /^BM/ },
];

/** The picture is in a format that cannot be decoded here. */
export class UndecodedError extends Error {
  /** @param format its name */
  constructor(readonly format: string) {
    super(`Pictures in ${format} are not decoded here.`);
  }
}

/**
 * Decodes a picture in PNG, JPEG or WebP.
 *
 * @throws UndecodedError for GIF, BMP and four inks, also if a decoder is not installed; Error if the picture is damaged
 */
export async function decodePicture(bytes: Uint8Array): Promise<Pixels> {
  const beginning = String.fromCharCode(...bytes.subarray(0, 16));
  const format = FORMATS.find((one) => one.beginning.test(beginning));
  if (!format) throw new Error('The content is no picture.');
  if (!format.decode) throw new UndecodedError(format.name);
  try {
    return await format.decode(bytes);
  } catch (error) {
    const isMissing = ['ERR_MODULE_NOT_FOUND', 'MODULE_NOT_FOUND'].includes(
      String((error as NodeJS.ErrnoException).code),
    );
    throw isMissing ? new UndecodedError(format.name) : error;
  }
}

async function decodePng(bytes: Uint8Array): Promise<Pixels> {
  const { default: decode, init } = await import('@jsquash/png/decode.js');
  await start('png', init, '@jsquash/png/codec/pkg/squoosh_png_bg.wasm');
  return asPixels(() => decode(chunksOfPixels(bytes).buffer));
}

/** A PNG file with only the chunks that its pixels need, so that damage to others does not matter, and with an end. */
function chunksOfPixels(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts = [bytes.subarray(0, PNG_SIGNATURE.length)];
  for (let at = PNG_SIGNATURE.length; at + 12 <= bytes.length; at += 12 + view.getUint32(at)) {
    const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (['IHDR', 'PLTE', 'tRNS', 'IDAT'].includes(name)) parts.push(bytes.subarray(at, at + 12 + view.getUint32(at)));
  }
  return new Uint8Array(Buffer.concat([...parts, pngChunk('IEND')]));
}

const START_OF_SCAN = 0xda;
/** The end marker of a JPEG picture. */
const END = Buffer.of(0xff, 0xd9);
/** The number of components of a CMYK picture, which the decoder does not know. */
const INKS = 4;

async function decodeJpeg(bytes: Uint8Array): Promise<Pixels> {
  const { colours, scan } = readHeader(bytes);
  if (colours === INKS) throw new UndecodedError('CMYK JPEG');
  // The decoder would fill the missing part with grey.
  if (Buffer.from(bytes.buffer, bytes.byteOffset, bytes.length).indexOf(END, scan) === -1)
    throw new Error('JPEG: cut short');
  const { default: decode, init } = await import('@jsquash/jpeg/decode.js');
  await start('jpeg', init, '@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm');
  // Applies the EXIF orientation, as browsers do.
  return asPixels(() => decode(new Uint8Array(bytes).buffer, { preserveOrientation: true }));
}

/** The number of components of a JPEG picture, and the offset of its first scan. */
function readHeader(bytes: Uint8Array): { colours: number; scan: number } {
  let colours = 0;
  for (let at = 2; at + 3 < bytes.length && bytes[at] === 0xff; ) {
    const marker = bytes[at + 1];
    if (marker === START_OF_SCAN) return { colours, scan: at };
    const startsFrame = marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
    if (startsFrame) colours = bytes[at + 9];
    // Any number of fill bytes may precede a marker.
    at += marker === 0xff ? 1 : 2 + ((bytes[at + 2] << 8) | bytes[at + 3]);
  }
  return { colours, scan: bytes.length };
}

async function decodeWebp(bytes: Uint8Array): Promise<Pixels> {
  const { default: decode, init } = await import('@jsquash/webp/decode.js');
  await start('webp', init, '@jsquash/webp/codec/dec/webp_dec.wasm');
  return asPixels(() => decode(new Uint8Array(bytes).buffer));
}

const started = new Set<string>();

/** Starts a decoder once. It is given its compiled code, because its own `fetch` cannot read files in Node. */
async function start(
  name: string,
  init: (code: WebAssembly.Module, options: typeof SILENT) => Promise<unknown>,
  path: string,
): Promise<void> {
  if (started.has(name)) return;
  const code = await WebAssembly.compile(await readFile(createRequire(import.meta.url).resolve(path)));
  await init(code, SILENT);
  started.add(name);
}

/** Stands in for the browser's ImageData, which decoders return and Node lacks. */
class PlainImageData {
  constructor(
    readonly data: Uint8ClampedArray,
    readonly width: number,
    readonly height: number,
  ) {}
}

async function asPixels(decode: () => Promise<Pixels>): Promise<Pixels> {
  Object.assign(globalThis, { ImageData: globalThis.ImageData ?? PlainImageData });
  const { data, width, height } = await decode();
  return { data, width, height };
}
