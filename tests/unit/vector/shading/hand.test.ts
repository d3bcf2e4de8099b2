import { describe, expect, test } from 'vitest';
import { fieldLight } from '../../../../src/vector/shading/fieldAxis.js';
import { handWidth, hash01, turnOf } from '../../../../src/vector/shading/hand.js';
import { octaves, powerOf2, roomOf } from '../../../../src/vector/shading/ruledLines.js';

test('widths of lines are 1 in the mean, differ by a quarter at most, and each by its own', () => {
  const widths = Array.from({ length: 4000 }, (_, i) => handWidth((i - 2000) / 64, 1));
  expect(widths.reduce((sum, width) => sum + width, 0) / 4000).toBeCloseTo(1, 2);
  expect(Math.min(...widths)).toBeGreaterThanOrEqual(0.75);
  expect(Math.max(...widths)).toBeLessThan(1.25);
  expect(new Set(widths).size).toBeGreaterThan(3900);
});

test('three neighbouring lines take turns at every octave', () => {
  for (let octave = -25; octave < 15; octave++) {
    for (const start of [0, 1, 300, 5000, 70_000]) {
      const turns = Array.from({ length: 30 }, (_, i) => Math.round(3 * turnOf((start + i) * 2 ** octave)) % 3);
      for (let i = 2; i < turns.length; i++) expect(new Set(turns.slice(i - 2, i + 1)).size).toBe(3);
    }
  }
});

describe('hashes of lines', () => {
  const OCTAVES = Array.from({ length: 40 }, (_, i) => i - 25);
  const STARTS = [1, 300, 5000, 70_000];
  const hashes = (start: number, octave: number) =>
    Array.from({ length: 1000 }, (_, i) => hash01((start + i) * 2 ** octave));
  /** The distance of a number from the nearest integer. */
  const fromWhole = (x: number) => Math.abs(x - Math.round(x));

  test('neighbours differ, and so do the two neighbours of a line', () => {
    let nearest = 1;
    for (const octave of OCTAVES) {
      for (const start of STARTS) {
        const found = hashes(start, octave);
        for (let i = 1; i < found.length; i++) nearest = Math.min(nearest, fromWhole(found[i]! - found[i - 1]!));
        for (let i = 2; i < found.length; i++) nearest = Math.min(nearest, fromWhole(found[i]! - found[i - 2]!));
      }
    }
    expect(nearest).toBeGreaterThan(0.15);
  });

  test('they are evenly spread', () => {
    for (const octave of OCTAVES) {
      for (const start of STARTS) {
        const sorted = hashes(start, octave).sort((a, b) => a - b);
        // The greatest difference between the share of hashes below a number and that number.
        const uneven = Math.max(...sorted.map((hash, i) => Math.abs(hash - (i + 0.5) / sorted.length)));
        expect(uneven, `from ${start} at octave ${octave}`).toBeLessThan(0.08);
      }
    }
  });

  test('lines below 0 have other hashes than lines above it', () => {
    for (let i = 1; i < 100; i++) expect(fromWhole(hash01(-i / 8) - hash01(i / 8))).toBe(0.5);
  });
});

test('lights from opposite sides do not cancel each other', () => {
  const lamp = (x: number, luminance: number) => ({ toLight: [x, 0, 0] as const, luminance, isFar: true });
  expect(fieldLight([lamp(1, 1), lamp(-1, 0.9)]).axis[0]).toBeCloseTo(1);
});

describe('rooms of lines', () => {
  test('octaves are whole at powers of two, linear between, and undone by powers', () => {
    for (let e = -20; e < 20; e++) {
      expect(octaves(2 ** e)).toBe(e);
      expect(octaves(1.5 * 2 ** e)).toBeCloseTo(e + 0.5, 12);
      expect(powerOf2(octaves(1.37 * 2 ** e))).toBeCloseTo(1.37 * 2 ** e, 9);
    }
  });

  test('all lines of a period together have all of it, at any octave', () => {
    for (let octave = -3; octave < 3; octave += 0.07) {
      const top = Math.ceil(octave);
      // One old line and one new line in each period.
      expect(roomOf(top, octave) + roomOf(top - 1, octave)).toBeCloseTo(2 ** top, 12);
      expect(roomOf(top - 2, octave)).toBe(0);
    }
  });
});
