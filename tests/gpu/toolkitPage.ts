import { testOnOnePage } from '../browser/test.js';

/** The toolkit, loaded once for all tests of a file. What a test draws with is taken away when it ends. */
export const test = testOnOnePage('tests/gpu/toolkit.html', { freesContexts: true });

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.toolkit !== undefined);
  await page.evaluate(() => {
    window.toolkit.HatchingMaterial.silent = true;
  });
});
