import { describe, expect, it } from 'vitest';
import type { Stroke } from '../../../src/strokes/Stroke.js';
import { drawThresholdField } from '../../../src/strokes/tamImages/generateThresholds.js';

const SIZE = 32;

const line: Stroke = {
  u: 0.5,
  v: 0.5,
  layer: 0,
  across: false,
  length: 0.5,
  slope: 0,
  bow: 0,
  wave: 0,
  width: 2,
  taper: 4,
  pressure: 1,
  tone: 1,
  level: 0,
};

/** The field of one stroke that appears at ink 0.2 and has its width at 0.3; cells are half texels. */
function fieldOf(stroke: Stroke): Float32Array {
  const field = new Float32Array((2 * SIZE) ** 2).fill(Number.POSITIVE_INFINITY);
  drawThresholdField(field, SIZE, 2, stroke, 0.2, 0.1);
  return field;
}

/** Texels that {field < ink} covers in a column or row of cells. */
const extent = (field: Float32Array, ink: number, start: number, stride: number): number => {
  let cells = 0;
  for (let i = 0; i < 2 * SIZE; i++) if (field[start + i * stride] < ink) cells++;
  return cells / 2;
};
const width = (field: Float32Array, ink: number): number => extent(field, ink, SIZE, 2 * SIZE);
const length = (field: Float32Array, ink: number): number => extent(field, ink, SIZE * 2 * SIZE, 1);

describe('drawThresholdField', () => {
  it('draws nothing below the start ink of the stroke, its width at start ink + swell, and then more', () => {
    const field = fieldOf(line);
    expect(width(field, 0.2)).toBe(0);
    expect(width(field, 0.3)).toBe(2);
    // The half width grows with the root of the ink: twice as wide after four times the swell.
    expect(width(field, 0.6)).toBe(4);
  });

  it('grows from the middle to the ends', () => {
    const field = fieldOf(line);
    const lengths = [0.22, 0.25, 0.3, 0.45].map((ink) => length(field, ink));
    expect(lengths).toEqual(lengths.toSorted((a, b) => a - b));
    expect(lengths[0]).toBeLessThan(12);
    expect(lengths[3]).toBeGreaterThanOrEqual(16);
  });

  it('lowers the field only', () => {
    const field = new Float32Array((2 * SIZE) ** 2).fill(0.25);
    drawThresholdField(field, SIZE, 2, line, 0.2, 0.1);
    expect(Math.max(...field)).toBe(0.25);
    expect(Math.min(...field)).toBeLessThan(0.22);
  });

  it('is the same anywhere on the torus', () => {
    const field = fieldOf(line);
    const shifted = fieldOf({ ...line, u: 0.5 + 3 / SIZE, v: 0.5 + 13 / SIZE });
    for (let row = 0; row < 2 * SIZE; row++) {
      for (let column = 0; column < 2 * SIZE; column++) {
        const there = ((row + 26) % (2 * SIZE)) * 2 * SIZE + ((column + 6) % (2 * SIZE));
        expect(shifted[there]).toBeCloseTo(field[row * 2 * SIZE + column], 6);
      }
    }
  });

  it('draws a stroke across as the transpose of one along', () => {
    const along = fieldOf({ ...line, slope: 0.1, bow: 0.02 });
    const across = fieldOf({ ...line, slope: 0.1, bow: 0.02, across: true });
    for (let i = 0; i < along.length; i++) {
      expect(across[(i % (2 * SIZE)) * 2 * SIZE + Math.floor(i / (2 * SIZE))]).toBe(along[i]);
    }
  });

  it('draws a round dot', () => {
    const field = fieldOf({ ...line, length: 0 });
    expect([width(field, 0.3), length(field, 0.3)]).toEqual([2, 2]);
    expect([width(field, 0.6), length(field, 0.6)]).toEqual([4, 4]);
  });
});
