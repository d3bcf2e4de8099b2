/** The chunks of which one comes first in the file's own. */
const FIRST_CHUNKS = [0x0001, 0x0002, 0x3d3d, 0x3d3e, 0xb000];

/** Whether bytes begin as 3DS does: with a chunk that holds all others, and one of those that come first. */
export function is3ds(bytes: Uint8Array): boolean {
  if (bytes.length < 12 || bytes[0] !== 0x4d || bytes[1] !== 0x4d) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return view.getUint32(2, true) <= bytes.length && FIRST_CHUNKS.includes(view.getUint16(6, true));
}
