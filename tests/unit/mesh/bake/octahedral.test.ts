import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { octahedral } from '../../../../src/mesh/bake/outlineLayout.js';

type Row = readonly number[];

const unit = (v: Row): number[] => v.map((value) => value / Math.hypot(...v));

/** As `unpackSnorm2x16` of GLSL. */
const snorm = (bits: number): number => Math.max(-1, ((bits << 16) >> 16) / 0x7fff);

function decode(word: number): number[] {
  const [x, y] = [snorm(word & 0xffff), snorm(word >>> 16)];
  const z = 1 - Math.abs(x) - Math.abs(y);
  const fold = Math.max(0, -z);
  return unit([x + (x >= 0 ? -fold : fold), y + (y >= 0 ? -fold : fold), z]);
}

const degreesBetween = (a: Row, b: Row): number =>
  (2 * Math.asin(Math.hypot(...a.map((value, axis) => value - b[axis])) / 2) * 180) / Math.PI;

const error = (v: Row): number => degreesBetween(decode(octahedral(v[0], v[1], v[2])), v);

describe('a direction', () => {
  test.each([
    [[1, 0, 0]],
    [[-1, 0, 0]],
    [[0, 1, 0]],
    [[0, -1, 0]],
    [[0, 0, 1]],
    [[0, 0, -1]],
    [[-0, -0, -1]],
    [[-0, 1, -0]],
  ])('along an axis is kept exactly: %j', (v) => {
    expect(decode(octahedral(v[0], v[1], v[2])).map((value) => value + 0)).toEqual(v.map((value) => value + 0));
  });

  test('is kept to 0.005°', () => {
    const component = fc.oneof(
      { weight: 5, arbitrary: fc.double({ min: -1, max: 1, noNaN: true }) },
      { weight: 1, arbitrary: fc.constantFrom(0, -0, 1e-6, -1e-6, 0.5, -0.5) },
    );
    const direction = fc.tuple(component, component, component).filter((v) => Math.hypot(...v) > 1e-3);
    fc.assert(
      fc.property(direction, (v) => {
        expect(error(unit(v))).toBeLessThan(0.005);
      }),
      { seed: 20080, numRuns: 5000 },
    );
  });

  test('is kept to 0.005° all over the sphere', () => {
    let largest = 0;
    for (let i = 0; i < 20_000; i++) {
      const z = 1 - (2 * i + 1) / 20_000;
      const angle = i * Math.PI * (3 - Math.sqrt(5));
      const ring = Math.sqrt(1 - z * z);
      largest = Math.max(largest, error([ring * Math.cos(angle), ring * Math.sin(angle), z]));
    }
    expect(largest).toBeLessThan(0.005);
  });
});

test('a zero vector gives a unit vector', () => {
  expect(decode(octahedral(0, 0, 0))).toEqual([0, 0, 1]);
});
