import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { middleOf, openPlayground, readDrawing, ready } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { changedShare, largestDifference } from './pictures.js';

test.use({ viewport: { width: 640, height: 480 }, contextOptions: { reducedMotion: 'reduce' } });

/** A scene with a ground and its shadow, strokes, lines and a coloured model. */
const LOOK = 'technique=hatching&model=cube&mapSize=64&mapTones=4&color=%23e0b070&shadows=on&ground=shadow';

async function saved(page: Page): Promise<Buffer> {
  const download = page.waitForEvent('download');
  await page.locator('#save-png').click();
  return readFile(await (await download).path());
}

/** Its size as programs read it from the file, in millimetres. */
function millimetresOf(file: Buffer): [number, number] {
  const at = file.indexOf('pHYs', 0, 'latin1') + 4;
  expect(file[at + 8], 'counted per metre').toBe(1);
  const { width, height } = PNG.sync.read(file);
  return [(1000 * width) / file.readUInt32BE(at), (1000 * height) / file.readUInt32BE(at + 4)];
}

/** The part of a picture that is not the colour of its corner. */
function inkedBox({ data, width, height }: PNG): { left: number; top: number; right: number; bottom: number } {
  const box = { left: width, top: height, right: 0, bottom: 0 };
  const paper = data.readUInt32LE(0);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (data.readUInt32LE(4 * (y * width + x)) === paper) continue;
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x + 1);
      box.top = Math.min(box.top, y);
      box.bottom = Math.max(box.bottom, y + 1);
    }
  }
  return box;
}

/** The part of a picture that is most like a smaller one: which is at most two pixels from where its ink begins. */
function partLike(small: PNG, whole: PNG): PNG {
  const { width, height } = small;
  const [inWhole, inSmall] = [inkedBox(whole), inkedBox(small)];
  const parts: PNG[] = [];
  for (let dy = -2; dy <= 2; dy++) {
    for (let dx = -2; dx <= 2; dx++) {
      const [left, top] = [inWhole.left - inSmall.left + dx, inWhole.top - inSmall.top + dy];
      if (left < 0 || top < 0 || left + width > whole.width || top + height > whole.height) continue;
      const part = new PNG({ width, height });
      PNG.bitblt(whole, part, left, top, width, height, 0, 0);
      parts.push(part);
    }
  }
  const differences = parts.map((part) => changedShare(small, part));
  return parts[differences.indexOf(Math.min(...differences))];
}

/** Layers over paper, the first one lowest. */
function stacked(layers: readonly PNG[], paper: readonly number[]): PNG {
  const sum = new PNG({ width: layers[0].width, height: layers[0].height });
  for (let i = 0; i < sum.data.length; i += 4) {
    sum.data.set([...paper, 255], i);
    for (const { data } of layers) {
      const alpha = data[i + 3] / 255;
      for (let k = 0; k < 3; k++) sum.data[i + k] = Math.round(sum.data[i + k] * (1 - alpha) + data[i + k] * alpha);
    }
  }
  return sum;
}

test('an A6 sheet has its size; cut to the drawing it is the same, but smaller; its layers add up to it', async ({
  page,
}) => {
  await openPlayground(page, `${LOOK}&pictureSize=a6&pictureDpi=150`);
  const shown = await readDrawing(page);
  const sheet = await saved(page);
  await expect(page.locator('#status')).toHaveText('Saved as PNG: 874 × 620 px, 148 × 105 mm, 150 dpi.');
  const whole = PNG.sync.read(sheet);
  expect([whole.width, whole.height]).toEqual([874, 620]);
  const pixel = 25.4 / 150;
  const [wide, high] = millimetresOf(sheet);
  expect(Math.abs(wide - 148)).toBeLessThan(pixel / 2 + 0.01);
  expect(Math.abs(high - 105)).toBeLessThan(pixel / 2 + 0.01);
  expect(changedShare(shown, await readDrawing(page))).toBe(0);
  // The same after the light has moved, which changes the composition of the sheet for its shadow.
  await page.locator('#lamp').focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight');
  const lit = await readDrawing(page);
  expect(changedShare(shown, lit)).toBeGreaterThan(0.01);
  const lamp = await middleOf(page, '#lamp');
  await saved(page);
  expect(changedShare(lit, await readDrawing(page))).toBe(0);
  expect(await middleOf(page, '#lamp')).toEqual(lamp);

  await openPlayground(page, `${LOOK}&pictureSize=a6&pictureDpi=150&pictureCrop=drawing`);
  const cut = PNG.sync.read(await saved(page));
  const inCut = inkedBox(cut);
  expect(cut.width).toBeLessThan(0.95 * whole.width);
  expect(Math.max(inCut.left, cut.width - inCut.right, inCut.top, cut.height - inCut.bottom)).toBeLessThan(12);
  expect(largestDifference(cut, partLike(cut, whole))).toBeLessThanOrEqual(2);

  await openPlayground(page, `${LOOK}&pictureSize=a6&pictureDpi=150&pictureLayers=apart`);
  const files = Object.entries(unzipSync(await saved(page)));
  await expect(page.locator('#status')).toHaveText(
    'Saved as 4 PNG images in a ZIP: 874 × 620 px, 148 × 105 mm, 150 dpi.',
  );
  expect(files.map(([name]) => name)).toEqual([
    'cube-1-colour.png',
    'cube-2-shadow.png',
    'cube-3-strokes.png',
    'cube-4-outline.png',
  ]);
  const layers = files.map(([, content]) => PNG.sync.read(Buffer.from(content)));
  for (const [i, layer] of layers.entries()) {
    const opaque = layer.data.filter((_, at) => at % 4 === 3 && layer.data[at] > 127).length / (874 * 620);
    test.info().annotations.push({ type: files[i][0], description: opaque.toFixed(4) });
    expect(opaque, files[i][0]).toBeGreaterThan(0.003);
    expect(layer.data[3]).toBe(0);
    await test.info().attach(files[i][0], { body: Buffer.from(files[i][1]), contentType: 'image/png' });
  }
  await test.info().attach('whole', { body: sheet, contentType: 'image/png' });
  const sum = stacked(layers, [0xf7, 0xf3, 0xe8]);
  await test.info().attach('stacked', { body: PNG.sync.write(sum), contentType: 'image/png' });
  const far = sum.data.filter((value, i) => Math.abs(value - whole.data[i]) > 48).length / (3 * 874 * 620);
  test.info().annotations.push({ type: 'far from the whole', description: far.toFixed(5) });
  expect(far).toBeLessThan(0.004);
});

test('the chosen sheet is framed over the drawing, which is composed for it; the saved file is the framed part', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, 'technique=engraving&outlines=off&model=column&pictureSize=a6&pictureDpi=150');
  const frame = page.locator('.sheet-frame');
  await expect(frame).toHaveCount(0);
  const before = await readDrawing(page);
  // The picture is the same without a preview.
  const unseen = PNG.sync.read(await saved(page));
  await page.locator('#toggle-card').click();
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  await expect(frame).toBeVisible();
  const view = (await page.locator('#viewport').boundingBox())!;
  for (const [turned, aspect] of [
    ['Portrait', 105 / 148],
    ['Landscape', 148 / 105],
  ] as const) {
    await page.getByRole('combobox', { name: 'Turned' }).selectOption(turned);
    const box = (await frame.boundingBox())!;
    expect(box.width / box.height).toBeCloseTo(aspect, 1);
    expect(box.x).toBeGreaterThan(view.x + 8);
    expect(box.y).toBeGreaterThan(view.y + 8);
    const shown = inkedBox(await readSheet(page));
    const print = PNG.sync.read(await saved(page));
    const printed = inkedBox(print);
    const scale = print.width / box.width;
    for (const side of ['left', 'right', 'top', 'bottom'] as const)
      expect(Math.abs(printed[side] - scale * shown[side]), `${turned}, ${side}`).toBeLessThan(2 * scale + 2);
    // A column fills the height of either sheet, with a margin.
    const share = (printed.bottom - printed.top) / print.height;
    expect(share).toBeGreaterThan(0.75);
    expect(share).toBeLessThan(0.93);
    if (turned === 'Portrait') expect([print.width, print.height]).toEqual([unseen.width, unseen.height]);
  }
  await page.getByRole('combobox', { name: 'Turned' }).selectOption('As suits the model');
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  await expect(frame).toBeHidden();
  await page.locator('#toggle-card').click();
  expect(changedShare(before, await readDrawing(page))).toBe(0);
});

/** The drawing within the frame of the sheet. */
async function readSheet(page: Page): Promise<PNG> {
  const [view, frame] = [
    (await page.locator('#viewport').boundingBox())!,
    (await page.locator('.sheet-frame').boundingBox())!,
  ];
  await page.locator('.sheet-frame').evaluate((element) => {
    element.style.visibility = 'hidden';
  });
  const whole = await readDrawing(page);
  await page.locator('.sheet-frame').evaluate((element) => {
    element.style.visibility = '';
  });
  const [left, top] = [Math.round(frame.x - view.x), Math.round(frame.y - view.y)];
  const part = new PNG({ width: Math.floor(frame.width) - 1, height: Math.floor(frame.height) - 1 });
  PNG.bitblt(whole, part, left, top, part.width, part.height, 0, 0);
  return part;
}

test.describe('on a dense screen', () => {
  test.use({ deviceScaleFactor: 2 });

  test('a picture of twice the page has the very strokes that are shown', { tag: '@all' }, async ({ page }) => {
    await openPlayground(page, `${LOOK}&pictureSize=2`);
    const shown = await readDrawing(page);
    const picture = PNG.sync.read(await saved(page));
    expect([picture.width, picture.height]).toEqual([shown.width, shown.height]);
    expect(changedShare(shown, picture)).toBeLessThan(0.01);
  });
});

test('tiles meet without a seam, and a large picture can be given up', { tag: '@all' }, async ({ page }) => {
  test.slow();
  // 3,496 pixels wide: with edges of tiles at 2,048, and elsewhere when it is cut.
  await openPlayground(page, `${LOOK}&pictureSize=a6&pictureDpi=600`);
  const whole = PNG.sync.read(await saved(page));
  expect([whole.width, whole.height]).toEqual([3496, 2480]);
  await openPlayground(page, `${LOOK}&pictureSize=a6&pictureDpi=600&pictureCrop=drawing`);
  const cut = PNG.sync.read(await saved(page));
  expect(cut.width).toBeGreaterThan(2200);
  expect(cut.width).toBeLessThan(3200);
  const same = partLike(cut, whole);
  const far = cut.data.filter((value, i) => Math.abs(value - same.data[i]) > 24).length / cut.data.length;
  test.info().annotations.push({
    type: 'seams',
    description: `${changedShare(cut, same)} of the pixels differ, ${far} of the values by more than 24`,
  });
  // The rest is rounding at a few edges of strokes. A seam would be a row of pixels, a 2,000th of all.
  expect(changedShare(cut, same)).toBeLessThan(0.001);
  expect(far).toBeLessThan(0.00002);

  await openPlayground(page, `${LOOK}&pictureSize=a2&pictureDpi=1200`);
  const shown = await readDrawing(page);
  const downloads: unknown[] = [];
  page.on('download', (one) => downloads.push(one));
  await page.locator('#save-png').click();
  await expect(page.locator('#status')).toHaveText('Drawing the picture…');
  await expect(page.locator('.cover')).toBeVisible();
  await page.locator('#cancel').click();
  await expect(page.locator('#status')).toHaveText('Cancelled; the drawing is as it was.');
  await expect(page.locator('.cover')).toHaveCount(0);
  await ready(page);
  expect(changedShare(shown, await readDrawing(page))).toBe(0);
  expect(downloads).toEqual([]);
});

test('the drawing leaves as lines: an SVG in millimetres, filled for print or for one pen', async ({ page }) => {
  await page.setViewportSize({ width: 400, height: 300 });
  await openPlayground(page, 'model=vase&technique=engraving&shadows=off&ground=none');
  const savedAs = async (): Promise<string> => {
    const file = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save SVG, as lines' }).click();
    const got = await file;
    expect(got.suggestedFilename()).toBe('vase.svg');
    return readFile(await got.path(), 'utf8');
  };
  await page.locator('#toggle-card').click();
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  const print = await savedAs();
  await expect(page.getByText(/^Saved as SVG: \d+ × \d+ mm, [\d,]+ paths\./)).toBeVisible();
  const layers = (text: string) => [...text.matchAll(/inkscape:label="([^"]+)"/g)].map(([, label]) => label);
  expect(layers(print)).toEqual(['1 outlines', '2 lines', '3 crossing']);
  // The page is 96 pixels to an inch.
  const canvas = (await page.locator('canvas').first().boundingBox())!;
  expect(Number(/width="([\d.]+)mm"/.exec(print)![1])).toBeCloseTo((canvas.width / 96) * 25.4, 0);
  expect(print).toContain('<rect');
  await page.getByLabel('SVG', { exact: true }).selectOption('Lines, for a pen plotter');
  await page.getByLabel('Size', { exact: true }).first().selectOption('A5 sheet');
  const pen = await savedAs();
  const sheet = /width="([\d.]+)mm" height="([\d.]+)mm"/.exec(pen)!.slice(1).map(Number);
  expect(sheet.sort((a, b) => a - b)).toEqual([148, 210]);
  expect(pen).not.toContain('<rect');
  expect(pen).toContain('stroke-width="0.3"');
});
