import type { Page } from '@playwright/test';
import { testOnOnePage } from '../browser/test.js';

/** Waits for the toolkit, which is silent about mistakes until a test breaks the silence. */
export async function beginInSilence(page: Page): Promise<void> {
  await page.waitForFunction(() => window.toolkit !== undefined);
  await page.evaluate(() => {
    window.toolkit.HatchingMaterial.silent = true;
  });
}

/** The toolkit, loaded once for all tests of a file. What a test draws with is taken away when it ends. */
export const test = testOnOnePage('tests/gpu/toolkit.html', { freesContexts: true, begin: beginInSilence });
