import { describe, expect, it } from 'vitest';
import { principalAxis } from '../../reference/engravedReference.js';
import { lineFactor } from '../../reference/engravedStrokes.js';

describe('principalAxis', () => {
  it('is the direction of one light', () => {
    expect(principalAxis([{ toLight: [0, 0.6, -0.8], weight: 0.3 }])).toEqual(
      [0, 0.6, -0.8].map((x) => expect.closeTo(x)),
    );
  });

  it('lies between two lights, nearer to the stronger, and is not cancelled by lights from opposite sides', () => {
    const [x, y] = principalAxis([
      { toLight: [1, 0, 0], weight: 2 },
      { toLight: [Math.SQRT1_2, Math.SQRT1_2, 0], weight: 1 },
    ]);
    // tan 2a = Σ w sin 2b / Σ w cos 2b.
    expect(Math.atan2(y, x)).toBeCloseTo(Math.atan2(1, 2) / 2);
    const [along] = principalAxis([
      { toLight: [1, 0, 0], weight: 1 },
      { toLight: [-1, 0, 0], weight: 0.9 },
    ]);
    expect(along).toBeCloseTo(1);
  });
});

describe('lineFactor', () => {
  it('is 1 in the mean, differs by a quarter at most, and not at all for a machine', () => {
    const factors = Array.from({ length: 4000 }, (_, i) => lineFactor((i - 2000) / 64, 1));
    expect(factors.reduce((sum, factor) => sum + factor, 0) / 4000).toBeCloseTo(1, 2);
    expect(Math.min(...factors)).toBeGreaterThanOrEqual(0.75);
    expect(Math.max(...factors)).toBeLessThan(1.25);
    expect(new Set(factors).size).toBeGreaterThan(3900);
    expect(lineFactor(0.375, 0)).toBe(1);
  });
});
