import type { PixelPicture } from '../common/Surroundings.js';

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
