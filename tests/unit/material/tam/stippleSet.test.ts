import { expect, test } from 'vitest';
import { STIPPLE_PERIOD as PERIOD, STIPPLE_MAP_SIZE } from '../../../../src/material/tam/patternSizes.js';
import { pointsOf, readStippleSet, stippleMap } from '../../../../src/material/tam/stippleMap.js';

const { quarters, births } = readStippleSet();
const points = pointsOf(quarters);
const texels = stippleMap().image.data as Uint8Array;

/** The mean distance to the nearest neighbour on a torus, relative to that of the densest lattice of as many points. */
function evenness(places: readonly (readonly [number, number])[], side: number): number {
  const around = (a: number, b: number): number => {
    const away = Math.abs(a - b);
    return Math.min(away, side - away);
  };
  let sum = 0;
  for (const one of places) {
    let nearest = Infinity;
    for (const other of places) {
      if (other !== one) nearest = Math.min(nearest, Math.hypot(around(one[0], other[0]), around(one[1], other[1])));
    }
    sum += nearest;
  }
  return sum / places.length / Math.sqrt((2 / Math.sqrt(3)) * (side ** 2 / places.length));
}

test('the set at half the size contains every point of the set', () => {
  for (let cell = 0; cell < PERIOD ** 2; cell++) {
    const doubled = [0, 1].map((axis) => {
      const place = (axis === 0 ? cell % PERIOD : Math.floor(cell / PERIOD)) + points[2 * cell + axis];
      return 2 * place;
    });
    const child = doubled.map((place) => Math.floor(place) % PERIOD);
    for (const axis of [0, 1]) {
      expect(doubled[axis] % 1).toBeCloseTo(points[2 * (child[1] * PERIOD + child[0]) + axis], 5);
    }
  }
});

test('points are spread evenly, also while others appear between them', { tags: ['all'] }, () => {
  expect(points).toHaveLength(2 * PERIOD ** 2);
  const own = Array.from({ length: PERIOD ** 2 }, (_, cell): [number, number] => [
    (cell % PERIOD) + points[2 * cell],
    Math.floor(cell / PERIOD) + points[2 * cell + 1],
  ]);
  expect(evenness(own, PERIOD)).toBeGreaterThan(0.78);
  // Control: a random point in every cell.
  let state = 1;
  const random = (): number => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  expect(
    evenness(
      own.map(([x, y]) => [Math.floor(x) + random(), Math.floor(y) + random()]),
      PERIOD,
    ),
  ).toBeLessThan(0.65);

  for (const octave of [0, 0.25, 0.5, 0.75, 1]) {
    const alive: [number, number][] = [];
    for (let texel = 0; texel < STIPPLE_MAP_SIZE ** 2; texel++) {
      const [x, y, born] = texels.subarray(4 * texel, 4 * texel + 3);
      if (born / 255 > octave) continue;
      alive.push([(texel % STIPPLE_MAP_SIZE) + x / 255, Math.floor(texel / STIPPLE_MAP_SIZE) + y / 255]);
    }
    const share = 0.25 + 0.75 * octave;
    expect(alive.length / STIPPLE_MAP_SIZE ** 2, `${octave}`).toBeCloseTo(share, 1.8);
    expect(evenness(alive, STIPPLE_MAP_SIZE), `${octave}`).toBeGreaterThan(0.67);
  }
});

test('every cell has one old point and three that appear in thirds of an octave', () => {
  for (let cell = 0; cell < PERIOD ** 2; cell++) {
    expect([quarters[cell], ...births[cell]].toSorted()).toEqual([0, 1, 2, 3]);
    const [x, y] = [2 * (cell % PERIOD), 2 * Math.floor(cell / PERIOD)];
    const born = [0, 1, 2, 3].map((b) => texels[4 * ((y + (b >> 1)) * STIPPLE_MAP_SIZE + x + (b & 1)) + 2] / 255);
    expect(born[quarters[cell]]).toBe(0);
    for (const [third, b] of births[cell].entries()) {
      expect(born[b]).toBeGreaterThan(third / 3 - 0.01);
      expect(born[b]).toBeLessThan((third + 1) / 3 + 0.01);
    }
  }
});
