import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { sortedIndices } from '../../../src/strokes/ranking.js';

describe('sortedIndices', () => {
  it('lists indices by value, equal ones by index', () => {
    expect([...sortedIndices(new Float32Array([3, 0.5, 1e9, 0.5, 0]))]).toEqual([4, 1, 3, 0, 2]);
  });

  it('agrees with a comparing sort', () => {
    const float = fc.float({ min: 0, noNaN: true, noDefaultInfinity: true }).map((value) => Math.abs(value));
    fc.assert(
      fc.property(fc.array(float, { maxLength: 200 }), (numbers) => {
        const values = Float32Array.from(numbers);
        const expected = [...values.keys()].toSorted((a, b) => values[a] - values[b] || a - b);
        expect([...sortedIndices(values)]).toEqual(expected);
      }),
    );
  });
});
