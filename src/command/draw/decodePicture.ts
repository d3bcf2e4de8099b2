import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { PNG_SIGNATURE, pngChunk } from '../../strokes/mapFiles/pngFormat.js';
import type { PixelPicture } from '../../viewer/files/common/Surroundings.js';

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
