/** The PNG format: chunks, checksums and row filters. */

/** The bytes that every PNG file begins with. */
export const PNG_SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);

/** The colour types of the PNG specification. */
export const PNG_COLOR_TYPE = { grey: 0, rgb: 2, palette: 3, rgba: 6 } as const;

/** The header chunk of a PNG file that is not interlaced. */
export function pngHeader(
  width: number,
  height: number,
  bitsPerSample: number,
  colorType: (typeof PNG_COLOR_TYPE)[keyof typeof PNG_COLOR_TYPE],
): Uint8Array<ArrayBuffer> {
  const header = new DataView(new ArrayBuffer(13));
  header.setUint32(0, width);
  header.setUint32(4, height);
  header.setUint8(8, bitsPerSample);
  header.setUint8(9, colorType);
  return pngChunk('IHDR', new Uint8Array(header.buffer));
}

/** A chunk of a PNG file: the length of its content, its type of four letters, the content and a checksum. */
export function pngChunk(type: string, content: Uint8Array = new Uint8Array()): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(content.length + 12);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, content.length);
  for (let i = 0; i < 4; i++) bytes[4 + i] = type.charCodeAt(i);
  bytes.set(content, 8);
  view.setUint32(content.length + 8, crc32(bytes.subarray(4, content.length + 8)));
  return bytes;
}

/** The CRC of each byte. Computed for the first chunk, since bundlers would keep a table computed at load time. */
let remainders: Uint32Array | undefined;

/** The checksum of PNG chunks, CRC-32 (ISO 3309). */
export function crc32(bytes: Uint8Array): number {
  remainders ??= Uint32Array.from({ length: 256 }, (_, byte) => {
    let crc = byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
    return crc;
  });
  let crc = 0xffffffff;
  for (const byte of bytes) crc = remainders[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** The number of samples per pixel of each colour type: grey, RGB, palette, grey with alpha, RGB with alpha. */
export const PNG_SAMPLES: Readonly<Record<number, number>> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

/** The highest number of the five row filters. */
export const LAST_PNG_FILTER = 4;

/** Undoes a filter of a row, in place. @param pixelBytes how many bytes lie between a byte and that of the pixel on the left */
export function unfilter(line: Uint8Array, above: Uint8Array, pixelBytes: number, filter: number): void {
  if (filter === 0) return;
  for (let i = 0; i < line.length; i++) {
    const left = i >= pixelBytes ? line[i - pixelBytes] : 0;
    const up = above[i];
    if (filter === 1) line[i] += left;
    else if (filter === 2) line[i] += up;
    else if (filter === 3) line[i] += (left + up) >> 1;
    else line[i] += paeth(left, up, i >= pixelBytes ? above[i - pixelBytes] : 0);
  }
}

/** The Paeth predictor: the one of left, up and corner that is nearest to left + up − corner. */
function paeth(left: number, up: number, corner: number): number {
  const [toLeft, toUp, toCorner] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)];
  return toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
}
