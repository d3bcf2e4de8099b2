import { describe, expect, it } from 'vitest';
import { paperGrain } from '../../../src/strokes/paperGrain.js';
import { rasterizeStroke } from '../../../src/strokes/rasterizeStroke.js';
import type { Stroke } from '../../../src/strokes/Stroke.js';
import { resolveHatchImageOptions } from '../../../src/strokes/tamImages/generateHatchImages.js';

const charcoal = resolveHatchImageOptions({ style: 'charcoal', size: 64 });

describe('paperGrain', () => {
  it('is evenly distributed over all depths, and unchanged by a half turn', () => {
    const { depths } = paperGrain(charcoal, 0)!;
    const counts = new Array<number>(256).fill(0);
    for (const depth of depths) counts[depth]++;
    expect(new Set(counts)).toEqual(new Set([64 ** 2 / 256]));
    expect(depths.filter((depth, i) => depth !== depths[depths.length - 1 - i]).length).toBe(0);
  });

  it('has grains wider than a texel: neighbours are alike', () => {
    const { depths } = paperGrain(charcoal, 0)!;
    let product = 0;
    for (let i = 0; i < depths.length; i++) {
      const beside = (i & ~63) | ((i + 1) & 63);
      product += (depths[i] - 127.5) * (depths[beside] - 127.5);
    }
    expect(product / depths.length / (256 ** 2 / 12)).toBeGreaterThan(0.5);
  });

  it('forms streaks along rows on request', () => {
    const { depths } = paperGrain(charcoal, 0, 7)!;
    const likeness = (to: (x: number, y: number) => number): number =>
      depths.reduce((sum, depth, i) => sum + (depth - 127.5) * (depths[to(i & 63, i >> 6)] - 127.5), 0);
    expect(likeness((x, y) => 64 * y + ((x + 5) & 63))).toBeGreaterThan(
      3 * Math.abs(likeness((x, y) => 64 * ((y + 5) & 63) + x)),
    );
  });

  it('differs by level and seed, and is reproducible', () => {
    const { depths } = paperGrain(charcoal, 1)!;
    expect(paperGrain(charcoal, 1)!.depths).toEqual(depths);
    expect(paperGrain({ ...charcoal, seed: 2 }, 1)!.depths).not.toEqual(depths);
    expect(paperGrain(charcoal, 0)!.depths.slice(0, depths.length)).not.toEqual(depths);
  });

  it('is absent for a pen', () => {
    expect(paperGrain(resolveHatchImageOptions({ style: 'hatching' }), 0)).toBeUndefined();
  });

  it('takes less ink from a stroke that presses less, and none beside it', () => {
    const grain = paperGrain(charcoal, 0)!;
    const ink = (pressure: number): number => {
      const stroke = { u: 0.5, v: 0.5, layer: 0, across: false, length: 0.6, slope: 0, bow: 0, wave: 0, width: 2.6 };
      const image = new Uint8Array(64 * 64).fill(255);
      rasterizeStroke(image, 64, { ...stroke, taper: 0, pressure, tone: 1, level: 0 } satisfies Stroke, grain);
      expect(image.subarray(0, 64 * 29).every((byte) => byte === 255)).toBe(true);
      return image.reduce((sum, byte) => sum + 1 - byte / 255, 0) / (0.6 * 64 * 2.6);
    };
    expect(ink(0)).toBeLessThan(0.1);
    expect(ink(0.6)).toBeGreaterThan(0.2);
    expect(ink(1.5)).toBeGreaterThan(1.3 * ink(0.6));
    expect(ink(1.5)).toBeLessThan(1.15);
  });
});
