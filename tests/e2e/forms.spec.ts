import { dragLamp, lampPlace, middleOf, readDrawing, ready, writtenHash } from '../../tools/browser/playground.js';
import { file, octahedronPly } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { changedShare } from './pictures.js';

test.use({ viewport: { width: 400, height: 300 } });

test('in a frame of another page: the drawing and its lamp alone, and the wheel is the page’s', async ({ page }) => {
  const link = 'technique=hatching&model=cube&mapSize=64&mapTones=4';
  await page.goto(`./?embed#${link}`);
  await ready(page);
  for (const part of ['#card', '.bar', '#model-caption']) await expect(page.locator(part)).toBeHidden();
  expect(await page.locator('#viewport').boundingBox()).toEqual({ x: 0, y: 0, width: 400, height: 300 });
  const { azimuth } = await lampPlace(page);
  const first = await readDrawing(page);
  const { x, y } = await middleOf(page, '#viewport');
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -400);
  expect(changedShare(first, await readDrawing(page))).toBe(0);
  await page.mouse.click(x, y);
  await page.mouse.wheel(0, -400);
  await expect.poll(async () => changedShare(first, await readDrawing(page))).toBeGreaterThan(0.02);
  await dragLamp(page, { x: 60, y: 10 });
  expect((await lampPlace(page)).azimuth).not.toBe(azimuth);
  // The address is that of the page around it.
  expect(await writtenHash(page)).toBe(`#${link}`);
  const home = page.getByRole('link', { name: 'Open the playground' });
  await home.evaluate((element) => element.addEventListener('click', (event) => event.preventDefault()));
  await home.click();
  expect(await home.getAttribute('href')).toContain('model=cube');
  expect(await home.getAttribute('href')).toContain('lightAzimuth=');
  expect(await home.getAttribute('href')).not.toContain('embed');
});

test('in a kiosk no link leads away, and an abandoned drawing is reset', { tag: '@all' }, async ({ page }) => {
  await page.clock.install();
  await page.goto('./?kiosk#technique=hatching&model=cube&mapSize=64&mapTones=4');
  await ready(page);
  for (const part of ['#card', '.bar', '#home']) await expect(page.locator(part)).toBeHidden();
  const first = await lampPlace(page);
  await page.locator('#lamp').press('ArrowLeft');
  expect((await lampPlace(page)).azimuth).not.toBe(first.azimuth);
  await page.evaluate(
    ({ name, text }) => {
      const data = new DataTransfer();
      data.items.add(new File([text], name));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }));
    },
    { name: 'octahedron.ply', text: file('octahedron.ply', octahedronPly).buffer.toString() },
  );
  await page.clock.fastForward(61_000);
  await expect.poll(async () => (await lampPlace(page)).azimuth).toBe(first.azimuth);
  await expect(page.locator('#model-name')).toHaveText('Cube');
});
