import type { FindFile } from './Surroundings.js';

/** A file that was dropped or picked, or the file of a built-in model. */
export interface ModelFile {
  name: string;
  content: Blob;
  /** The format as a file extension, used if the content does not tell it; by default that of the name. */
  format?: string | undefined;
}

/** The maximum size of all files of a model together, also unpacked, in bytes. Reading holds several copies of a model in memory. */
export const MAX_BYTES = 512 * 2 ** 20;

/** The part of a path or URI after its last slash. */
export function baseName(path: string): string {
  return path.split(/[\\/]/).pop() ?? path;
}

/** The lower-case extension, without the dot. */
export function extensionOf(name: string): string | undefined {
  return /\.([a-z0-9]+)$/i.exec(name)?.[1]?.toLowerCase();
}

/** The name of a gzipped file once it is unpacked. */
export function withoutGz(name: string): string {
  return name.replace(/\.gz$/i, '');
}

/** Reads a data URI, or a file that was dropped along with the model. Nothing is fetched. */
export async function readUri(uri: string, findFile: FindFile): Promise<Uint8Array | undefined> {
  return uri.startsWith('data:') ? dataOf(uri) : findFile(uri);
}

/**
 * Decodes a data URI; undefined if it is damaged. Does not use `fetch`, which a Content-Security-Policy without `connect-src data:`
 * forbids.
 */
export function dataOf(uri: string): Uint8Array<ArrayBuffer> | undefined {
  const comma = uri.indexOf(',');
  if (comma === -1) return undefined;
  const isBase64 = /;\s*base64\s*$/i.test(uri.slice(0, comma));
  try {
    if (!isBase64) return unescapeBytes(uri.slice(comma + 1));
    const content = uri.slice(comma + 1);
    const text = atob(content.includes('%') ? decodeURIComponent(content) : content);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
    return bytes;
  } catch {
    return undefined;
  }
}

/** Encodes text as bytes, and decodes %XX in it. */
function unescapeBytes(text: string): Uint8Array<ArrayBuffer> {
  const plain = new TextEncoder().encode(text);
  const bytes = new Uint8Array(plain.length);
  let length = 0;
  for (let i = 0; i < plain.length; i++) {
    const code = plain[i] === PERCENT ? hexByte(plain, i + 1) : Number.NaN;
    bytes[length++] = Number.isNaN(code) ? plain[i] : code;
    if (!Number.isNaN(code)) i += 2;
  }
  return bytes.slice(0, length);
}

const PERCENT = 0x25;

/** The value of two hexadecimal digits, or NaN. */
function hexByte(bytes: Uint8Array, at: number): number {
  const digits = String.fromCharCode(...bytes.subarray(at, at + 2));
  return /^[0-9a-f]{2}$/i.test(digits) ? Number.parseInt(digits, 16) : Number.NaN;
}

const SECONDS = 20;
const SECONDS_PER_MEGABYTE = 2;

/**
 * The seconds after which a reader without progress is stopped. Some parsers report nothing before they finish, so larger files get longer:
 * text is read at a few megabytes per second, and at a tenth of that on a slow machine that draws meanwhile.
 *
 * @param bytes of the unpacked input
 */
export function readingTime(bytes: number): number {
  return SECONDS + (SECONDS_PER_MEGABYTE * bytes) / 2 ** 20;
}
