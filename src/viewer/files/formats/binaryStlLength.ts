const HEADER_BYTES = 84;
const TRIANGLE_BYTES = 50;

/** The length of a binary STL file according to its triangle count; undefined if the bytes cannot be such a file. */
export function binaryStlLength(bytes: Uint8Array): number | undefined {
  if (bytes.length < HEADER_BYTES) return undefined;
  const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  const length = HEADER_BYTES + count * TRIANGLE_BYTES;
  return count > 0 && length <= bytes.length ? length : undefined;
}
