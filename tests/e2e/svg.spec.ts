import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { BUNDLE, describeBundle } from '../../src/viewer/files/bundle.js';
import { drop, openPlayground, readDrawing, ready, savePicture } from '../../tools/browser/playground.js';
import { file } from '../../tools/modelFiles/modelFiles.js';
import { zip } from '../../tools/modelFiles/sceneWriters.js';
import { expect, test } from '../browser/test.js';
import { buildCommand, drawByCommand } from './builtCommand.js';
import { changedShare, meanInk } from './pictures.js';

test.use({ viewport: { width: 900, height: 640 }, contextOptions: { reducedMotion: 'reduce' } });

/** The sheet of most tests, and its pixels in print. */
const SHEET = 'pictureSize=own&pictureWidth=120&pictureHeight=80&pictureDpi=150';
const [WIDE, HIGH] = [709, 472];
const LINES = `technique=engraving&model=cube&outlineLost=0&${SHEET}`;
const STROKES = `technique=hatching&model=cube&mapSize=64&mapTones=4&shadows=on&ground=shadow&${SHEET}&pictureMargin=0`;

/** Opens the settings of pictures, unless they are open. */
async function openPicture(page: Page): Promise<void> {
  const group = page.getByRole('button', { name: 'Picture', exact: true });
  if (!(await group.isVisible())) await page.locator('#toggle-card').click();
  if (!(await page.getByRole('button', { name: 'Save SVG, as lines' }).isVisible())) await group.click();
}

async function savedSvg(page: Page): Promise<string> {
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save SVG, as lines' }).click();
  return readFile(await (await download).path(), 'utf8');
}

/** A file as the browser draws it, on a page that shows nothing else. */
async function rasterized(page: Page, svg: string, width: number, height: number): Promise<PNG> {
  const blank = await page.context().newPage();
  await blank.goto('/tests/browser/blank.html');
  const data = await blank.evaluate(
    async ([text, wide, high]) => {
      const image = new Image();
      image.src = `data:image/svg+xml;base64,${btoa(text)}`;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: wide, height: high });
      canvas.getContext('2d')!.drawImage(image, 0, 0, wide, high);
      return canvas.toDataURL();
    },
    [svg, width, height] as const,
  );
  await blank.close();
  const picture = PNG.sync.read(Buffer.from(data.split(',')[1], 'base64'));
  await test.info().attach('drawn', { body: PNG.sync.write(picture), contentType: 'image/png' });
  return picture;
}

/** The picture within a file, as it lies there. */
function pictureIn(svg: string): PNG | undefined {
  const base64 = /<image [^>]*href="data:image\/png;base64,([^"]+)"/.exec(svg)?.[1];
  return base64 === undefined ? undefined : PNG.sync.read(Buffer.from(base64, 'base64'));
}

/** The share of pixels that differ by more than a third. */
function farShare(a: PNG, b: PNG): number {
  let far = 0;
  for (let i = 0; i < a.data.length; i += 4) if (Math.abs(a.data[i] - b.data[i]) > 85) far++;
  return far / (a.data.length / 4);
}

const layersOf = (svg: string): string[] => [...svg.matchAll(/inkscape:label="([^"]+)"/g)].map(([, label]) => label);

/** The first and the last column and row, in pixels, that are not the colour of the corner. */
function inkBox({ data, width, height }: PNG): [left: number, right: number, top: number, bottom: number] {
  const paper = data.readUInt32LE(0);
  const box: [number, number, number, number] = [width, 0, height, 0];
  for (let pixel = 0; pixel < width * height; pixel++) {
    if (data.readUInt32LE(4 * pixel) === paper) continue;
    const [x, y] = [pixel % width, Math.floor(pixel / width)];
    box[0] = Math.min(box[0], x);
    box[1] = Math.max(box[1], x);
    box[2] = Math.min(box[2], y);
    box[3] = Math.max(box[3], y);
  }
  return box;
}

test('the drawing is smaller and whole within margins; margins without room are refused, and too large ones are limited', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, LINES);
  await openPicture(page);
  const margin = page.getByRole('spinbutton', { name: 'SVG margin' });
  await expect(margin).toHaveValue('10');
  // Ten pixels to a millimetre.
  const boxes: Record<string, ReturnType<typeof inkBox>> = {};
  for (const value of ['0', '25']) {
    await margin.fill(value);
    await margin.press('Enter');
    const svg = await savedSvg(page);
    expect(svg).toContain('width="120mm" height="80mm"');
    boxes[value] = inkBox(await rasterized(page, svg, 1200, 800));
  }
  await expect(page).toHaveURL(/pictureMargin=25/);
  const [, , bareTop, bareBottom] = boxes[0];
  const [left, right, top, bottom] = boxes[25];
  expect(Math.min(left, 1200 - right, top, 800 - bottom)).toBeGreaterThanOrEqual(249);
  expect((bottom - top) / (bareBottom - bareTop)).toBeCloseTo(30 / 80, 1);
  expect(top + bottom).toBeGreaterThan(bareTop + bareBottom - 60);

  await margin.fill('40');
  await margin.press('Enter');
  await page.getByRole('button', { name: 'Save SVG, as lines' }).click();
  await expect(page.locator('#status')).toHaveText(
    'That did not work: margins of 40 mm leave no room on a sheet of 120 × 80 mm. Make them smaller.',
  );
  await margin.fill('1e9');
  await margin.press('Enter');
  await expect(margin).toHaveValue('100');
  // The size of the page has none.
  await page.getByLabel('Size', { exact: true }).first().selectOption('As on the page');
  await expect(margin).toBeHidden();
});

test('cut to the drawing, its lines are as fine as on the whole sheet', { tag: '@all' }, async ({ page }) => {
  const count = async (hash: string): Promise<number> => {
    await openPlayground(page, hash);
    await openPicture(page);
    return (await savedSvg(page)).split('<path').length;
  };
  const whole = await count(`${LINES}&pictureMargin=0`);
  const cut = await count(`${LINES}&pictureCrop=drawing`);
  expect(cut / whole).toBeGreaterThan(0.97);
  expect(cut / whole).toBeLessThan(1.03);
});

test('strokes of a map leave as a picture below the outlines, which are not in it; a pen leaves them out', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, `${STROKES}&outlines=off`);
  const bare = await savePicture(page);
  await openPlayground(page, STROKES);
  const whole = await savePicture(page);
  await openPicture(page);
  const framed = await readDrawing(page);
  const svg = await savedSvg(page);
  await expect(page.locator('#status')).toHaveText(
    /^Saved as SVG, its strokes as a picture: 120 × 80 mm, \d+ paths, 150 dpi\.$/,
  );
  expect(layersOf(svg)).toEqual(['0 picture', '1 outlines']);
  const picture = pictureIn(svg)!;
  expect([picture.width, picture.height]).toEqual([WIDE, HIGH]);
  expect(changedShare(picture, bare)).toBe(0);
  // With its outlines it equals the file that the page saves: the same ink in the same places.
  const drawn = await rasterized(page, svg, WIDE, HIGH);
  expect(meanInk(drawn) / meanInk(whole)).toBeCloseTo(1, 1);
  const [withLines, without] = [farShare(drawn, whole), farShare(bare, whole)];
  test.info().annotations.push({ type: 'far from the page', description: `${withLines}, without lines ${without}` });
  expect(withLines).toBeLessThan(0.2 * without);
  // The page has its outlines again.
  expect(changedShare(framed, await readDrawing(page))).toBe(0);

  await page.getByLabel('Ground', { exact: true }).last().selectOption('Transparent');
  const clear = await savedSvg(page);
  expect(clear).not.toContain('<rect');
  expect(pictureIn(clear)!.data[3]).toBe(0);

  await page.getByLabel('SVG', { exact: true }).selectOption('Lines, for a pen plotter');
  const pen = await savedSvg(page);
  await expect(page.locator('#status')).toHaveText(
    /^Saved as SVG without its strokes, which a pen cannot draw: 120 × 80 mm, \d+ paths, \d\.\d m of line, about \d+ min on an AxiDraw\.$/,
  );
  expect(layersOf(pen)).toEqual(['1 outlines']);
  await openPlayground(page, `${STROKES}&outlines=off&pictureSvg=pen`);
  await openPicture(page);
  await page.getByRole('button', { name: 'Save SVG, as lines' }).click();
  await expect(page.locator('#status')).toHaveText(
    'That did not work: there are no lines: the strokes come from a map, which a pen cannot draw.',
  );
});

test('a plot is seen before it is saved: path by path, with its layers and pens, and where ink lies several times', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, `${LINES}&pictureSvg=pen&picturePens=two&picturePenA=1c1a17&picturePenB=d2382c`);
  await openPicture(page);
  await page.getByRole('button', { name: 'Preview the plot' }).click();
  const plot = page.getByRole('dialog', { name: 'The plot' });
  await expect(plot).toBeVisible({ timeout: 60_000 });
  const said = plot.locator('#plot-said');
  const [, all] = /path ([\d,]+) of \1$/.exec((await said.textContent())!)!;
  await expect(plot.getByRole('row')).toHaveText([/black|#1c1a17.*min.*m.*lift/]);
  // The share of the sheet that is not paper, by the pixels of its canvas.
  const inked = () =>
    plot.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      let dark = 0;
      for (let i = 0; i < data.length; i += 4) dark += Number(data[i] < 128);
      return dark / (data.length / 4);
    });
  await expect.poll(inked).toBeGreaterThan(0.005);
  const whole = await inked();
  await plot.getByRole('slider', { name: 'Paths drawn' }).fill('1');
  await expect(said).toContainText(`path 1 of ${all}`);
  await expect.poll(inked).toBeLessThan(0.5 * whole);
  const first = await inked();
  expect(first).toBeGreaterThan(0);
  await plot.getByRole('button', { name: 'One path on' }).click();
  await expect(said).toContainText(`path 2 of ${all}`);
  await expect.poll(inked).toBeGreaterThan(first);
  await plot.getByRole('button', { name: 'Play' }).click();
  await expect(said).toContainText(`path ${all} of ${all}`, { timeout: 60_000 });
  await expect.poll(inked).toBeCloseTo(whole, 6);
  await plot.getByLabel('Ink map').check();
  await expect(said).toContainText(/% of the ink lies three times or more\.$/);
  await expect(plot.getByRole('button', { name: 'Play' })).toBeDisabled();
  const download = page.waitForEvent('download');
  await plot.getByRole('button', { name: 'Save SVG' }).click();
  const svg = await readFile(await (await download).path(), 'utf8');
  expect([...svg.matchAll(/<path /g)]).toHaveLength(Number(all.replace(',', '')));
  await expect(plot).toBeHidden();
  await expect(page.locator('#status')).toHaveText(/^Saved as SVG: 120 × 80 mm, .*AxiDraw\.$/);
});

test('a comparison leaves as the technique of the page alone', { tag: '@all' }, async ({ page }) => {
  const look = `technique=engraving&model=cube&shadows=off&ground=none&pictureMargin=0&${SHEET}`;
  await openPlayground(page, look);
  await openPicture(page);
  const alone = await savedSvg(page);
  await openPlayground(page, `${look}&compare=hatching&mapSize=64&mapTones=4`);
  await openPicture(page);
  const compared = await savedSvg(page);
  await expect(page.locator('#status')).toHaveText(/It shows one technique, without the comparison\.$/);
  expect(compared === alone).toBe(true);
});

/** Looks, views and lights: one with shadows and dark hollows, and one of composition, other lights and hidden lines. */
const LINKS = {
  shaded:
    'technique=engraving&direction=auto&shadows=on&ground=shadow&shadowStrokes=cross&occlusion=100&hollowStrength=100&camera=2.2725582,1.480766,4.4858494,0.0124,-0.053,0.01137',
  composed:
    'preset=pen&technique=engraving&background=on&depth=on&focus=on&vignette=40&lightKind=point&lightAzimuth=-60&lightElevation=20&lightFollows=viewer&secondLight=opposite&upAxis=z&outlineHidden=dashed&camera=3,2,3,0,0,0',
};

test.describe('page and command', () => {
  // The card with the settings lies beside the drawing.
  const viewport = { width: 1402, height: 714 };
  test.use({ viewport });

  let work: string;
  test.beforeAll(async () => {
    work = await mkdtemp(join(tmpdir(), 'three-hatching-'));
    await buildCommand();
  });
  test.afterAll(() => rm(work, { recursive: true }));

  const path = 'examples/models/still-life.glb';
  for (const [name, link] of Object.entries(LINKS)) {
    test(`the same link is the same file by the page and by the command: ${name}`, { tag: '@all' }, async ({
      page,
    }) => {
      test.slow();
      await openPlayground(page, 'model=cube');
      await openPicture(page);
      // A size that is a whole number of tenths of a millimetre, as sheets are.
      const canvas = (await page.locator('#drawing').boundingBox())!;
      await page.setViewportSize({
        width: viewport.width + 960 - Math.round(canvas.width),
        height: viewport.height + 624 - Math.round(canvas.height),
      });
      const model = await readFile(path);
      const bundle = zip({ [BUNDLE.description]: describeBundle(link), [`${BUNDLE.model}still-life.glb`]: model }, 0);
      await drop(page, [file('still-life.zip', Buffer.from(bundle))]);
      await expect(page.locator('#model-name')).toHaveText('still-life.glb');
      await ready(page);
      const ofPage = await savedSvg(page);
      expect(ofPage).toContain('width="254mm" height="165.1mm"');
      const out = join(work, `${name}.svg`);
      const paper = /<rect [^>]*fill="([^"]+)"/.exec(ofPage)![1];
      const sheet = ['--sheet', '254x165.1', '--margin', '0', '--paper', paper];
      await drawByCommand(path, '--link', `https://example.test/#${link}`, ...sheet, '--out', out);
      const ofCommand = await readFile(out, 'utf8');
      await test.info().attach('of the page', { body: ofPage, contentType: 'image/svg+xml' });
      await test.info().attach('of the command', { body: ofCommand, contentType: 'image/svg+xml' });
      // The last bits of some functions differ between Node and the browser, so that where two ways are equally long a path may begin at its other end.
      const [pageLines, commandLines] = [ofPage, ofCommand].map((text) => text.split('\n'));
      expect(commandLines.length).toBe(pageLines.length);
      const differing = pageLines.filter((line, i) => line !== commandLines[i]);
      expect(differing.length).toBeLessThan(0.001 * pageLines.length);
    });
  }
});
