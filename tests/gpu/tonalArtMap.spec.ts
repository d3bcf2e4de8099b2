import type { Page } from '@playwright/test';
import { expect, testOnOnePage } from '../browser/test.js';
import type { TonalArtMapTests } from './tonalArtMap.js';

const test = testOnOnePage('tests/gpu/tonalArtMap.html', {
  begin: (page) => page.waitForFunction(() => window.tonalArtMapTests !== undefined),
});

/** Runs one test of the page there and brings its result here. */
function run<Name extends keyof TonalArtMapTests>(
  page: Page,
  name: Name,
): Promise<Awaited<ReturnType<TonalArtMapTests[Name]>>> {
  return page.evaluate((key) => window.tonalArtMapTests![key]() as never, name);
}

test('each tone and level on the GPU is the drawn one, and levels blend', async ({ page }) => {
  const [firstGroup, secondGroup] = await run(page, 'constants');
  // Byte of tone t and level l: 250 − 40t − 7l. Columns: tones 0 to 3, then 3 to 5 and 5 again.
  expect(firstGroup.slice(0, 4)).toEqual([
    [250, 210, 170, 130],
    [243, 203, 163, 123],
    [236, 196, 156, 116],
    [229, 189, 149, 109],
  ]);
  expect(secondGroup.slice(0, 4)).toEqual([
    [130, 90, 50, 50],
    [123, 83, 43, 43],
    [116, 76, 36, 36],
    [109, 69, 29, 29],
  ]);
  for (const [group, expected] of [
    [firstGroup, [246.5, 206.5, 166.5, 126.5]],
    [secondGroup, [126.5, 86.5, 46.5, 46.5]],
  ] as const) {
    for (const [channel, value] of expected.entries()) {
      expect(Math.abs(group[4]![channel]! - value)).toBeLessThanOrEqual(1);
      expect(Math.abs(group[5]![channel]! - (value - 14))).toBeLessThanOrEqual(1);
    }
  }
});

test('where the coordinates choose the level, it is the drawn one', { tag: '@all' }, async ({ page }) => {
  expect(await run(page, 'automatic')).toEqual([
    [250, 210, 170, 130],
    [243, 203, 163, 123],
    [236, 196, 156, 116],
    [229, 189, 149, 109],
  ]);
});

test('a map of one level is complete without mip levels', { tag: '@all' }, async ({ page }) => {
  expect(await run(page, 'singleLevel')).toEqual([250, 210, 170, 130]);
});

test('a generated map lies on the GPU byte by byte, row 0 at v = 0, and repeats', async ({ page }) => {
  // 6 tones and 3 levels; tone 3 lies in both groups.
  expect(await run(page, 'generated')).toEqual({ different: [], compared: 21 });
});

test('the texture is uploaded once, level by level, and freed by dispose', async ({ page }) => {
  expect(await run(page, 'uploads')).toEqual({ calls: 5, during: 1, after: 0 });
});

test('drawing in the worker can be aborted and refuses nonsense', async ({ page }) => {
  const { aborted, reports, nonsense } = await run(page, 'refusals');
  expect(aborted).toBe('AbortError');
  expect(reports).toBe(1);
  expect(nonsense).toBe('TonalArtMap.generate: tones is 1000, but must be a whole number from 4 to 16.');
});
