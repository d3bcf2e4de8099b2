import { describe, expect, test } from 'vitest';
import { decodeTga, tgaSize } from '../../../../../src/viewer/files/pictures/meshPictures.js';

/** A picture of 3 × 2 pixels. @param palette its colours, of 24 bits each */
const tga = (type: number, bits: number, content: readonly number[], palette: readonly number[] = []): Uint8Array => {
  const size = palette.length === 0 ? [0, 0, 0, 0, 0] : [0, 0, palette.length / 3, 0, 24];
  const header = [1, palette.length === 0 ? 0 : 1, type, ...size, 0, 0, 0, 0, 3, 0, 2, 0, bits, 0x20, 7];
  return Uint8Array.from([...header, ...palette, ...content]);
};

const grey = (values: readonly number[]): number[] => values.flatMap((value) => [value, value, value]);
const FILES: readonly [string, Uint8Array, number[]][] = [
  ['in 24 bits', tga(2, 24, grey([1, 2, 3, 4, 5, 6])), [1, 2, 3, 4, 5, 6]],
  ['of greys', tga(3, 8, [1, 2, 3, 4, 5, 6]), [1, 2, 3, 4, 5, 6]],
  ['with a palette', tga(1, 8, [0, 1, 0, 1, 0, 1], grey([10, 20])), [10, 20, 10, 20, 10, 20]],
  ['in runs', tga(10, 24, [0x83, ...grey([9]), 1, ...grey([5, 6])]), [9, 9, 9, 9, 5, 6]],
];

describe.each(FILES)('TGA %s', (_, bytes, values) => {
  test('has its pixels', async () => {
    expect(tgaSize(bytes)).toEqual([3, 2]);
    const { data, width, height } = await decodeTga(bytes);
    expect([width, height, [...data].filter((__, i) => i % 4 === 0)]).toEqual([3, 2, values]);
  });

  test('is refused where its last pixel is missing', async () => {
    await expect(decodeTga(bytes.subarray(0, bytes.length - 1))).rejects.toThrow('cut short');
  });
});
