import { beforeEach, expect, test, vi } from 'vitest';
import type * as mediumPattern from '../../../src/webgpu/fetchedCode.js';
import { HatchingNodeMaterial } from '../../../src/webgpu/HatchingNodeMaterial.js';
import { eventually } from '../patience.js';

const STIPPLE = { technique: 'stipple' } as const;

/** Imported anew for each test, with nothing fetched. */
let pattern: typeof mediumPattern;

beforeEach(async () => {
  vi.resetModules();
  pattern = await import('../../../src/webgpu/fetchedCode.js');
});

test('dots are fetched when they are first drawn with, and whoever waits for them is told', async () => {
  const uniforms = { stippleMap: { value: null } };
  const whenThere = vi.fn();
  expect([pattern.writePattern(STIPPLE, uniforms, whenThere), pattern.dotLayerOf(STIPPLE)]).toEqual([false, undefined]);
  expect([uniforms.stippleMap.value, whenThere.mock.calls.length]).toEqual([null, 0]);
  await eventually(() => expect(whenThere).toHaveBeenCalledOnce());
  expect(pattern.writePattern(STIPPLE, uniforms, whenThere)).toBe(true);
  expect([uniforms.stippleMap.value, pattern.dotLayerOf(STIPPLE)]).toEqual([
    expect.objectContaining({ isDataTexture: true }),
    expect.any(Function),
  ]);
});

test('strokes of ink wait for nothing', () => {
  const ink = { technique: 'hatching' } as const;
  expect(pattern.writePattern(ink, {}, vi.fn())).toBe(true);
  expect(pattern.dotLayerOf(ink)).toBeUndefined();
});

test('nodes that were made without dots are not taken for those with them', async () => {
  const material = new HatchingNodeMaterial(STIPPLE);
  const before = material.customProgramCacheKey();
  await material.ready;
  expect(material.customProgramCacheKey()).not.toBe(before);
});
