import { expect, test } from 'vitest';
import { SeenSurfaces } from '../../../../src/material/exposure/SeenSurfaces.js';

const WHITE = [1, 1, 1];

/** A row of samples of a surface along x. */
function addRow(surfaces: SeenSurfaces, key: string, y: number, count = 100, length = 10): void {
  const index = surfaces.indexOf(key);
  for (let i = 0; i < count; i++) surfaces.add(index, { x: (length * i) / count, y, z: 0 }, WHITE, 1);
}

test('surfaces lie side by side where many of their samples are near one another', () => {
  const surfaces = new SeenSurfaces();
  addRow(surfaces, 'first', 0);
  addRow(surfaces, 'near', 0.4);
  addRow(surfaces, 'far', 3);
  expect(surfaces.neighbours(0.5)).toEqual([new Set([1]), new Set([0]), new Set()]);
  expect(surfaces.neighbours(0)).toEqual([new Set(), new Set(), new Set()]);
});

test('a small surface on a large one is its neighbour, and two that touch in a point are none', () => {
  const surfaces = new SeenSurfaces();
  addRow(surfaces, 'large', 0, 1000, 100);
  addRow(surfaces, 'small', 0.1, 5, 0.5);
  addRow(surfaces, 'other', -3, 100);
  surfaces.add(surfaces.indexOf('other'), { x: 50, y: -0.1, z: 0 }, WHITE, 1);
  expect(surfaces.neighbours(0.5)).toEqual([new Set([1]), new Set([0]), new Set()]);
});

test('what is no number or has no weight is left out, and emptying forgets all', () => {
  const surfaces = new SeenSurfaces();
  const index = surfaces.indexOf('one');
  surfaces.add(index, { x: Number.NaN, y: 0, z: 0 }, WHITE, 1);
  surfaces.add(index, { x: 0, y: 0, z: 0 }, WHITE, 0);
  expect(surfaces.all[0]).toMatchObject({ weight: 0, count: 0 });
  surfaces.clear();
  addRow(surfaces, 'two', 0, 5000);
  expect(surfaces.all).toHaveLength(1);
  expect(surfaces.all[0]).toMatchObject({ key: 'two', count: 5000, r: 5000 });
});
