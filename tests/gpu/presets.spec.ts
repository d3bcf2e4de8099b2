import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { Picture } from '../../pictures/page.js';
import { PLANS } from '../../pictures/plans.mjs';
import { expect, test } from '../browser/test.js';
import { type PictureTraits, pictureTraits, traitDistances } from './pictureTraits.js';

/** How many times farther apart two presets must be than one preset before and after the light has moved by a few degrees. */
const CLEARLY = 4;

/** A drawing of the sheet in docs/presets.md, 200 pixels wide. */
async function thumbnail(page: Page, picture: Picture, change: Partial<Picture> = {}): Promise<PictureTraits> {
  const small: unknown = { ...picture, width: 200, height: 250, pixelRatio: 1, ...change };
  const address = await page.evaluate((what) => window.drawPicture?.(what as Picture, ''), small);
  return pictureTraits(PNG.sync.read(Buffer.from(address!.slice(address!.indexOf(',') + 1), 'base64')));
}

test('the presets tell apart at 200 pixels, by more than colour', async ({ page }) => {
  test.setTimeout(300_000);
  await page.goto('./pictures/pictures.html');
  await page.waitForFunction(() => typeof window.drawPicture === 'function');
  const { pictures } = PLANS.presets;
  expect(pictures).toHaveLength(9);
  const seen: [string, PictureTraits][] = [];
  const least = { ink: 0, grey: 0, fineness: 0, coherence: 0, directions: 0 };
  const traits = Object.keys(least) as (keyof typeof least)[];
  for (const picture of pictures) {
    const traitsOfOne = await thumbnail(page, picture);
    const [x, y, z] = picture.light;
    const moved = traitDistances(traitsOfOne, await thumbnail(page, picture, { light: [x, y + 0.02, z + 0.07] }));
    for (const trait of traits) least[trait] = Math.max(least[trait], CLEARLY * moved[trait]);
    seen.push([picture.preset, traitsOfOne]);
  }
  const tellApart = (a: PictureTraits, b: PictureTraits): boolean => {
    const distances = traitDistances(a, b);
    return traits.some((trait) => distances[trait] > least[trait]);
  };
  for (const [i, [one, a]] of seen.entries()) {
    for (const [other, b] of seen.slice(i + 1)) expect(tellApart(a, b), `${one} and ${other}`).toBe(true);
  }
  // Control: other colours alone are no other preset.
  const colours = { ink: '#203080', paper: '#ffe0c0' };
  const tinted = await thumbnail(page, pictures[0], { material: colours, lines: { ink: colours.ink } });
  expect(tellApart(seen[0][1], tinted)).toBe(false);
});
