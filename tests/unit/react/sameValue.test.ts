import { Color } from 'three';
import { expect, test } from 'vitest';
import { sameValue } from '../../../src/react/sameValue.js';

test('options are the same by what they hold, whatever they are made of', () => {
  const same: [unknown, unknown][] = [
    [1, 1],
    [Number.NaN, Number.NaN],
    [
      [1, [2, 3]],
      [1, [2, 3]],
    ],
    [
      { preset: 'pen', outlines: { width: 2, list: [1] } },
      { outlines: { list: [1], width: 2 }, preset: 'pen' },
    ],
    [() => 1, () => 2],
    [{ ink: undefined }, {}],
  ];
  for (const [a, b] of same) expect([a, b, sameValue(a, b)]).toEqual([a, b, true]);
});

test('options differ in a value, a length, a name, or a kind', () => {
  const ink = new Color('red');
  const other: [unknown, unknown][] = [
    [1, 2],
    [0, false],
    [null, undefined],
    [[1, 2], [1]],
    [[1], [1, 2]],
    [
      [1, 2],
      [2, 1],
    ],
    [{ a: 1 }, { a: 1, b: 2 }],
    [{ a: 1, b: 2 }, { a: 1 }],
    [{ a: { b: 1 } }, { a: { b: 2 } }],
    [{}, null],
    [() => 1, {}],
    // The content of other objects is unknown.
    [ink, ink.clone()],
    [{ ink }, { ink: ink.clone() }],
  ];
  for (const [a, b] of other) expect([a, b, sameValue(a, b)]).toEqual([a, b, false]);
  expect(sameValue({ ink }, { ink })).toBe(true);
});
