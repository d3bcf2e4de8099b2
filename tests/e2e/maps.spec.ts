import { readFile } from 'node:fs/promises';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { encodePng } from '../../src/strokes/mapFiles/writeMapFiles.js';
import { drop, openPlayground, readDrawing, ready } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';

const PLAIN = 'model=sphere&mapSize=64&mapTones=4';

/** A PNG image with ink on the left, over `share` of its width. */
async function tile(name: string, share: number, size = 64) {
  const data = Uint8Array.from({ length: size * size }, (_, i) => ((i % size) / size < share ? 0 : 255));
  return {
    name,
    mimeType: 'image/png',
    buffer: Buffer.from(await encodePng({ width: size, height: size, channels: 1, data })),
  };
}

test('the contact sheet opens by keyboard, shows every tone and level, and follows the map', { tag: '@all' }, async ({
  page,
}) => {
  await openPlayground(page, PLAIN);
  const sheet = page.getByRole('region', { name: /4 tones/ });
  const opener = page.getByRole('button', { name: 'Show the map' });
  await opener.press('Enter');
  await expect(sheet).toBeVisible();
  await expect(page.getByRole('button', { name: 'Close' })).toBeFocused();
  const canvas = sheet.getByRole('img', { name: /^Hatching, 4 tones, 3 levels/ });
  await expect(canvas).toHaveAttribute('data-complete', /./);
  const ink = () =>
    sheet.locator('canvas').evaluate((element: HTMLCanvasElement) => {
      const copy = new OffscreenCanvas(element.width, 64).getContext('2d', { willReadFrequently: true })!;
      copy.drawImage(element, 0, 0);
      const { data } = copy.getImageData(0, 0, element.width, 64);
      return [0, 1, 2, 3].map((tone) => {
        let sum = 0;
        for (let i = 0; i < 64 * 64; i++) sum += 255 - data[4 * ((i >> 6) * element.width + 70 * tone + (i & 63))];
        return sum / (255 * 64 * 64);
      });
    });
  const means = await ink();
  means.forEach((mean, tone) => {
    expect(Math.abs(mean - (0.95 * tone) / 3)).toBeLessThan(0.02);
  });
  await page.getByRole('combobox', { name: 'Style' }).selectOption('Stippling');
  await expect(sheet.getByRole('img', { name: /^Stippling, 4 tones/ })).toHaveAttribute('data-complete', /./);
  await expect.poll(async () => (await ink())[3]).toBeLessThan(0.9);
  await page.getByRole('button', { name: 'Close' }).press('Escape');
  await expect(sheet).toBeHidden();
  await expect(opener).toBeFocused();
});

test('PNG images of the user become the map; invalid ones leave it unchanged', async ({ page }) => {
  await openPlayground(page, PLAIN);
  const before = await readDrawing(page);
  const tiles = [await tile('dark.png', 0.8), await tile('light.png', 0.2), await tile('middle.png', 0.5)];
  const question = page.getByRole('dialog', { name: 'These 3 pictures belong to no model here.' });
  await drop(page, tiles);
  await question.getByRole('button', { name: 'Leave the drawing' }).click();
  await expect(question).toBeHidden();
  expect((await readDrawing(page)).data.equals(before.data)).toBe(true);
  await drop(page, tiles);
  await question.getByRole('button', { name: 'Draw strokes' }).click();
  await ready(page);
  await expect(page.locator('select').filter({ hasText: 'Your own' }).nth(1).locator('option:checked')).toHaveText(
    'Your own',
  );
  const own = await readDrawing(page);
  expect(own.data.equals(before.data)).toBe(false);
  await page.getByRole('button', { name: 'Show the map' }).click();
  await expect(page.locator('#contact-sheet')).toBeVisible();
  await drop(page, [await tile('a.png', 0.5), await tile('b.png', 0.8, 32)]);
  await expect(page.getByRole('status')).toContainText(
    /[ab]\.png has \d+ pixels per side, but [ab]\.png has \d+; give every tone the same/,
  );
  await page.getByRole('button', { name: 'Close' }).click();
  expect((await readDrawing(page)).data.equals(own.data)).toBe(true);
});

test('the map is saved as an archive that restores it', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await page.getByRole('button', { name: 'Show the map' }).click();
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the map' }).click();
  const download = await waiting;
  expect(download.suggestedFilename()).toBe('hatching.zip');
  const entries = unzipSync(new Uint8Array(await readFile(await download.path())));
  const { images, thresholds } = JSON.parse(new TextDecoder().decode(entries['map.json']));
  expect(Object.keys(entries).sort()).toEqual(['map.json', ...images.flat(), ...thresholds].sort());
  // Closed, because its caption is going to change.
  await page.getByRole('button', { name: 'Close' }).click();
  const before = await readDrawing(page);
  await drop(
    page,
    Object.entries(entries).map(([name, bytes]) => ({ name, mimeType: '', buffer: Buffer.from(bytes) })),
  );
  await ready(page);
  expect((await readDrawing(page)).data.equals(before.data)).toBe(true);
});

test('the contact sheet fits a small screen and scrolls', { tag: '@all' }, async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 640 });
  await openPlayground(page, PLAIN);
  await page.getByRole('button', { name: 'Settings' }).first().click();
  await page.getByRole('button', { name: 'Show the map' }).click();
  await expect(page.locator('#contact-sheet')).toBeVisible();
  const box = (await page.locator('#contact-sheet').boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(360);
  const scrolls = await page
    .locator('#contact-sheet-scroller')
    .evaluate((element) => getComputedStyle(element).overflowX);
  expect(scrolls).toBe('auto');
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
});
