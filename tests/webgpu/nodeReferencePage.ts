import { testOnOnePage } from '../browser/test.js';

/** Tests on the page that draws, of nodes, what the reference in double precision is asked for. They are skipped where it cannot. */
export const nodeReferencePage = (drawn: 'forceWebGL' | 'webgpu') => {
  const test = testOnOnePage(`tests/webgpu/reference.html?${drawn}`, {
    async begin(page) {
      await page.waitForFunction(() => window.renderHatching !== undefined);
      const lack = await page.evaluate(() => window.lack);
      test.skip(lack !== null, lack ?? '');
    },
  });
  return test;
};
