import { deflateSync } from 'node:zlib';
import { PNG_COLOR_TYPE, PNG_SIGNATURE, pngChunk, pngHeader } from '../../src/strokes/mapFiles/pngFormat.js';

/** Levels per channel to which colours are rounded before the most frequent are chosen. */
const LEVELS = 64;
const MAX_COLOURS = 256;

interface RgbaPicture {
  width: number;
  height: number;
  data: Uint8Array;
}

/**
 * Encodes a PNG with a palette of at most 256 colours. For a drawing in a few inks it looks the same as one in full
 * colour and is much smaller.
 *
 * @param picture RGBA, opaque
 */
export function writePalettePng({ width, height, data }: RgbaPicture): Buffer {
  const step = 255 / (LEVELS - 1);
  const keyAt = (i: number): number => {
    const [red, green, blue] = [0, 1, 2].map((channel) => Math.round(data[i + channel] / step));
    return (red * LEVELS + green) * LEVELS + blue;
  };
  /** Number of pixels rounded to a colour, and the sums of their red, green and blue. */
  const sums = new Map<number, number[]>();
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
      const index = nearest.get(keyAt(4 * (y * width + x)))!;
      const at = y * (rowBytes + 1) + 1 + Math.floor((x * bits) / 8);
      rows[at] |= bits === 4 && x % 2 === 0 ? index << 4 : index;
    }
  }
  return Buffer.concat([
    PNG_SIGNATURE,
    pngHeader(width, height, bits, PNG_COLOR_TYPE.palette),
    pngChunk('PLTE', Buffer.from(palette.flat())),
    pngChunk('IDAT', deflateSync(rows, { level: 9 })),
    pngChunk('IEND'),
  ]);
}
