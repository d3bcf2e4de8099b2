import type { Pixels } from './Pixels.js';
import { PNG_COLOR_TYPE, PNG_SIGNATURE, pngChunk, pngHeader } from './pngChunks.js';

/**
 * Encodes bytes as a PNG file with one or three channels of eight bits. No colour profile is written, so readers do not
 * convert the values.
 */
export async function encodePng({ width, height, channels, data }: Pixels): Promise<Uint8Array> {
  const stride = width * channels;
  const rows = new Uint8Array(height * (stride + 1));
  // The byte before each row is the number of its filter; 0 means none.
  for (let row = 0; row < height; row++) {
    rows.set(data.subarray(row * stride, (row + 1) * stride), row * (stride + 1) + 1);
  }
  return concatenate([
    PNG_SIGNATURE,
    pngHeader(width, height, 8, channels === 1 ? PNG_COLOR_TYPE.grey : PNG_COLOR_TYPE.rgb),
    pngChunk('IDAT', await deflate(rows)),
    pngChunk('IEND'),
  ]);
}

async function deflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function concatenate(parts: readonly Uint8Array[]): Uint8Array {
  const result = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    result.set(part, at);
    at += part.length;
  }
  return result;
}
