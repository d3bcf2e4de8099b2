import { expect, test } from 'vitest';
import { roomLeft } from '../roomLeft.mjs';

test.each([
  ['toBeLessThan', 0.001, 0.002, 0.5],
  ['toBeLessThan', 0.002, 0.002, 0],
  ['toBeLessThan', 0.003, 0.002, 0],
  ['toBeGreaterThan', 0.995, 0.99, 0.5],
  ['toBeGreaterThan', 3, 2, 0.5],
  ['toBeGreaterThan', 9, 2, 1],
  ['toBeCloseTo', 1.0025, 1, 0.5],
  ['toBeLessThanOrEqual', 0, 0, 1],
])('%s: %f beside the limit %f has %f of its room left', (matcher, value, limit, expected) => {
  expect(roomLeft({ key: '', matcher, value, limit })).toBeCloseTo(expected, 6);
});
