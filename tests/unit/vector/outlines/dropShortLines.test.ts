import { describe, expect, test } from 'vitest';
import { dropShortLines } from '../../../../src/vector/outlines/dropShortLines.js';

const LIMITS = { shortest: 10, near: 1 };

const pathOf = (places: readonly (readonly [number, number])[], isClosed = false) => ({
  path: { points: places.flatMap(([x, y]) => [x, y, 0.5, 0.5]), isClosed },
});
const along = (from: number, to: number, y = 0) =>
  pathOf([
    [from, y],
    [to, y],
  ]);

describe('pieces of outlines that a pen draws', () => {
  test('are left out where they stand alone', () => {
    const [long, short, far] = [along(0, 50), along(52, 58), along(20, 29, 3)];
    expect(dropShortLines([short, long, far], LIMITS)).toEqual([long]);
    expect(dropShortLines([short], LIMITS)).toEqual([]);
  });

  test('stay where they meet a long one, at its end or within it', () => {
    const long = along(0, 50);
    const goesOn = along(50.5, 55);
    const branches = pathOf([
      [20.3, 0.4],
      [22, 5],
    ]);
    expect(dropShortLines([goesOn, branches, long], LIMITS)).toEqual([goesOn, branches, long]);
  });

  test('stay where they are long together, and go where they are not', () => {
    const dashes = [along(0, 4), along(4.5, 8), along(8.5, 12)];
    expect(dropShortLines(dashes, LIMITS)).toEqual(dashes);
    expect(dropShortLines(dashes.slice(1), LIMITS)).toEqual([]);
  });

  test('stay where they are closed, as the outline of something small is', () => {
    const ring = pathOf(
      [
        [0, 0],
        [1, 0],
        [1, 1],
      ],
      true,
    );
    const atIt = along(1.5, 3);
    expect(dropShortLines([ring, atIt, along(-9, -4)], LIMITS)).toEqual([ring, atIt]);
  });
});
