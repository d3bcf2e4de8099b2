import { describe, expect, it } from 'vitest';
import { TonalArtMap } from '../../../../src/material/tam/TonalArtMap.js';
import { checkHatchImages } from '../../../../src/strokes/tamImages/checkHatchImages.js';

const paper = (size: number): Uint8Array => new Uint8Array(size * size).fill(255);

/** Blank paper with ink at some texels. */
const inked = (size: number, texels: Record<number, number>): Uint8Array => {
  const image = paper(size);
  for (const [texel, byte] of Object.entries(texels)) image[Number(texel)] = byte;
  return image;
};

describe('checkHatchImages', () => {
  it('measures mean ink', () => {
    const { means } = checkHatchImages({ size: 2, images: [[paper(2)], [Uint8Array.of(0, 255, 0, 255)]] });
    expect(means).toEqual([[0], [0.5]]);
  });

  it('counts texels that grow lighter with the tone, but allows 1/255', () => {
    const { toneNesting, meansOutOfOrder, consistent } = checkHatchImages({
      size: 2,
      images: [[paper(2)], [Uint8Array.of(100, 100, 100, 255)], [Uint8Array.of(102, 101, 40, 250)]],
    });
    expect(toneNesting).toEqual([[0], [0], [1]]);
    expect(meansOutOfOrder).toEqual([]);
    expect(consistent).toBe(false);
  });

  it('finds images lighter than the tone before', () => {
    const { meansOutOfOrder } = checkHatchImages({
      size: 2,
      images: [
        [paper(2), paper(1)],
        [Uint8Array.of(9, 9, 9, 9), Uint8Array.of(8)],
        [Uint8Array.of(7, 7, 7, 7), Uint8Array.of(9)],
      ],
    });
    expect(meansOutOfOrder).toEqual([{ tone: 2, level: 1 }]);
  });

  //  A coarse texel (row 0, column 0 of 4 × 4) and where the fine level (8 × 8) may keep its ink: rows and columns 7, 0, 1, 2.
  it.each([
    ['in its own block', 9, 0],
    ['one texel beside it', 18, 0],
    ['one texel beside it, around the corner of the torus', 63, 0],
    ['two texels beside it', 27, 1],
    ['two texels beside it, around the torus', 48, 1],
  ])('level nesting: ink %s', (_, texel, violations) => {
    const { levelNesting } = checkHatchImages({
      size: 8,
      images: [
        [paper(8), paper(4)],
        [inked(8, { [texel]: 127 }), inked(4, { 0: 127 })],
      ],
    });
    expect(levelNesting).toEqual([
      [0, 0],
      [0, violations],
    ]);
  });

  it('level nesting: less than half ink may be lost', () => {
    const images = [
      [paper(8), paper(4)],
      [paper(8), inked(4, { 0: 128 })],
    ];
    expect(checkHatchImages({ size: 8, images }).levelNesting).toEqual([
      [0, 0],
      [0, 0],
    ]);
  });
});

describe('TonalArtMap.fromHatchImages refuses', () => {
  const two = [[paper(2)], [paper(2)]];
  it.each<[string, unknown, RegExp]>([
    [
      'a size that is no power of two',
      { size: 3, images: [[paper(3)], [paper(3)]] },
      /size is 3, but must be a power of two/,
    ],
    ['no size', { images: two }, /size is undefined/],
    ['no images', { size: 2 }, /images must be an array with at least two tones/],
    ['one tone', { size: 2, images: [[paper(2)]] }, /at least two tones/],
    [
      'a tone without levels',
      { size: 2, images: [[paper(2)], []] },
      /images\[1\] must be an array with one image per level/,
    ],
    [
      'a flat list of images',
      { size: 2, images: [paper(2), paper(2)] },
      /images\[0\] must be an array with one image per level/,
    ],
    [
      'tones with different levels',
      { size: 2, images: [[paper(2)], [paper(2), paper(1)]] },
      /images\[1\] has 2 levels, but images\[0\] has 1/,
    ],
    [
      'more levels than the size has',
      {
        size: 1,
        images: [
          [paper(1), paper(1)],
          [paper(1), paper(1)],
        ],
      },
      /2 levels, but size 1 allows at most 1/,
    ],
    ['plain arrays', { size: 1, images: [[[255]], [[0]]] }, /images\[0\]\[0\] must be a Uint8Array/],
    ['floats', { size: 1, images: [[paper(1)], [new Float32Array(1)]] }, /images\[1\]\[0\] must be a Uint8Array/],
    [
      'RGBA bytes',
      { size: 2, images: [[paper(2)], [new Uint8Array(16)]] },
      /images\[1\]\[0\] has 16 bytes, but level 0 of size 2 needs 2 × 2 = 4/,
    ],
  ])('%s', (_, input, message) => {
    const make = () => TonalArtMap.fromHatchImages(input as Parameters<typeof TonalArtMap.fromHatchImages>[0]);
    expect(make).toThrow(message);
    expect(make).toThrow(/^TonalArtMap\.fromHatchImages: /);
  });

  it('no images that can be drawn: broken constraints are reported instead', () => {
    const map = TonalArtMap.fromHatchImages({ size: 1, images: [[Uint8Array.of(0)], [Uint8Array.of(255)]] });
    expect(map.report).toEqual({
      means: [[1], [0]],
      toneNesting: [[0], [1]],
      levelNesting: [[0], [0]],
      meansOutOfOrder: [{ tone: 1, level: 0 }],
      consistent: false,
    });
    expect(map.report).toBe(map.report);
  });
});
