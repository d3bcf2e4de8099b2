import { ModelError } from '../common/ModelError.js';

/** The unpacked size that is allowed for every archive, however small. */
const SMALL_BYTES = 64 * 1024 * 1024;
/** The maximum compression ratio. Models shrink to a tenth, the most regular ones to a fiftieth; a higher ratio is a decompression bomb. */
const MAX_RATIO = 64;

/**
 * Unpacks bytes that begin with the gzip magic number, and returns others as they are. Some servers declare a `.gz` file as content
 * encoding, and the browser has unpacked it already.
 *
 * @param maxBytes after unpacking
 * @throws ModelError if they are damaged, or as soon as the unpacked size exceeds the limits
 */
export async function gunzip(bytes: Uint8Array, name: string, maxBytes: number): Promise<Uint8Array> {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  const limit = Math.min(maxBytes, Math.max(SMALL_BYTES, MAX_RATIO * bytes.length));
  const chunks: Uint8Array[] = [];
  let length = 0;
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream('gzip'));
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw new ModelError(`${name} could not be unpacked: it is damaged or was cut short.`);
    });
    if (done) break;
    chunks.push(value);
    length += value.length;
    if (length > limit) {
      await reader.cancel().catch(() => {});
      throw new ModelError(
        `${name} unpacks to more than ${Math.round(limit / 2 ** 20)} MB, which is too much for its size.`,
      );
    }
  }
  const whole = new Uint8Array(length);
  let offset = 0;
  for (const chunk of chunks) {
    whole.set(chunk, offset);
    offset += chunk.length;
  }
  return whole;
}
