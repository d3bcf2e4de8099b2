/** The chunks of which one comes first within the main chunk. */
const FIRST_CHUNKS = [0x0001, 0x0002, 0x3d3d, 0x3d3e, 0xb000];

/** Whether bytes begin as a 3DS file does: with the main chunk, which holds all others, and one that can be the first in it. */
export function is3ds(bytes: Uint8Array): boolean {
  if (bytes.length < 12 || bytes[0] !== 0x4d || bytes[1] !== 0x4d) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return view.getUint32(2, true) <= bytes.length && FIRST_CHUNKS.includes(view.getUint16(6, true));
}
