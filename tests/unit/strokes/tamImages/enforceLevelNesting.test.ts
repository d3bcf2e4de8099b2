import { describe, expect, it } from 'vitest';
import { random } from '../../../../src/strokes/random.js';
import { checkHatchImages } from '../../../../src/strokes/tamImages/checkHatchImages.js';
import { enforceLevelNesting } from '../../../../src/strokes/tamImages/generateHatchImages.js';

/** Images nested in tone whose levels are independent. */
function unrelatedLevels(): { size: number; images: Uint8Array[][] } {
  const next = random(5);
  const images = [[16, 8, 4].map((size) => new Uint8Array(size * size).fill(255))];
  for (let tone = 1; tone < 4; tone++) {
    images.push(images[tone - 1].map((image) => image.map((byte) => (next() < 0.06 ? 10 : byte))));
  }
  return { size: 16, images };
}

describe('enforceLevelNesting', () => {
  it('repairs the nesting of levels without breaking that of tones', () => {
    const map = unrelatedLevels();
    const before = structuredClone(map.images);
    expect(checkHatchImages(map).levelNesting.flat().some(Boolean)).toBe(true);
    enforceLevelNesting(map);
    const { toneNesting, levelNesting } = checkHatchImages(map);
    expect([...toneNesting, ...levelNesting].flat().every((count) => count === 0)).toBe(true);
    map.images.forEach((row, tone) => {
      expect(row[2]).toEqual(before[tone][2]);
      row.forEach((image, level) => {
        expect(image.every((byte, i) => byte <= before[tone][level][i])).toBe(true);
      });
    });
  });

  it('leaves nested images unchanged', () => {
    const map = unrelatedLevels();
    enforceLevelNesting(map);
    const before = structuredClone(map.images);
    enforceLevelNesting(map);
    expect(map.images).toEqual(before);
  });
});
