/** The chunks that can come first within the main chunk. */
const FIRST_CHUNKS = [0x0001, 0x0002, 0x3d3d, 0x3d3e, 0xb000];

/** Whether bytes begin with the main chunk of a 3DS file and one of the possible first chunks. */
export function is3ds(bytes: Uint8Array): boolean {
  if (bytes.length < 12 || bytes[0] !== 0x4d || bytes[1] !== 0x4d) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return view.getUint32(2, true) <= bytes.length && FIRST_CHUNKS.includes(view.getUint16(6, true));
}
