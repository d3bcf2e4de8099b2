import { ModelError } from './ModelError.js';

/** Largest size after unpacking, so that a small archive cannot fill the memory. */
const MAX_BYTES = 1024 * 1024 * 1024;

/**
 * Unpacks bytes that begin with the gzip magic number, and returns others as they are. Some servers declare a `.gz`
 * file as content encoding, and the browser has unpacked it already.
 */
export async function gunzip(bytes: Uint8Array, name: string): Promise<Uint8Array> {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
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
    if (length > MAX_BYTES)
      throw new ModelError(`${name} unpacks to more than a gigabyte, which is too much for a page.`);
  }
  const whole = new Uint8Array(length);
  let offset = 0;
  for (const chunk of chunks) {
    whole.set(chunk, offset);
    offset += chunk.length;
  }
  return whole;
}
