import { openPlayground, readDrawing } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { changedShare } from './pictures.js';

test.use({ viewport: { width: 820, height: 480 } });

test('a drawing of the gallery opens live by the keyboard, a surprise changes its hand, and Undo goes back', async ({
  page,
}) => {
  const pictures: string[] = [];
  page.on('request', (request) => {
    if (/gallery\/(?!preset-)/.test(request.url())) pictures.push(request.url());
  });
  await openPlayground(page, 'model=cube&mapSize=64&mapTones=4&outlines=off');
  const cube = await readDrawing(page);
  expect(pictures, 'before the gallery is opened').toEqual([]);
  const opener = page.getByRole('button', { name: 'Gallery' });
  await opener.press('Enter');
  const gallery = page.getByRole('region', { name: 'Gallery' });
  await expect(gallery.getByRole('button')).toHaveCount(17);
  await expect.poll(() => pictures.length).toBeGreaterThan(0);
  await page.keyboard.press('Escape');
  await expect(gallery).toBeHidden();
  await expect(opener).toBeFocused();

  await opener.press('Enter');
  await gallery.getByRole('button', { name: 'Knot' }).press('Enter');
  await expect(page.locator('#model-name')).toHaveText('Knot');
  const knot = await readDrawing(page);
  expect(changedShare(cube, knot)).toBeGreaterThan(0.1);
  await page.getByRole('button', { name: 'Surprise me' }).click();
  await expect.poll(async () => changedShare(knot, await readDrawing(page))).toBeGreaterThan(0.05);
  const undo = page.getByRole('button', { name: 'Undo' });
  await undo.click();
  expect(changedShare(knot, await readDrawing(page))).toBe(0);
  await undo.click();
  await expect(page.locator('#model-name')).toHaveText('Cube');
  expect(changedShare(cube, await readDrawing(page))).toBe(0);
});
