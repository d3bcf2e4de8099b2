import { describe, expect, test } from 'vitest';
import { handWidth, lotOf } from '../../../src/engraving/hand.js';
import { fieldLight } from '../../../src/engraving/lightField.js';
import { octaves, powerOf2, roomOf } from '../../../src/engraving/ruledLines.js';
import type { Vec3 } from '../../../src/engraving/vectors.js';
import { principalAxis } from '../../reference/engravedReference.js';
import { lineFactor, lotOf as referenceLot } from '../../reference/engravedStrokes.js';
import { randomNumbers } from '../vector/randomNumbers.js';

test('a line has the lot and the width of the reference', () => {
  for (let i = -300; i < 300; i++) {
    expect(lotOf(i / 64)).toBe(referenceLot(i / 64));
    expect(handWidth(i / 64, 0.7)).toBeCloseTo(lineFactor(i / 64, 0.7), 12);
  }
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
      // One old line and one young in each period.
      expect(roomOf(top, octave) + roomOf(top - 1, octave)).toBeCloseTo(2 ** top, 12);
      expect(roomOf(top - 2, octave)).toBe(0);
    }
  });
});
