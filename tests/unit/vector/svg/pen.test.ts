import { SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

/** The length of lines inside a square. */
function lengthWithin(lines: readonly number[][], left: number, top: number, size: number): number {
  let sum = 0;
  for (const points of lines) {
    for (let i = 0; i + 3 < points.length; i += 2) {
      const [x, y, dx, dy] = [points[i], points[i + 1], points[i + 2] - points[i], points[i + 3] - points[i + 1]];
      let [from, to] = [0, 1];
      for (const [start, step, low] of [
        [x, dx, left],
        [y, dy, top],
      ]) {
        if (step === 0) {
          if (start < low || start > low + size) to = -1;
          continue;
        }
        const [a, b] = [(low - start) / step, (low + size - start) / step];
        [from, to] = [Math.max(from, Math.min(a, b)), Math.min(to, Math.max(a, b))];
      }
      if (to > from) sum += (to - from) * Math.hypot(dx, dy);
    }
  }
  return sum;
}

const reachOf = ([x, y, toX, toY]: readonly number[]): number => Math.hypot(toX - x, toY - y);

const BLOCK = 13;

describe.each(cases([0.3], [0.2, 0.3, 0.5]))('a pen of %s mm', { tags: ['more'] }, (penWidth) => {
  test.each(cases([0.37], [0.1, 0.23, 0.37, 0.5, 0.66, 0.8]))(
    'draws the tone %s in every block, by lines that are evenly apart',
    async (tone) => {
      const mesh = await planeOfTone(tone);
      const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), {
        kind: 'pen',
        penWidth,
        sheet: [BLOCK * 5, BLOCK * 5],
        margin: 0,
      });
      const lines = pathsOf(svg).flatMap(ringsOf);
      for (let column = 1; column < 4; column++) {
        for (let row = 1; row < 4; row++) {
          const drawn = (lengthWithin(lines, BLOCK * column, BLOCK * row, BLOCK) * penWidth) / BLOCK ** 2;
          // A block holds a whole number of lines.
          expect(Math.abs(drawn - tone)).toBeLessThan((0.5 * penWidth) / BLOCK + 0.021);
        }
      }
      // Lines are straight, so their positions across them are compared.
      const [x, y, toX, toY] = lines.reduce((longest, line) => (reachOf(line) > reachOf(longest) ? line : longest));
      const length = Math.hypot(toX - x, toY - y);
      const places = lines.map(([px, py]) => (px * (toY - y) - py * (toX - x)) / length).sort((a, b) => a - b);
      const gaps = places.slice(1).map((place, i) => ((place - places[i]) * tone) / penWidth);
      const spread = Math.sqrt(gaps.reduce((sum, gap) => sum + (gap - 1) ** 2, 0) / gaps.length);
      expect(spread).toBeLessThan(0.2);
    },
  );
});

test.each([undefined, 0.4, 3])('every path of a pen is one line, none shorter than asked: %s', async (shortest) => {
  const mesh = await hatchedMesh(new SphereGeometry(1, 48, 32));
  const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0.3, 0.4, 1), {
    kind: 'pen',
    penWidth: 0.5,
    ...{ sheet: [90, 90], shortest },
  });
  const paths = pathsOf(svg);
  expect(paths.length).toBeGreaterThan(40);
  for (const data of paths) {
    expect(data.match(/M/g)?.length).toBe(1);
    const [points] = ringsOf(data);
    let length = 0;
    for (let i = 2; i < points.length; i += 2)
      length += Math.hypot(points[i] - points[i - 2], points[i + 1] - points[i - 1]);
    expect(length).toBeGreaterThan((shortest ?? 1) - 0.04);
  }
});

test.each([
  ['a solid dark is drawn once', 0.97, ['lines']],
  ['a half tone is drawn by two families', 0.75, ['lines', 'crossing']],
])('%s', async (_, tone, layers) => {
  const mesh = await planeOfTone(tone, { crossFrom: 0.3 });
  const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), { kind: 'pen', sheet: [40, 40], margin: 0 });
  expect(['lines', 'crossing'].filter((layer) => pathsOf(svg, layer).length > 0)).toEqual(layers);
});

test('pens pass over no place of a drawing more often than asked', async () => {
  const drawnWith = async (maxPasses: number): Promise<number> => {
    const mesh = await hatchedMesh(new SphereGeometry(1, 48, 32), { material: { technique: 'pen', crossFrom: 0.2 } });
    const { drawn } = await drawSVG(sceneOf(mesh), cameraAt(0.3, 0.4, 1), {
      ...{ kind: 'pen', lines: 'canvas', sheet: [60, 60], maxPasses },
    });
    return drawn;
  };
  const [once, twice, thrice] = [await drawnWith(1), await drawnWith(2), await drawnWith(3)];
  expect(once).toBeLessThan(0.9 * twice);
  expect(twice).toBeLessThan(thrice);
});
