type Colour = readonly [red: number, green: number, blue: number];

const SIGNATURE = [0x58544bab, 0xbb303220, 0x0a1a0a0d];
/** Bytes of a block of 4 × 4 pixels in UASTC. */
const BLOCK = 16;
/** Says that a block has one colour, in so many bits. */
const MODE = { code: 0x17, bits: 5 } as const;
/** Offset and length of the format descriptor, and offset of the pixels, a multiple of the size of a block. */
const DESCRIPTION = { at: 104, length: 44 } as const;
const PIXELS = 160;

/** A KTX2 picture as those of glTF files, in UASTC: blocks of one colour each, from left to right. */
export function ktx2Picture(colours: readonly Colour[]): Buffer {
  const blocks = Buffer.concat(colours.map(block));
  const words = [
    ...SIGNATURE,
    // Undefined vkFormat, type size 1; width, height, depth, layers, faces, levels; no supercompression.
    ...[0, 1, 4 * colours.length, 4, 0, 0, 1, 1, 0],
    ...[DESCRIPTION.at, DESCRIPTION.length],
    // No key/value data, and no global data of the compression.
    ...[0, 0, 0, 0, 0, 0],
    // The level: where, how long, and how long unpacked; in 64 bits each.
    ...[PIXELS, 0, blocks.length, 0, blocks.length, 0],
    // The description: UASTC (166) in sRGB, of blocks of 4 × 4, with one sample of 128 bits.
    ...[DESCRIPTION.length, 0, 0x00280002, 0x000201a6, 0x0303, BLOCK, 0, 0x007f0000, 0, 0, 0xffffffff],
  ];
  const head = Buffer.alloc(PIXELS);
  for (const [i, word] of words.entries()) head.writeUInt32LE(word, 4 * i);
  return Buffer.concat([head, blocks]);
}

/** The mode, then red, green, blue and opacity in eight bits each, from the lowest bit on. Hints for other formats stay 0. */
function block(colour: Colour): Buffer {
  const bytes = Buffer.alloc(BLOCK);
  bytes[0] = MODE.code;
  for (const [i, value] of [...colour, 255].entries()) {
    bytes[i] |= (value << MODE.bits) & 0xff;
    bytes[i + 1] |= value >> (8 - MODE.bits);
  }
  return bytes;
}
