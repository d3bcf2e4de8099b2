import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { openPlayground } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { cases } from '../selection.mjs';

const SIZES = [
  [1000, 700],
  [360, 640],
  [740, 360],
  [1920, 1080],
] as const;

/** Violations that axe finds, one per line. */
async function violations(page: Page): Promise<string[]> {
  // A page that breaks off its context to be looked at would say so on the console.
  // Passes are not described, which would take most of the time.
  const { violations: found } = await new AxeBuilder({ page })
    .setLegacyMode()
    .options({ resultTypes: ['violations'] })
    .analyze();
  return found.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target.join(' ')}`));
}

test('axe finds nothing on the playground, at four sizes, with settings and gallery open', { tag: '@more' }, async ({
  page,
}) => {
  await openPlayground(page, 'model=cube&mapSize=64&mapTones=4&outlines=off');
  for (const [width, height] of cases<readonly (readonly [number, number])[]>(SIZES.slice(0, 1), SIZES)) {
    await page.setViewportSize({ width, height });
    expect.soft(await violations(page), `${width} × ${height}`).toEqual([]);
    const settings = page.getByRole('button', { name: 'Settings' });
    if (await settings.isVisible()) {
      await settings.click();
      expect.soft(await violations(page), `${width} × ${height}, with settings`).toEqual([]);
      for (const dialog of width === 360 ? ['Keys', 'Looks', 'Views'] : []) {
        await page.getByRole('button', { name: dialog }).click();
        await expect(page.getByRole('dialog')).toBeVisible();
        if (dialog === 'Views') {
          await page.getByRole('button', { name: 'Keep this view' }).click();
          await expect(page.getByLabel(/^Name of /)).toBeVisible();
        }
        expect.soft(await violations(page), `${width} × ${height}, ${dialog}`).toEqual([]);
        await page.keyboard.press('Escape');
      }
      await settings.click();
    }
    await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1);
  }
  await page.getByRole('button', { name: 'More' }).click();
  await page.getByLabel('Information about the model').click();
  await expect(page.locator('#model-statistics')).toBeVisible();
  expect.soft(await violations(page), 'with what there is to know about the model').toEqual([]);
  await page.getByRole('button', { name: 'Gallery' }).click();
  await expect(page.getByRole('heading', { name: 'Gallery' })).toBeVisible();
  expect.soft(await violations(page), 'with the gallery').toEqual([]);
  await page.keyboard.press('Escape');
  const width = page.getByRole('spinbutton', { name: 'Stroke width' });
  await expect(width).toHaveAttribute('aria-valuetext', '1.5 px');
  await expect(width).toHaveAttribute('aria-valuemin', '0.5');
  await expect(width).toHaveAttribute('aria-valuemax', '8');

  // Marks of a state keep a colour under the reader's own colours.
  await page.emulateMedia({ forcedColors: 'active' });
  const pen = page.getByRole('button', { name: 'Pen', exact: true });
  await pen.click();
  await expect(pen).toHaveAttribute('aria-pressed', 'true');
  const colours = await page.evaluate(() => {
    const of = (selector: string, pseudo?: string) =>
      getComputedStyle(document.querySelector(selector)!, pseudo).backgroundColor;
    return {
      card: of('.card'),
      track: of('.lil-slider', '::before'),
      thumb: of('.lil-fill', '::after'),
      divider: of('.divider', '::before'),
      pressed: of('.presets [aria-pressed=true]'),
    };
  });
  for (const [name, colour] of Object.entries(colours)) {
    if (name !== 'card') expect(colour, name).not.toBe(colours.card);
  }
});

test('axe finds nothing on the sheet for a hand of one’s own, at two sizes, empty and with a hand', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, 'model=cube&outlines=off&technique=hatching&mapSize=64&mapTones=4');
  await page.getByRole('button', { name: 'Draw with your own hand' }).click();
  await expect(page.getByRole('heading', { name: 'Your own hand' })).toBeVisible();
  expect.soft(await violations(page), 'empty').toEqual([]);
  await page.getByRole('combobox', { name: 'Begin from' }).selectOption('a reed pen');
  await expect(page.getByRole('slider', { name: 'Length', exact: true })).toBeVisible();
  for (const [width, height] of SIZES.slice(0, 2)) {
    await page.setViewportSize({ width, height });
    expect.soft(await violations(page), `${width} × ${height}`).toEqual([]);
  }
});

test('axe finds nothing on the page of the figures, at four sizes', { tag: '@all' }, async ({ page }) => {
  await page.goto('./figures/');
  for (const [width, height] of SIZES) {
    await page.setViewportSize({ width, height });
    expect.soft(await violations(page), `${width} × ${height}`).toEqual([]);
  }
});
