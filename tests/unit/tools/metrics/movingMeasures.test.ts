import { describe, expect, it } from 'vitest';
import { meanInk } from '../../../../tools/metrics/measures/meanInk.js';
import { normalisedFlips } from '../../../../tools/metrics/measures/normalisedFlips.js';
import {
  type LocatedImage,
  poppingIndex,
  reprojectedChange,
} from '../../../../tools/metrics/measures/reprojectedChange.js';
import { noise, picture, stripes } from './images.js';

describe('normalisedFlips', () => {
  it('is 0 for the same picture and 1 for unrelated ones, at any tone', () => {
    for (const tone of [0.2, 0.5, 0.8]) {
      const random = noise(3);
      const image = () => picture(200, 200, () => (random() < tone ? 0 : 1));
      const [a, b] = [image(), image()];
      expect(normalisedFlips(a, a)).toBe(0);
      expect(normalisedFlips(a, b)).toBeCloseTo(1, 1);
    }
  });

  it('counts two strips per stroke for shifted strokes', () => {
    // Shifted by 1 of 10 pixels, a tenth enters and a tenth leaves: 0.2 of 2 · 0.5 · 0.5.
    expect(normalisedFlips(stripes(200, 10, 0), stripes(200, 10, 0, 0.5, 1))).toBeCloseTo(0.4);
  });

  it('leaves out what is not surface in both', () => {
    const a = picture(
      4,
      1,
      (x) => [0, 1, 0, 1][x],
      (x) => x < 3,
    );
    const b = picture(
      4,
      1,
      (x) => [1, 1, 0, 0][x],
      (x) => x > 0,
    );
    expect(normalisedFlips(a, b)).toBe(0);
  });
});

describe('reprojectedChange', () => {
  const SIZE = 100;
  /** A plane of 2 × 2 units with a stripe every 0.2, seen squarely from above, `zoom` times enlarged and moved by `shift` pixels. */
  function plane(zoom: number, shift = 0, ink: (x: number, y: number) => boolean = striped): LocatedImage {
    const place = (column: number, row: number) => [
      (((column - shift + 0.5) / SIZE) * 2 - 1) / zoom,
      (((row + 0.5) / SIZE) * 2 - 1) / zoom,
    ];
    const image = picture(SIZE, SIZE, (column, row) => {
      const [x, y] = place(column, row);
      return ink(x, y) ? 0 : 1;
    });
    const places = new Float32Array(4 * SIZE * SIZE);
    for (let i = 0; i < SIZE * SIZE; i++) places.set([...place(i % SIZE, Math.floor(i / SIZE)), 0, 1], 4 * i);
    const objectToClip = [zoom, 0, 0, 0, 0, zoom, 0, 0, 0, 0, 1, 0, (2 * shift) / SIZE, 0, 0, 1];
    return { ...image, places, objectToClip };
  }
  const striped = (x: number) => Math.abs(x * 5 - Math.floor(x * 5) - 0.5) < 0.25;

  it('is near 0 for strokes that stay on the object while the camera moves', () => {
    expect(reprojectedChange(plane(1), plane(1, 3)).flips).toBe(0);
    expect(reprojectedChange(plane(1.5), plane(1.6)).flips).toBeLessThan(0.08);
  });

  it('is not fooled by strokes that stay on the screen', () => {
    const onScreen = { ...plane(1, 5), luminance: plane(1).luminance };
    expect(normalisedFlips(plane(1), onScreen)).toBe(0);
    expect(reprojectedChange(plane(1), onScreen).flips).toBeGreaterThan(0.9);
  });

  it('counts strokes that change on the object', () => {
    const moved = plane(1.6, 0, (x) => striped(x + 0.05));
    expect(reprojectedChange(plane(1.5), moved).flips).toBeGreaterThan(0.8);
  });

  it('measures the luminance of a change that makes nothing half dark', () => {
    const paler = { ...plane(1), luminance: plane(1).luminance.map((l) => Math.max(l, 0.2)) };
    const { flips, luminance } = reprojectedChange(plane(1), paler);
    expect(flips).toBe(0);
    // At the border of the picture some points have no place in the next.
    expect(luminance).toBeCloseTo(0.2 * meanInk(plane(1)), 2);
  });

  it('leaves out what is hidden in the second picture', () => {
    const hidden = plane(1, 0, (x) => !striped(x));
    for (let i = 0; i < SIZE * SIZE; i++) hidden.places[4 * i + 2] = 0.5;
    expect(reprojectedChange(plane(1), hidden).flips).toBeNaN();
  });
});

describe('poppingIndex', () => {
  it('is the largest over the median', () => {
    expect(poppingIndex([0.1, 0.1, 0.1, 0.3])).toBeCloseTo(3);
    expect(poppingIndex([0.1, 0.3, 0.2])).toBeCloseTo(1.5);
  });
});
