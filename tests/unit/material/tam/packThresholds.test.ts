import { describe, expect, it } from 'vitest';
import { packThresholds, pairThresholdLevels } from '../../../../src/material/tam/thresholds.js';
import { generateThresholds } from '../../../../src/strokes/tamImages/generateThresholds.js';

function drawn() {
  const task = generateThresholds({ size: 64, style: 'crossHatching' });
  let step = task.next();
  while (!step.done) step = task.next();
  return step.value;
}

const level = (size: number, encoded: number[]) => ({
  size,
  encoded: new Uint8Array(encoded),
  thresholds: new Float32Array(encoded.length),
});

describe('pairThresholdLevels', () => {
  it('interpolates the coarser level at the texel centres of the finer one, across borders', () => {
    const [pair] = pairThresholdLevels([level(4, new Array(16).fill(0)), level(2, [0, 160, 0, 160])]);
    // Between 0 and 160 at quarters, the same in every row, and reversed across the border.
    expect([...pair!.coarser]).toEqual([40, 40, 120, 120, 40, 40, 120, 120, 40, 40, 120, 120, 40, 40, 120, 120]);
    const [turned] = pairThresholdLevels([level(4, new Array(16).fill(0)), level(2, [0, 0, 160, 160])]);
    expect([...turned!.coarser]).toEqual([40, 40, 40, 40, 40, 40, 40, 40, 120, 120, 120, 120, 120, 120, 120, 120]);
  });

  it('keeps a drawn map point-symmetric, and pairs the coarsest level with itself', () => {
    const pairs = pairThresholdLevels(drawn());
    for (const { size, own, coarser } of pairs) {
      expect(coarser).toHaveLength(size * size);
      expect([...coarser].reverse()).toEqual([...coarser]);
      expect(own).toHaveLength(size * size);
    }
    expect(pairs.at(-1)!.coarser).toEqual(pairs.at(-1)!.own);
  });
});

describe('packThresholds', () => {
  it('puts levels in a row where the shader reads them, each with a margin that wraps around', () => {
    const pairs = pairThresholdLevels(drawn());
    const { width, height, data } = packThresholds(pairs);
    expect(height).toBe(66);
    expect(data).toHaveLength(2 * width * height);
    pairs.forEach(({ size, own, coarser }, index) => {
      const left = 2 * 64 * (1 - 2 ** -index) + 2 * index;
      for (let row = -1; row <= size; row++) {
        for (let column = -1; column <= size; column++) {
          const texel = ((row + size) % size) * size + ((column + size) % size);
          const at = 2 * ((row + 1) * width + left + column + 1);
          if (data[at] !== own[texel] || data[at + 1] !== coarser[texel])
            expect.fail(`level ${index}, texel ${column}, ${row}`);
        }
      }
    });
    expect(width).toBe(pairs.reduce((sum, { size }) => sum + size + 2, 0));
  });
});
