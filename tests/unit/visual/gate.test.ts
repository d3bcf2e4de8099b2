import { describe, expect, test } from 'vitest';
import { compareWithGolden, isSingleColour, type Picture } from '../../visual/gate.js';

/** 50 × 40 = 2,000 pixels of grey noise; 0.1 % of them are 2. */
function noise(): Picture {
  const data = new Uint8Array(50 * 40 * 4).fill(255);
  for (let i = 0; i < 2000; i++) data.fill((i * 7919) % 200, 4 * i, 4 * i + 3);
  return { width: 50, height: 40, data };
}

function withChangedPixels(count: number, by: number): Picture {
  const picture = noise();
  for (let i = 0; i < count; i++) {
    const first = 4 * ((i * 371) % 2000);
    for (let channel = 0; channel < 3; channel++) picture.data[first + channel] += by;
  }
  return picture;
}

describe('compareWithGolden', () => {
  test.each([
    ['the same pixels', withChangedPixels(0, 0), 'identical'],
    ['every other pixel one step off', withChangedPixels(1000, 1), 'close'],
    ['every pixel two steps off, which is 1.3 % of the ink', withChangedPixels(2000, 2), 'different'],
    ['0.1 % of the pixels far off', withChangedPixels(2, 55), 'close'],
    ['0.15 % of the pixels far off', withChangedPixels(3, 55), 'different'],
  ] as const)('%s: %s', (_, actual, verdict) => {
    expect(compareWithGolden(actual, noise()).verdict).toBe(verdict);
  });

  test('antialiased pixels count', () => {
    // A slanted edge, and the same with its antialiased pixels a shade darker.
    const edge = (shade: number): Picture => {
      const data = new Uint8Array(40 * 40 * 4).fill(255);
      for (let y = 0; y < 40; y++) {
        for (let x = 0; x < 40; x++)
          data.fill(x < y ? 0 : x === y ? shade : 255, 4 * (40 * y + x), 4 * (40 * y + x) + 3);
      }
      return { width: 40, height: 40, data };
    };
    expect(compareWithGolden(edge(60), edge(180)).verdict).toBe('different');
  });

  test('another size is different, and says which', () => {
    const { verdict, text } = compareWithGolden({ width: 40, height: 50, data: noise().data }, noise());
    expect(verdict).toBe('different');
    expect(text).toContain('40×50');
    expect(text).toContain('50×40');
  });
});

test('isSingleColour', () => {
  const picture: Picture = { width: 2, height: 1, data: Uint8Array.of(1, 2, 3, 255, 1, 2, 3, 255) };
  expect(isSingleColour(picture)).toBe(true);
  picture.data[6] = 4;
  expect(isSingleColour(picture)).toBe(false);
});
