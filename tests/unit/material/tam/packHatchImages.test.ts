import { describe, expect, it } from 'vitest';
import {
  packedLayerCount,
  packHatchImages,
  unpackHatchImage,
} from '../../../../src/material/tam/TonalArtMapTexture.js';

/** Two texels by two and one texel; the byte encodes tone, level and texel. */
const images = (tones: number): number[][][] =>
  Array.from({ length: tones }, (_, tone) => [
    [10 * tone, 10 * tone + 1, 10 * tone + 2, 10 * tone + 3],
    [10 * tone + 9],
  ]);

describe('packHatchImages', () => {
  it.each([
    [2, 1],
    [4, 1],
    [5, 2],
    [7, 2],
    [8, 3],
    [16, 5],
  ])('packs %i tones into %i layers', (tones, layers) => {
    expect(packedLayerCount(tones)).toBe(layers);
  });

  it('puts tones 3l to 3l + 3 into layer l and repeats the last', () => {
    const [fine, coarse] = packHatchImages(2, images(5));
    expect([fine.size, coarse.size]).toEqual([2, 1]);
    // Layer 0: tones 0 1 2 3. Layer 1: tones 3 4 4 4.
    expect([...fine.data]).toEqual(
      [
        [0, 10, 20, 30],
        [1, 11, 21, 31],
        [2, 12, 22, 32],
        [3, 13, 23, 33],
        [30, 40, 40, 40],
        [31, 41, 41, 41],
        [32, 42, 42, 42],
        [33, 43, 43, 43],
      ].flat(),
    );
    expect([...coarse.data]).toEqual([9, 19, 29, 39, 39, 49, 49, 49]);
  });

  it('has both neighbours of every tone in one layer, and unpacks each image', () => {
    for (let tones = 2; tones <= 16; tones++) {
      const packed = packHatchImages(2, images(tones));
      for (let tone = 0; tone < tones; tone++) {
        expect([...unpackHatchImage(packed[0], tone)]).toEqual(images(tones)[tone][0]);
        expect([...unpackHatchImage(packed[1], tone)]).toEqual(images(tones)[tone][1]);
      }
      for (let tone = 0; tone + 1 < tones; tone++) {
        const layer = Math.floor(tone / 3);
        const texel = packed[1].data.subarray(4 * layer, 4 * layer + 4);
        expect([texel[tone - 3 * layer], texel[tone + 1 - 3 * layer]]).toEqual([10 * tone + 9, 10 * tone + 19]);
      }
    }
  });
});
