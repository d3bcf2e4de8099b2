import { ModelError } from './ModelError.js';

/** What one file may hold after unpacking; keeps a small archive from filling the memory. */
const MAX_BYTES = 1024 * 1024 * 1024;

/**
 * Unpacks gzip when the bytes begin with its magic, else gives them back as they are. Servers differ in whether they
 * declare a `.gz` file as content encoding, so the browser may have unpacked it already.
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
