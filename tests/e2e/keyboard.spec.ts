import { readFile } from 'node:fs/promises';
import type { Locator, Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { SHEET_SIZES } from '../../src/vector/svg/sheetSizes.js';
import { openPlayground } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';

/** A limit above the number of tab stops of the page. */
const MANY_STOPS = 400;

/**
 * Goes from stop to stop by the Tab key until something has the focus, and returns what is wrong with it then: that it cannot be seen.
 *
 * @throws Error if no stop is it
 */
async function goTo(page: Page, wanted: Locator): Promise<string> {
  const handle = await wanted.elementHandle();
  for (let stop = 0; stop < MANY_STOPS; stop++) {
    await page.keyboard.press('Tab');
    if (!(await handle!.evaluate((element) => element === document.activeElement))) continue;
    return handle!.evaluate((element, name) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      const isInside = left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
      const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      if (isInside && (element.contains(hit) || hit?.contains(element))) return '';
      return `${name} lies at ${[left, top, right, bottom].map(Math.round)}, under ${hit?.id}`;
    }, String(wanted));
  }
  throw new Error(`No stop of the Tab key is ${wanted}.`);
}

/** The file that the focused control saves when Enter is pressed. */
async function saved(page: Page): Promise<{ name: string; content: Buffer }> {
  const download = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  const file = await download;
  return { name: file.suggestedFilename(), content: await readFile(await file.path()) };
}

for (const [width, height] of [
  [390, 844],
  [800, 500],
]) {
  test.describe(`in a window of ${width} × ${height}`, () => {
    test.use({ viewport: { width, height }, contextOptions: { reducedMotion: 'reduce' } });

    test('everything is saved by the keyboard alone', { tag: '@all' }, async ({ page }) => {
      await openPlayground(
        page,
        'model=cube&technique=engraving&occlusion=0&pictureDpi=150&videoSeconds=1&videoRate=12',
      );
      const faults: string[] = [];
      const button = (name: string): Locator =>
        page.locator('#card, #bar').getByRole('button', { name, exact: true }).first();
      const press = async (name: string): Promise<void> => {
        faults.push(await goTo(page, button(name)));
        await page.keyboard.press('Enter');
      };
      if (await page.locator('#toggle-card').isVisible()) await press('Settings');
      await press('Picture');
      faults.push(await goTo(page, page.getByRole('combobox', { name: 'Size', exact: true }).first()));
      const sizes = await page.evaluate(() =>
        [...(document.activeElement as HTMLSelectElement).options].map(({ text }) => text),
      );
      expect(
        sizes
          .filter((text) => / sheet$/.test(text))
          .map((text) => text.replace(' sheet', ''))
          .sort(),
      ).toEqual(Object.keys(SHEET_SIZES).sort());
      await page.keyboard.type('Letter');
      faults.push(await goTo(page, button('Save SVG, as lines')));
      const svg = await saved(page);
      expect(svg.content.toString()).toMatch(
        /^<svg [^>]*width="(215\.9mm" height="279\.4|279\.4mm" height="215\.9)mm"/,
      );
      faults.push(await goTo(page, button('Save PNG')));
      const png = PNG.sync.read((await saved(page)).content);
      expect([png.width, png.height].sort((a, b) => a - b)).toEqual([1275, 1650]);
      await press('Video');
      faults.push(await goTo(page, button('Record a video')));
      expect((await saved(page)).name).toMatch(/\.(webm|mp4)$/);
      expect(faults.filter((fault) => fault !== '')).toEqual([]);
    });
  });
}
