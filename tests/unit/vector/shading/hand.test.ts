import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../../../src/look/vectors.js';
import { handWidth, hash01, turnOf } from '../../../../src/vector/shading/hand.js';
import { fieldLight } from '../../../../src/vector/shading/lightField.js';
import { octaves, powerOf2, roomOf } from '../../../../src/vector/shading/ruledLines.js';
import { principalAxis } from '../../../reference/engravedReference.js';
import { lineFactor, hash01 as referenceHash } from '../../../reference/engravedStrokes.js';
import { randomNumbers } from '../randomNumbers.js';

test('a line has the hash and the width of the reference', () => {
  for (let i = -300; i < 300; i++) {
    expect(hash01(i / 64)).toBe(referenceHash(i / 64));
    expect(handWidth(i / 64, 0.7)).toBeCloseTo(lineFactor(i / 64, 0.7), 12);
  }
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

test('the axis of several lights is that of the reference', () => {
  const random = randomNumbers(11);
  for (let i = 0; i < 100; i++) {
    const lamps = Array.from({ length: 2 + (i % 3) }, () => {
      const toLight: Vec3 = [random() - 0.5, random() - 0.5, random() - 0.5];
      return { toLight, luminance: 0.5 + random(), isFar: true };
    });
    const unit = lamps.map(({ toLight, luminance }) => {
      const length = Math.hypot(...toLight);
      return { toLight: toLight.map((x) => x / length) as [number, number, number], weight: luminance + 1e-6 };
    });
    const expected = principalAxis(unit);
    const { axis } = fieldLight(lamps);
    for (let k = 0; k < 3; k++) expect(Math.abs(axis[k] - expected[k])).toBeLessThan(1e-4);
  }
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
