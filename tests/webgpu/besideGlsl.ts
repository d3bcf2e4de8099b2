import { writeFileSync } from 'node:fs';
import { expect, testOnOnePage } from '../browser/test.js';
import { cases as selected } from '../selection.mjs';
import { NOTICEABLE } from './picturesOf.js';

/** Tests on the page that draws in GLSL and of nodes. */
export const test = testOnOnePage('tests/webgpu/sideBySide.html', {
  begin: (page) => page.waitForFunction(() => window.besideGlsl !== undefined),
});

/** The largest difference of mean tones, of 255, where pixels are not compared. */
const MOST_OFF_TONE = 0.2;

/**
 * Declares the tests of a file of `cases`: nodes draw what GLSL draws, with the WebGL 2 backend and, where the browser has it, with
 * WebGPU. What was measured is in the annotations of tests/output/playwright.json, and the pictures are beside it: GLSL, nodes, and
 * their difference times four.
 *
 * @param quick the names of the cases that `npm test` draws, with the WebGL 2 backend alone. Default: none
 */
export function testGroup(group: string, quick: readonly string[] = []): void {
  for (const drawn of ['forceWebGL', 'webgpu'] as const) {
    const tag = drawn === 'forceWebGL' && quick.length > 0 ? '@more' : '@all';
    test(`${group}: nodes draw what GLSL draws, ${drawn}`, { tag }, async ({ page }) => {
      const all = await page.evaluate((g) => window.besideGlsl.casesOf(g), group);
      expect(all.length, `cases of ${group}`).toBeGreaterThan(0);
      const named = all.filter(({ name }) => quick.includes(name));
      expect(named.length, `cases of ${group} that are named`).toBe(quick.length);
      const cases = selected(named, all);
      // Each builds programs of its own, on the processor.
      test.setTimeout(Math.max(120_000, 30_000 * cases.length));
      const lack = await page.evaluate(() => window.besideGlsl.lackOfWebGPU);
      test.skip(drawn === 'webgpu' && lack !== null, lack ?? '');
      for (const { name, onWebGPU, most } of cases) {
        const measured = await page.evaluate(([g, n, d]) => window.besideGlsl.measure(g, n, d), [
          group,
          name,
          drawn,
        ] as const);
        const { differing, tones, covered, colours, picture } = measured;
        const description = `${(100 * differing).toFixed(3)} % of pixels off by more than ${NOTICEABLE}, mean tones ${tones.map((tone) => tone.toFixed(2)).join(' and ')}`;
        test.info().annotations.push({ type: name, description });
        const path = test.info().outputPath(`${name.replace(/\W+/g, '-')}.png`);
        writeFileSync(path, Buffer.from(picture.slice(picture.indexOf(',') + 1), 'base64'));
        expect.soft(covered, `${name}: the share of pixels that are drawn`).toBeGreaterThan(0.05);
        expect.soft(colours, `${name}: a picture of background, ink and paper`).toBeGreaterThan(2);
        if (drawn === 'webgpu' && onWebGPU === 'tone') {
          expect.soft(Math.abs(tones[1] - tones[0]), `${name}: mean tones`).toBeLessThanOrEqual(MOST_OFF_TONE);
        } else {
          expect.soft(differing, `${name}: ${description}`).toBeLessThanOrEqual(most);
        }
      }
    });
  }
}
