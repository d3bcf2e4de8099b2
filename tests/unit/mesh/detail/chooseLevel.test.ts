import fc from 'fast-check';
import { expect, test } from 'vitest';
import { chooseLevel, MOST_PIXELS } from '../../../../src/mesh/detail/chooseLevel.js';

const LEVELS = [0, 0.001, 0.002, 0.004, 0.008].map((error) => ({ error }));
/** A level that any other is finer than, as if nothing was drawn before. */
const COARSEST = LEVELS.length;

const size = (max: number) => fc.double({ min: 1, max, noNaN: true });

test('the simplest level within a third of a pixel is drawn', () => {
  expect(chooseLevel(LEVELS, 1e6, COARSEST)).toBe(0);
  expect(chooseLevel(LEVELS, MOST_PIXELS / 0.001, COARSEST)).toBe(1);
  expect(chooseLevel(LEVELS, 1.01 * (MOST_PIXELS / 0.001), COARSEST)).toBe(0);
  expect(chooseLevel(LEVELS, 0.99 * (MOST_PIXELS / 0.004), COARSEST)).toBe(3);
  expect(chooseLevel(LEVELS, 1, COARSEST)).toBe(4);
});

test('a nearer mesh never has a simpler level, whatever the level before', () => {
  fc.assert(
    fc.property(size(1000), size(2), fc.nat(4), (size, factor, before) => {
      expect(chooseLevel(LEVELS, size * factor, before)).toBeLessThanOrEqual(chooseLevel(LEVELS, size, before));
    }),
    { seed: 31 },
  );
});

test('a level is never off by more than a third of a pixel', () => {
  fc.assert(
    fc.property(size(1e5), fc.nat(4), (size, before) => {
      expect(LEVELS[chooseLevel(LEVELS, size, before)].error * size).toBeLessThanOrEqual(MOST_PIXELS);
    }),
    { seed: 31 },
  );
});

test('levels do not flicker while the distance varies around the boundary of two levels', () => {
  const border = MOST_PIXELS / 0.002;
  let level = chooseLevel(LEVELS, 1.05 * border, 0);
  const drawn = [];
  for (let i = 0; i < 20; i++) {
    level = chooseLevel(LEVELS, border * (i % 2 ? 0.95 : 1.05), level);
    drawn.push(level);
  }
  expect(new Set(drawn).size).toBe(1);
  // It gets simpler all the same once the view is far enough.
  expect(chooseLevel(LEVELS, 0.75 * border, level)).toBe(2);
});
