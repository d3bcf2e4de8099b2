import { expect, test } from 'vitest';
import { drawnAside, spreadOfBundles } from '../../../src/strokes/strokeBundles.js';

const SHARE = 0.4;
/** The places of old rows and, with young ones between them, of all, in mean distances. */
const placesOf = (young: number, halves: readonly number[]): number[] =>
  halves.map((half) => 0.5 * half * (1 + young) + drawnAside(half, young, SHARE));

test('three rows are drawn together by the share, and the gap to the next three widens', () => {
  const places = placesOf(0, [-2, 0, 2, 4, 6, 8]);
  const distances = places.slice(1).map((place, i) => place - places[i]);
  for (const [i, distance] of [0.6, 0.6, 1.8, 0.6, 0.6].entries()) expect(distances[i]).toBeCloseTo(distance, 10);
  const of = [0.6, 0.6, 1.8];
  const spread = Math.sqrt(of.reduce((sum, distance) => sum + (distance - 1) ** 2, 0) / 3);
  expect(spreadOfBundles(SHARE)).toBeCloseTo(spread, 10);
});

test('once all young rows are there, rows lie as the old rows of the next octave do', () => {
  for (let row = -7; row <= 7; row++) expect(drawnAside(row, 1, SHARE)).toBeCloseTo(drawnAside(2 * row, 0, SHARE), 10);
});

test('no row is drawn farther aside than by the share', () => {
  let farthest = 0;
  for (let young = 0; young <= 1; young += 1 / 64)
    for (let half = 0; half < 6; half++) farthest = Math.max(farthest, Math.abs(drawnAside(half, young, SHARE)));
  expect(farthest).toBeCloseTo(SHARE, 10);
});
