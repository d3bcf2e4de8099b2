import { expect, test } from '../browser/test.js';

test('a quiet page passes, and its WebGL2 contexts are known', async ({ page }) => {
  await page.goto('/tests/browser/blank.html');
  const contexts = await page.evaluate(() => {
    document.createElement('canvas').getContext('webgl2');
    new OffscreenCanvas(1, 1).getContext('webgl2');
    return window.__webglContexts?.length;
  });
  expect(contexts).toBe(2);
});

test('long lists of numbers arrive as they were, there and back', async ({ page }) => {
  await page.goto('/tests/browser/blank.html');
  const bytes = Array.from({ length: 1000 }, (_, i) => i % 256);
  const numbers = bytes.map((byte) => byte / 3 - 40);
  numbers.splice(0, 4, -0, Number.NaN, Number.POSITIVE_INFINITY, 1e300);
  const texts = [...bytes.map(String), undefined, null];
  const sent = { bytes, nested: [[numbers, { again: numbers }], texts], few: [1, 2], zero: [...bytes, -0] };
  const [returned, sums] = await page.evaluate(
    (got) => [got, [Array.isArray(got.bytes), got.bytes.reduce((sum, one) => sum + one)]] as const,
    sent,
  );
  expect(returned).toStrictEqual(sent);
  expect(sums).toEqual([true, bytes.reduce((sum, one) => sum + one)]);
  const ring = await page.evaluate(() => {
    const one: { list: unknown[] } = { list: [new Map(), new Uint8Array(3), new Date(5)] };
    one.list.push(one);
    return one;
  });
  expect(ring.list[3]).toBe(ring);
  expect(ring.list.slice(1, 3)).toEqual([new Uint8Array(3), new Date(5)]);
  await expect(page.evaluate(() => Promise.reject(new RangeError('no')))).rejects.toThrow('no');
});

test.describe('these must fail, or no other test would notice a fault of the page', () => {
  test('a console warning', async ({ page }) => {
    test.fail();
    await page.goto('/tests/browser/blank.html');
    await page.evaluate(() => console.warn('a warning'));
  });

  test('an uncaught error', async ({ page }) => {
    test.fail();
    await page.goto('/tests/browser/blank.html');
    await page.evaluate(
      () =>
        new Promise<void>((resolve) => {
          setTimeout(() => {
            setTimeout(resolve);
            throw new Error('uncaught');
          });
        }),
    );
  });

  test('a GL error', async ({ page, pageProblems }) => {
    test.fail();
    await page.goto('/tests/browser/blank.html');
    // The browser warns about it on the console too; here only gl.getError is to find it.
    const warning = page.waitForEvent('console');
    await page.evaluate(() => document.createElement('canvas').getContext('webgl2')?.enable(1));
    await warning;
    pageProblems.length = 0;
  });
});
