import type { FindFile } from './Surroundings.js';

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
