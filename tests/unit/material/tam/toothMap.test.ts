import { expect, test } from 'vitest';
import { TOOTH_MAP_SIZE } from '../../../../src/material/tam/patternSizes.js';
import { toothMap } from '../../../../src/material/tam/toothMap.js';

/** The values as the shader reads them. */
const field = Float64Array.from(toothMap().image.data as Uint8Array, (texel) => (6 * texel) / 255 - 3);

const mean = (read: (i: number) => number): number => {
  let sum = 0;
  for (let i = 0; i < field.length; i++) sum += read(i);
  return sum / field.length;
};

test('the tooth of paper is a standard normal field', () => {
  expect(mean((i) => field[i])).toBeCloseTo(0, 2);
  expect(mean((i) => field[i] ** 2)).toBeCloseTo(1, 1.5);
  // Φ(1) − Φ(−1) = 0.683
  expect(mean((i) => Number(Math.abs(field[i]) < 1))).toBeCloseTo(0.683, 1.5);
});

test('neighbouring texels have the correlation that the shader assumes, across the border too', () => {
  const right = (i: number): number => (i % TOOTH_MAP_SIZE === TOOTH_MAP_SIZE - 1 ? i + 1 - TOOTH_MAP_SIZE : i + 1);
  const above = (i: number): number => (i + TOOTH_MAP_SIZE) % field.length;
  const variance = mean((i) => field[i] ** 2);
  for (const next of [right, above])
    expect(mean((i) => field[i] * field[next(i)]) / variance).toBeCloseTo(16 / 19, 1.5);
  let acrossBorder = 0;
  for (let i = TOOTH_MAP_SIZE - 1; i < field.length; i += TOOTH_MAP_SIZE) acrossBorder += field[i] * field[right(i)];
  expect(acrossBorder / TOOTH_MAP_SIZE).toBeGreaterThan(0.6);
});
