import { testOnOnePage } from '../browser/test.js';
import { beginInSilence } from './toolkitPage.js';

/** The toolkit with models that move, loaded once for all tests of a file. */
export const test = testOnOnePage('tests/gpu/deforming.html', {
  freesContexts: true,
  begin: async (page) => {
    await page.waitForFunction(() => window.deforming !== undefined);
    await beginInSilence(page);
  },
});
