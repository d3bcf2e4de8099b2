import { expect, test } from 'vitest';
import { smallAmong } from '../../../src/mesh/smallParts.js';

test('parts below a twentieth of the whole are small where they are many, and none are where they are few', () => {
  const sizes = [...Array(24).fill(0.49), 0.51];
  expect(smallAmong(sizes, 10)).toEqual([...Array(24).fill(true), false]);
  expect(smallAmong(sizes.slice(1), 10)).toEqual(Array(24).fill(false));
});

test('a size may stand for several parts, and a size that is no number is not small', () => {
  expect(smallAmong([0.1, 0.1, Number.NaN], 10, [20, 4, 50])).toEqual([true, true, false]);
  expect(smallAmong([0.1, 0.1], 10, [20, 3])).toEqual([false, false]);
});
