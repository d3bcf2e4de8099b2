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
    await page.evaluate(() => document.createElement('canvas').getContext('webgl2')?.enable(1));
    // The browser warns about it on the console too; here only gl.getError is to find it.
    await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 100)));
    pageProblems.length = 0;
  });
});
