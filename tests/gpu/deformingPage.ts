import { testOnOnePage } from '../browser/test.js';

/** The toolkit with models that move, loaded once for all tests of a file. */
export const test = testOnOnePage('tests/gpu/deforming.html', { freesContexts: true });

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.deforming !== undefined);
  await page.evaluate(() => {
    window.toolkit.HatchingMaterial.silent = true;
  });
});
