import { describe, expect, it } from 'vitest';
import type { HatchImages } from '../../../../src/strokes/tamImages/HatchImages.js';
import { deriveThresholds as derive } from '../../../../src/strokes/tamImages/thresholds.js';
import { finish, hatchImages } from '../draw.js';

const deriveThresholds = (images: HatchImages) => finish(derive(images));

/** Two tones, one level: paper, and ink in one row of the image. */
function oneRow(size: number, row: number): HatchImages {
  const ink = new Uint8Array(size * size).fill(255).fill(0, row * size, (row + 1) * size);
  return { size, images: [[new Uint8Array(size * size).fill(255)], [ink]] };
}

describe('deriveThresholds', () => {
  it('is uniformly distributed on every level', () => {
    for (const { thresholds } of deriveThresholds(hatchImages({ size: 64 }))) {
      const ranks = thresholds.toSorted().map((threshold) => threshold * thresholds.length - 0.5);
      ranks.forEach((rank, i) => {
        expect(Math.abs(rank - i)).toBeLessThan(1e-2);
      });
    }
  });

  it('turns the darkest texels to ink first', () => {
    const { images, size } = hatchImages({ size: 128 });
    const [{ thresholds }] = deriveThresholds({ images, size });
    for (const tone of [2, 4, 6]) {
      const image = images[tone][0];
      const ink = image.reduce((sum, byte) => sum + 1 - byte / 255, 0) / image.length;
      let alike = 0;
      for (let i = 0; i < image.length; i++) if (thresholds[i] < ink === image[i] < 128) alike++;
      expect(alike / image.length).toBeGreaterThan(0.83);
    }
  });

  it('widens a line evenly to both sides, and across the border of the tile', () => {
    const size = 16;
    const [{ thresholds }] = deriveThresholds(oneRow(size, 0));
    const means = Array.from({ length: size }, (_, row) => {
      const texels = thresholds.subarray(row * size, (row + 1) * size);
      return texels.reduce((a, b) => a + b) / size;
    });
    const order = [...means.keys()].toSorted((a, b) => means[a] - means[b]);
    const distances = order.map((row) => Math.min(row, size - row));
    expect(distances).toEqual(distances.toSorted((a, b) => a - b));
  });

  it('accepts a single texel', () => {
    const images = [[new Uint8Array([255])], [new Uint8Array([0])]];
    expect([...deriveThresholds({ size: 1, images })[0].thresholds]).toEqual([0.5]);
  });

  it('leaves the images unchanged', () => {
    const { images } = oneRow(8, 3);
    const before = structuredClone(images);
    deriveThresholds({ size: 8, images });
    expect(images).toEqual(before);
  });
});
