/** The chunks of a picture that hold its pixels; all others describe the file. */
const PIXELS = ['ALPH', 'VP8 ', 'VP8L'];
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;
/** Flags of `VP8X` and `ANMF`, by the container's specification. */
const IS_ANIMATED = 0x02;
const REPLACES_WHAT_LIES_BELOW = 0x02;

/**
 * Joins WebP pictures of one size to one that moves, for ever.
 *
 * @param pictures files with one opaque picture each
 * @param milliseconds how long each is shown
 */
export function animatedWebp(
  pictures: readonly Buffer[],
  { width, height, milliseconds }: { width: number; height: number; milliseconds: number },
): Buffer {
  const size = Buffer.concat([uint24(width - 1), uint24(height - 1)]);
  const loops = Buffer.alloc(6);
  const frames = pictures.map((picture) =>
    chunk(
      'ANMF',
      Buffer.concat([
        ...[uint24(0), uint24(0), size, uint24(milliseconds), Buffer.from([REPLACES_WHAT_LIES_BELOW])],
        ...pixelsOf(picture),
      ]),
    ),
  );
  const body = Buffer.concat([
    Buffer.from('WEBP'),
    chunk('VP8X', Buffer.concat([Buffer.from([IS_ANIMATED, 0, 0, 0]), size])),
    chunk('ANIM', loops),
    ...frames,
  ]);
  return chunk('RIFF', body);
}

/** The chunks of a file that hold pixels, whole. */
function pixelsOf(picture: Buffer): Buffer[] {
  if (picture.toString('latin1', 0, 4) !== 'RIFF' || picture.toString('latin1', 8, 12) !== 'WEBP')
    throw new Error('animatedWebp: a picture is not a WebP file.');
  const chunks: Buffer[] = [];
  for (let at = HEADER_BYTES; at < picture.length; ) {
    const length = CHUNK_HEADER_BYTES + picture.readUInt32LE(at + 4);
    const end = at + length + (length % 2);
    if (PIXELS.includes(picture.toString('latin1', at, at + 4))) chunks.push(picture.subarray(at, end));
    at = end;
  }
  return chunks;
}

/** A chunk is padded to an even length, which its header does not count. */
function chunk(name: string, content: Buffer): Buffer {
  const header = Buffer.alloc(CHUNK_HEADER_BYTES);
  header.write(name, 'latin1');
  header.writeUInt32LE(content.length, 4);
  return Buffer.concat([header, content, Buffer.alloc(content.length % 2)]);
}

function uint24(value: number): Buffer {
  const bytes = Buffer.alloc(3);
  bytes.writeUIntLE(value, 0, 3);
  return bytes;
}
