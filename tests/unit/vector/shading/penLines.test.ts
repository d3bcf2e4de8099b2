import { describe, expect, test } from 'vitest';
import { evenOffset, penMargin } from '../../../../src/vector/shading/penLines.js';

const rankOf = (value: number): number => (value === 0 ? 1000 : Math.log2(value & -value));

/** The positions of the lines drawn at a spacing, up to a value. */
function drawnAt(spacing: number, most = 1024): number[] {
  const lines: number[] = [];
  for (let value = 0; value <= most; value++) {
    if (penMargin(value, rankOf(value), spacing, true) > 0) lines.push(value + evenOffset(value, spacing));
  }
  return lines;
}

describe('lines of a pen', () => {
  const spacings = Array.from({ length: 60 }, (_, i) => 2 ** (1 + i / 30));

  test('are as many as the tone needs', () => {
    for (const spacing of spacings) {
      const drawn = drawnAt(spacing).length - 1;
      expect(Math.abs((drawn / 1024) * spacing - 1)).toBeLessThan(0.012);
    }
  });

  test('are evenly apart between octaves too', () => {
    for (const spacing of spacings) {
      const lines = drawnAt(spacing);
      const gaps = lines.slice(1).map((line, i) => (line - lines[i]) / spacing);
      const spread = Math.sqrt(gaps.reduce((sum, gap) => sum + (gap - 1) ** 2, 0) / gaps.length);
      expect(spread).toBeLessThan(0.2);
      // No two lines coincide, and none is missing.
      expect(Math.min(...gaps)).toBeGreaterThan(0.6);
      expect(Math.max(...gaps)).toBeLessThan(1.75);
    }
  });

  test('move without a jump as the tone changes, and are at their places at each octave', { tags: ['all'] }, () => {
    for (const value of [1, 2, 5, 7, 12, 40, 41, 58]) {
      let before = evenOffset(value, 1.999999);
      for (let octave = 1; octave < 3; octave += 1e-4) {
        const aside = evenOffset(value, 2 ** octave);
        expect(Math.abs(aside - before)).toBeLessThan(0.03);
        before = aside;
      }
      expect(evenOffset(value, 4)).toBe(0);
    }
  });
});

test('lines that do not move aside are as many, and no two neighbours end together', () => {
  for (const spacing of [1.05, 1.2, 1.5, 1.9]) {
    const drawn = Array.from({ length: 1024 }, (_, k) => penMargin(k + 1, rankOf(k + 1), spacing, false) > 0);
    expect(drawn.filter(Boolean).length / 1024).toBeCloseTo(1 / spacing, 2);
  }
  const births = Array.from({ length: 64 }, (_, k) => penMargin(2 * k + 1, 0, 2, false));
  for (let k = 1; k < 64; k++) expect(Math.abs(births[k] - births[k - 1])).toBeGreaterThan(0.2);
});
