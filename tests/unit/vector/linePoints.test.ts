import { expect, test } from 'vitest';
import { LinePoints } from '../../../src/vector/streamlines/LinePoints.js';
import type { Sheet } from '../../../src/vector/streamlines/Sheet.js';
import { randomNumbers } from './randomNumbers.js';

/** A sheet without outlines. */
const blank = { width: 60, height: 40, isParted: () => false } as unknown as Sheet;
const [REACH, ALONG] = [5.1, 0.2];

/** Lines of two points each, in all directions, some of them beyond the edges of the sheet. */
function scattered(count: number): LinePoints {
  const points = new LinePoints(blank, 1);
  const random = randomNumbers(7);
  for (let line = 0; line < count; line++) {
    const angle = line % 8 === 0 ? (Math.PI / 4) * (line / 8) : 2 * Math.PI * random();
    const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
    const [x, y] = [64 * random() - 2, 44 * random() - 2];
    for (const step of [0, 0.25]) points.push(x + step * ux, y + step * uy, ux, uy, 1 + random());
    points.endLine(0);
  }
  return points;
}

/** The nearest parallel lines to the left and to the right of a point, from all points. */
function gapsOf(points: LinePoints, i: number): [left: number, right: number] {
  const gaps: [number, number] = [Infinity, Infinity];
  const { x, y, ux, uy, line } = points;
  for (let j = 0; j < points.count; j++) {
    const [dx, dy] = [x[j] - x[i], y[j] - y[i]];
    const side = dy * ux[i] - dx * uy[i];
    const isParallel = Math.abs(ux[j] * ux[i] + uy[j] * uy[i]) >= 0.8;
    const isBeside = Math.abs(dx * ux[i] + dy * uy[i]) <= ALONG && Math.abs(side) <= REACH && Math.abs(side) >= 0.05;
    if (line[j] === line[i] || !isParallel || !isBeside) continue;
    const which = side > 0 ? 0 : 1;
    gaps[which] = Math.min(gaps[which], Math.abs(side));
  }
  return gaps;
}

test('the nearest lines beside a point are found in all directions, and beyond the edges of the sheet', () => {
  const points = scattered(3000);
  let found = 0;
  for (let i = 0; i < points.count; i++) {
    points.gapsAt(i, REACH, ALONG);
    const gaps = gapsOf(points, i);
    expect([points.left, points.right]).toEqual(gaps);
    found += gaps.filter((gap) => gap < Infinity).length;
  }
  expect(found).toBeGreaterThan(points.count);
});
