import type { Page } from '@playwright/test';
import { expect, testOnOnePage } from '../browser/test.js';
import type { ThresholdMapTests } from './thresholdMap.js';

const test = testOnOnePage('tests/gpu/thresholdMap.html', {
  begin: (page) => page.waitForFunction(() => window.thresholdMapTests !== undefined),
});

/** Runs one test of the page there and brings its result here. */
function run<Name extends keyof ThresholdMapTests>(
  page: Page,
  name: Name,
): Promise<Awaited<ReturnType<ThresholdMapTests[Name]>>> {
  return page.evaluate((key) => window.thresholdMapTests![key]() as never, name);
}

test('thresholds lie on the GPU level by level, row 0 at v = 0, point-symmetric, and repeat', async ({ page }) => {
  const levels = await run(page, 'levels');
  expect(levels.map(({ texels }) => texels)).toEqual([4096, 1024, 256]);
  for (const { error, asymmetric } of levels) {
    // Half a step of a byte.
    expect(error).toBeLessThan(0.0119);
    expect(asymmetric).toBe(0);
  }
});

test('thresholds are interpolated linearly between texels, across borders too', { tag: '@all' }, async ({ page }) => {
  expect(await run(page, 'interpolation')).toBeLessThan(0.015);
});

test('between two levels, both are read and weighed', async ({ page }) => {
  const { error, apart } = await run(page, 'betweenLevels');
  expect(error).toBeLessThan(0.015);
  expect(apart).toBeGreaterThan(1);
});

test('thresholds are uploaded once, all levels in one call, and freed by dispose', async ({ page }) => {
  expect(await run(page, 'uploads')).toEqual({ calls: 1, during: 1, after: 0 });
});

test('thresholds derived from images lie on the GPU', { tag: '@all' }, async ({ page }) => {
  const { latestInk, earliestPaper } = await run(page, 'derived');
  expect(latestInk).toBeLessThan(0);
  expect(earliestPaper).toBeGreaterThan(0);
});
