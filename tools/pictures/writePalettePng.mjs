import { crc32, deflateSync } from 'node:zlib';

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
/** Levels per channel to which colours are rounded before the most frequent are chosen. */
const LEVELS = 64;
const MAX_COLOURS = 256;

/**
 * Encodes a PNG with a palette of at most 256 colours. For a drawing in a few inks it looks the same as one in full
 * colour and is much smaller.
 *
 * @param {{ width: number, height: number, data: Uint8Array }} picture RGBA, opaque
 * @returns {Buffer} the file
 */
export function writePalettePng({ width, height, data }) {
  const step = 255 / (LEVELS - 1);
  const keyAt = (i) => {
    const [red, green, blue] = [0, 1, 2].map((channel) => Math.round(data[i + channel] / step));
    return (red * LEVELS + green) * LEVELS + blue;
  };
  const sums = new Map();
  for (let i = 0; i < data.length; i += 4) {
    const key = keyAt(i);
    const sum = sums.get(key) ?? [0, 0, 0, 0];
    sum[0]++;
    for (let channel = 0; channel < 3; channel++) sum[channel + 1] += data[i + channel];
    sums.set(key, sum);
  }
  // Each colour of the palette is the mean of the pixels rounded to it, so that flat areas keep their colour.
  const palette = [...sums.values()]
    .sort((a, b) => b[0] - a[0])
    .slice(0, MAX_COLOURS)
    .map(([count, ...rgb]) => rgb.map((sum) => Math.round(sum / count)));
  const nearest = new Map(
    [...sums].map(([key, [count, ...rgb]]) => {
      const distances = palette.map((colour) => Math.hypot(...colour.map((value, k) => value - rgb[k] / count)));
      return [key, distances.indexOf(Math.min(...distances))];
    }),
  );

  const bits = palette.length <= 16 ? 4 : 8;
  const rowBytes = Math.ceil((width * bits) / 8);
  const rows = Buffer.alloc((rowBytes + 1) * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const index = nearest.get(keyAt(4 * (y * width + x)));
      const at = y * (rowBytes + 1) + 1 + Math.floor((x * bits) / 8);
      rows[at] |= bits === 4 && x % 2 === 0 ? index << 4 : index;
    }
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([bits, 3, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from(SIGNATURE),
    chunk('IHDR', header),
    chunk('PLTE', Buffer.from(palette.flat())),
    chunk('IDAT', deflateSync(rows, { level: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

function chunk(type, content) {
  const body = Buffer.concat([Buffer.from(type), content]);
  const frame = Buffer.alloc(body.length + 8);
  frame.writeUInt32BE(content.length, 0);
  body.copy(frame, 4);
  frame.writeUInt32BE(crc32(body), body.length + 4);
  return frame;
}
