import { quickIf } from '../browser/quickIf.js';
import { expect } from '../browser/test.js';
import { test } from './besideGlsl.js';

for (const drawn of ['forceWebGL', 'webgpu'] as const) {
  test(
    `fifty materials of two kinds share two programs: ${drawn}`,
    quickIf(drawn === 'forceWebGL'),
    async ({ page }) => {
      const lack = await page.evaluate(() => window.besideGlsl.lackOfWebGPU);
      test.skip(drawn === 'webgpu' && lack !== null, lack ?? '');
      const one = await page.evaluate((d) => window.besideGlsl.programsOfMany(d, 1), drawn);
      const many = await page.evaluate((d) => window.besideGlsl.programsOfMany(d, 50), drawn);
      // The background has a program too.
      expect(many - one).toBe(1);
    },
  );

  test(`a scene is drawn again after a renderer has lost its device: ${drawn}`, { tag: '@all' }, async ({ page }) => {
    const lack = await page.evaluate(() => window.besideGlsl.lackOfWebGPU);
    test.skip(drawn === 'webgpu' && lack !== null, lack ?? '');
    expect(await page.evaluate((d) => window.besideGlsl.afterLoss(d), drawn)).toBe(0);
  });
}
