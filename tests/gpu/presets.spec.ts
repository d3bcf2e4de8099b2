import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { presets } from '../../src/scene/presets.js';
import type { Picture } from '../../tools/pictures/page.js';
import { plansOf } from '../../tools/pictures/plans.mjs';
import { expect, test } from '../browser/test.js';
import { type PictureTraits, pictureTraits, traitDistances } from './pictureTraits.js';

/** The distance of two presets must be this many times that of a preset from itself after the light has moved by a few degrees. */
const CLEARLY = 4;
/** The least limit, where that distance happens to be smaller. */
const LEAST_MOVED = 0.001;

/** A drawing of the sheet in docs/presets.md, 200 pixels wide, under each light. */
async function thumbnails(page: Page, picture: Picture, lights: readonly Picture['light'][]): Promise<PictureTraits[]> {
  const small: unknown = { ...picture, width: 200, height: 250, pixelRatio: 1 };
  const addresses = await page.evaluate(([what, from]) => window.drawUnder?.(what as Picture, '', from), [
    small,
    lights,
  ] as const);
  return addresses!.map((address) =>
    pictureTraits(PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'))),
  );
}

test('the presets can be distinguished at 200 pixels, and not only by colour', { tag: '@all' }, async ({ page }) => {
  await page.goto('./tools/pictures/pictures.html');
  await page.waitForFunction(() => typeof window.drawUnder === 'function');
  const { pictures } = plansOf(Object.keys(presets), []).presets;
  const traits = ['ink', 'grey', 'fineness', 'coherence', 'directions'] as const;
  const seen: { name: string; own: PictureTraits; moved: Record<(typeof traits)[number], number> }[] = [];
  for (const picture of pictures) {
    const [x, y, z] = picture.light;
    const [own, other] = await thumbnails(page, picture, [picture.light, [x, y + 0.02, z + 0.07]]);
    seen.push({ name: picture.preset, own, moved: traitDistances(own, other) });
  }
  type Seen = (typeof seen)[number];
  const tellApart = (a: Seen, b: Seen): boolean => {
    const distances = traitDistances(a.own, b.own);
    return traits.some((trait) => distances[trait] > CLEARLY * Math.max(a.moved[trait], b.moved[trait], LEAST_MOVED));
  };
  for (const [i, one] of seen.entries()) {
    for (const other of seen.slice(i + 1)) expect(tellApart(one, other), `${one.name} and ${other.name}`).toBe(true);
  }
  // Control: other colours alone are no other preset.
  const colours = { ink: '#203080', paper: '#ffe0c0' };
  const inColours = { ...pictures[0], material: colours, outlines: { ink: colours.ink } };
  const [tinted] = await thumbnails(page, inColours, [inColours.light]);
  expect(tellApart(seen[0], { ...seen[0], own: tinted })).toBe(false);
});
