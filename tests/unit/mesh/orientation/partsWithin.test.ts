import { expect, test } from 'vitest';
import type { Part } from '../../../../src/mesh/orientation/measureParts.js';
import { partsWithin } from '../../../../src/mesh/orientation/partsWithin.js';
import { random } from '../../../../src/strokes/random.js';

let reads = 0;

/** A part whose bounding box counts how often it is read. */
const partOf = (least: number[], most: number[]): Part => ({
  isClosed: true,
  get least() {
    reads++;
    return least;
  },
  most,
  volume: 1,
  doubleArea: 1,
  samples: [],
});

const next = random(7);
const boxes = Array.from({ length: 2000 }, (_, i) => {
  const size = i % 200 === 0 ? 0.5 : 0.02;
  // Places on a grid, so that sides of boxes lie in one plane.
  const least = [0, 1, 2].map(() => Math.floor(next() * 50) / 50);
  return { least, most: least.map((from) => from + size * Math.ceil(2 * next())) };
});
const parts = boxes.map(({ least, most }) => partOf(least, most));

test('finds the parts whose bounding boxes lie within that of a part, and not the part itself', () => {
  const within = partsWithin(parts);
  let found = 0;
  for (const [outer, box] of boxes.entries()) {
    const inside = [...boxes.keys()].filter(
      (i) =>
        i !== outer && [0, 1, 2].every((k) => boxes[i].least[k] >= box.least[k] && boxes[i].most[k] <= box.most[k]),
    );
    expect(within(outer).sort((a, b) => a - b)).toEqual(inside);
    found += inside.length;
  }
  expect(found).toBeGreaterThan(100);
});

test('compares a part with few of the others', () => {
  const within = partsWithin(parts);
  reads = 0;
  for (const i of parts.keys()) within(i);
  expect(reads).toBeLessThan(0.5 * parts.length ** 2);
});
