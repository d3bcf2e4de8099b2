import { expect, test } from 'vitest';
import { type TonedSurface, tellApart } from '../../../../src/material/exposure/tellApart.js';

const LIMITS = { step: 0.15, darkest: 0.7 };

/** The luminance of a lightness. */
const luminanceOf = (light: number): number => (light <= 0.08 ? light / 9.032963 : ((light + 0.16) / 1.16) ** 3);

/** A surface by its lightness and darkness, the surfaces of the list that it is beside, and whether it keeps its darkness. */
type Given = readonly [lightness: number, darkness: number, beside?: readonly number[], isFixed?: boolean];

function toldApart(...given: readonly Given[]): number[] {
  const surfaces = given.map(([lightness, darkness, beside = [], isFixed = false], i): TonedSurface => {
    const luminance = luminanceOf(lightness);
    const others = given.flatMap(([, , of = []], j) => (of.includes(i) ? [j] : []));
    return {
      color: { r: luminance, g: luminance, b: luminance, weight: 1 / given.length },
      ...{ lightness, darkness, isFixed, neighbours: new Set([...beside, ...others]) },
    };
  });
  tellApart(surfaces, LIMITS);
  return surfaces.map(({ darkness }) => darkness);
}

test('tones that differ by a step stay as they are, and so do those of surfaces that lie apart', () => {
  expect(toldApart([0.9, 0, [1]], [0.6, 0.15])).toEqual([0, 0.15]);
  expect(toldApart([0.9, 0], [0.85, 0])).toEqual([0, 0]);
});

test('of two greys that are alike in tone the darker becomes a step darker', () => {
  expect(toldApart([0.85, 0.04, [1]], [0.9, 0])).toEqual([0.15, 0]);
});

test('eight greys in a row, each a little darker than the last, differ from their neighbours by a step', () => {
  const greys = Array.from({ length: 8 }, (_, i) => [0.95 - 0.09 * i, 0.03 * i] as const);
  for (const order of [greys, [...greys].reverse()]) {
    const tones = toldApart(...order.map(([light, dark], i): Given => [light, dark, i < 7 ? [i + 1] : []]));
    for (let i = 1; i < 8; i++) expect(Math.abs(tones[i] - tones[i - 1])).toBeGreaterThanOrEqual(0.15 - 1e-9);
    expect(Math.min(...tones)).toBe(0);
    expect(Math.max(...tones)).toBeLessThanOrEqual(0.35);
  }
});

test('what is clearly lighter than its neighbour stays lighter', () => {
  // The middle grey would be nearest to its own tone as paper, beside the light grey in a tone of its own.
  expect(toldApart([0.9, 0.1, [1]], [0.6, 0.12])).toEqual([0.1, 0.25]);
  const [, other] = toldApart([0.9, 0.16, [1]], [0.75, 0.12]);
  expect(other).toBeCloseTo(0.01, 9);
});

test('surfaces of one colour are left to outlines, and surfaces of many colours keep their tones', () => {
  expect(toldApart([0.5, 0.1, [1]], [0.5, 0.1])).toEqual([0.1, 0.1]);
  expect(toldApart([0.6, 0.1, [1]], [0.9, 0.05, [], true])).toEqual([0.2, 0.05]);
});

test('a surface that no tone tells from all around it keeps its own', () => {
  const around = [0, 0.14, 0.28, 0.42, 0.56, 0.7].map((darkness): Given => [0.5, darkness, [], true]);
  expect(toldApart(...around, [0.45, 0.3, [0, 1, 2, 3, 4, 5]]).at(-1)).toBe(0.3);
});
