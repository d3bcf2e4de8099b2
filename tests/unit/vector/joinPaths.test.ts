import { describe, expect, test } from 'vitest';
import { DrawnOutlines } from '../../../src/vector/outlines/DrawnOutlines.js';
import { joinPaths } from '../../../src/vector/paths/joinPaths.js';
import { dashes, type LinePath, pathLength } from '../../../src/vector/paths/LinePath.js';

/** A line through places, x and y in turn. */
const line = (...xy: number[]): LinePath => ({
  points: Array.from({ length: xy.length / 2 }, (_, i) => [xy[2 * i], xy[2 * i + 1], 1, 1]).flat(),
  isClosed: false,
});
const placesOf = ({ points }: LinePath): number[] => points.filter((_, i) => i % 4 < 2);
const lengthOf = (paths: readonly LinePath[]): number => paths.reduce((sum, path) => sum + pathLength(path), 0);

describe('lines of a pen are joined', () => {
  test.each([
    ['where they go on', line(0, 0, 10, 0), line(10.05, 0, 20, 1), [0, 0, 10, 0, 10.05, 0, 20, 1]],
    ['end to end', line(0, 0, 10, 0), line(20, 0, 10, 0), [0, 0, 10, 0, 10, 0, 20, 0]],
    ['start to start', line(10, 0, 0, 0), line(10, 0, 20, 0), [0, 0, 10, 0, 10, 0, 20, 0]],
  ])('%s', (_, a, b, expected) => {
    const joined = joinPaths([a, b], 0.1);
    const reversed = Array.from(expected, (_, i) => expected[expected.length - 2 - i + 2 * (i % 2)]);
    expect([[expected], [reversed]]).toContainEqual(joined.map(placesOf));
  });

  test('into a ring where both ends of a chain meet', () => {
    const ring = Array.from({ length: 36 }, (_, i) => [10 * Math.cos(i / 6), 10 * Math.sin(i / 6)]);
    const all = [...ring.flat(), 10, 0];
    const parts = [line(...all.slice(0, 26)), line(...all.slice(48)), line(...all.slice(24, 50))];
    const joined = joinPaths(parts, 0.1);
    expect(joined).toHaveLength(1);
    expect(lengthOf(joined)).toBeCloseTo(lengthOf(parts), 1);
  });

  test.each([
    ['apart', line(0, 0, 10, 0), line(10.2, 0, 20, 0)],
    ['at a corner', line(0, 0, 10, 0), line(10, 0, 10, 10)],
    ['that turn back', line(0, 0, 10, 0), line(10, 0.05, 0, 0.05)],
  ])('but not %s', (_, a, b) => {
    expect(joinPaths([a, b], 0.1)).toEqual([a, b]);
  });

  test('the nearest ends first, each end once', () => {
    const joined = joinPaths([line(0, 0, 10, 0), line(10.08, 0, 20, 0), line(10.02, 0, 15, 0)], 0.1);
    expect(joined.map(({ points }) => points.length / 4).sort()).toEqual([2, 4]);
    expect(placesOf(joined[0])).toContain(15);
  });

  test('but a dot of a line is no ring', () => {
    const dot = line(0, 0, 0.04, 0.02, 0.08, 0);
    expect(joinPaths([dot], 0.1)).toEqual([dot]);
  });

  test('but dashes stay', () => {
    const all = dashes(line(0, 0, 100, 0), 10, 0.05);
    expect(all.length).toBeGreaterThan(5);
    expect(joinPaths(all, 0.1)).toEqual(all);
  });
});

describe('outlines are drawn once', () => {
  const add = (...paths: LinePath[]): LinePath[][] => {
    const drawn = new DrawnOutlines(0.1);
    return paths.map((path) => drawn.add(path));
  };

  test('where a line lies on another, in either direction', () => {
    const first = line(0, 0, 100, 0);
    expect(add(first, line(0, 0.03, 100, 0.03), line(100, 0, 0, 0))).toEqual([[first], [], []]);
  });

  test('where a part of it does', () => {
    const [, pieces] = add(line(20, 0, 60, 0), line(0, 0, 100, 0));
    expect(pieces.map((piece) => placesOf(piece).map(Math.round))).toEqual([
      [0, 0, 20, 0],
      [60, 0, 100, 0],
    ]);
    expect(lengthOf(pieces)).toBeCloseTo(60, 0);
  });

  test.each([
    ['crosses it', line(50, -50, 50, 50)],
    ['runs beside it', line(0, 0.3, 100, 0.3)],
    ['meets it at an angle', line(0, 0, 100, 30)],
    ['goes on', line(100, 0, 200, 0)],
  ])('and whole where it %s', (_, other) => {
    const [, pieces] = add(line(0, 0, 100, 0), other);
    expect(pieces).toEqual([other]);
  });

  test('endless lines are left as they are', () => {
    const far = line(0, 0, 1e9, 0);
    expect(add(far, far)).toEqual([[far], [far]]);
  });
});
