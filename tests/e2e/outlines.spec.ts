import type { Page } from '@playwright/test';
import type { PNG } from 'pngjs';
import { follow, openPlayground, readDrawing, savePicture, writtenHash } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { changedShare, inkRun, meanInk, WHOLE } from './pictures.js';

test.use({ viewport: { width: 640, height: 480 } });

/** A sphere in the middle of the picture. The light from the left leaves its left side bare paper. */
const SPHERE =
  'model=sphere&mapSize=64&mapTones=4&camera=0,0,6,0,0,0&lightAzimuth=-70&lightElevation=0&lightStrength=150';
/** Outlines of one width, without a hand, closed. */
const RULED = 'outlineShade=0&outlineLost=0&outlineHand=0';
/** Rows around the middle, as shares of the height. */
const ROWS = [0.4, 0.44, 0.48, 0.52, 0.56, 0.6];

/** Distance from the middle of a picture to the leftmost ink in each of the {@link ROWS}, in pixels. */
function leftmostInk(picture: PNG): number[] {
  return ROWS.map((share) => {
    const row = Math.round(share * picture.height);
    const { start } = inkRun(picture, row);
    return Math.hypot(picture.width / 2 - start, picture.height / 2 - row);
  });
}

/** Mean width of the leftmost ink in the {@link ROWS}, in pixels. */
function leftmostWidth(picture: PNG): number {
  const widths = ROWS.map((share) => inkRun(picture, Math.round(share * picture.height)).width);
  return widths.reduce((sum, width) => sum + width) / widths.length;
}

async function openFold(page: Page): Promise<void> {
  await page.setViewportSize({ width: 840, height: 480 });
  await page.getByRole('button', { name: 'Outlines', exact: true }).press('Enter');
}

test('a closed contour is drawn also where the light leaves the paper bare, and none where edges are lost', async ({
  page,
}) => {
  await openPlayground(page, `${SPHERE}&outlines=off`);
  const bare = leftmostInk(await readDrawing(page));
  await openPlayground(page, `${SPHERE}&${RULED}`);
  const outlined = leftmostInk(await readDrawing(page));
  const radius = Math.max(...outlined);
  expect(Math.min(...outlined), 'the contour is a circle').toBeGreaterThan(radius - 2);
  expect(Math.max(...bare), 'no stroke begins near it').toBeLessThan(radius - 15);
  await openPlayground(page, `${SPHERE}&${RULED.replace('Lost=0', 'Lost=100')}`);
  expect(Math.max(...leftmostInk(await readDrawing(page))), 'the contour is open').toBeLessThan(radius - 15);
});

test('a link without outlines opens without them; undo brings back what was switched off', { tag: '@all' }, async ({
  page,
}) => {
  await openPlayground(page, `${SPHERE}&outlines=off`);
  await openFold(page);
  const without = await readDrawing(page);
  const outlines = page.getByLabel('Outlines', { exact: true });
  await expect(outlines).toHaveValue('None');
  await expect(page.getByLabel('Outline width')).toBeHidden();
  await outlines.selectOption('Drawn');
  const drawn = await readDrawing(page);
  expect(meanInk(drawn)).toBeGreaterThan(meanInk(without));
  expect(await writtenHash(page)).not.toContain('outlines=off');
  // Quick changes of one control are one step, but not across Undo and Redo.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => changedShare(without, await readDrawing(page))).toBe(0);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect.poll(async () => changedShare(drawn, await readDrawing(page))).toBe(0);
  await outlines.selectOption('None');
  expect(changedShare(without, await readDrawing(page))).toBe(0);
  expect(await writtenHash(page)).toContain('outlines=off');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => changedShare(drawn, await readDrawing(page))).toBe(0);
});

test('width, weights and hand of the outlines have labels and change the drawing', { tag: '@all' }, async ({
  page,
}) => {
  await openPlayground(page, 'model=cube&mapSize=64&mapTones=4');
  await openFold(page);
  let before = await readDrawing(page);
  for (const [label, value] of [
    ['Outline width', '5'],
    ['Contours', '200'],
    ['Creases', '0'],
    ['Shade', '0'],
    ['Hand', '4'],
  ]) {
    const field = page.getByLabel(label, { exact: true });
    await expect(field).toBeVisible();
    await field.fill(value);
    await field.press('Enter');
    const after = await readDrawing(page);
    expect(changedShare(before, after), label).toBeGreaterThan(0.0005);
    before = after;
  }
  for (const label of ['Inner contours', 'Borders', 'Lost edges', 'Accents']) {
    await expect(page.getByLabel(label, { exact: true })).toBeVisible();
  }
  await expect(page.getByLabel('Suggestive', { exact: true })).toBeVisible();
  expect(await writtenHash(page)).toMatch(/outlineWidth=5&outlineContours=200.*outlineHand=4/);
  await page.reload();
  expect(changedShare(before, await readDrawing(page))).toBe(0);
});

test('outlines of a saved picture are wider by as much as the picture', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, `${SPHERE}&${RULED}&outlineWidth=4&pictureSize=2`);
  const shown = await readDrawing(page);
  const saved = await savePicture(page);
  expect(saved.width).toBe(2 * shown.width);
  expect(leftmostWidth(shown)).toBeGreaterThan(3);
  expect(leftmostWidth(shown)).toBeLessThan(5.5);
  expect(leftmostWidth(saved) / leftmostWidth(shown)).toBeCloseTo(2, 0);
});

test.describe('with reduced motion', () => {
  test.use({ reducedMotion: 'reduce' });

  test('a model that moves has outlines, which follow its pose', { tag: '@all' }, async ({ page }) => {
    const fish = 'model=fish&mapSize=64&mapTones=4&lightStrength=200&reflectedLight=60';
    await openPlayground(page, `${fish}&outlines=off`);
    const without = meanInk(await readDrawing(page), WHOLE);
    await openPlayground(page, fish);
    const posed = await readDrawing(page);
    expect(meanInk(posed)).toBeGreaterThan(1.05 * without);
    const written = (await writtenHash(page)).slice(1);
    await follow(page, `${written}&outlineContours=0&outlineCreases=0&outlineBorders=0`);
    expect(meanInk(await readDrawing(page))).toBeCloseTo(without, 4);
  });
});
