import type { PNG } from 'pngjs';
import {
  enterLink,
  follow,
  idle,
  openPlayground,
  readDrawing,
  savePicture,
  writtenHash,
} from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';
import { cases } from '../selection.mjs';
import { changedShare, edgeSpacing, greyShare, likeness, meanInk, type Region } from './pictures.js';
import { widenLetters } from './wideLetters.js';

test.use({ viewport: { width: 640, height: 480 } });

/** Within the sphere, or the front face of the cube. */
const MIDDLE: Region = { left: 0.4, top: 0.34, right: 0.6, bottom: 0.66 };
const CUBE = 'model=cube&lightAzimuth=40&lightElevation=20&lightStrength=100&reflectedLight=0';

test('anchored strokes are black and white', { tag: '@all' }, async ({ page }) => {
  const view = 'model=sphere&camera=0,0,6,0,0,0&lightAzimuth=60&lightElevation=10';
  await openPlayground(page, `${view}&edge=0`);
  expect(greyShare(await readDrawing(page), MIDDLE)).toBeLessThan(0.005);
  await openPlayground(page, `${view}&technique=adjacency`);
  expect(greyShare(await readDrawing(page), MIDDLE)).toBeGreaterThan(0.3);
  await openPlayground(page, `${view}&technique=adjacencyCrisp&edge=0`);
  // The remaining grey is at the edges of triangles, which are antialiased.
  expect(greyShare(await readDrawing(page), MIDDLE)).toBeLessThan(0.03);
});

for (const [left, right] of [
  ['triangle', 'hatching'],
  ['adjacencyCrisp', 'adjacency'],
] as const) {
  test(`two techniques are drawn side by side, split at the divider: ${left} and ${right}`, { tag: '@all' }, async ({
    page,
  }) => {
    const view = 'model=knot&lightAzimuth=-30&mapSize=64&mapTones=4&outlines=off';
    await openPlayground(page, `${view}&technique=${right}`);
    const rightAlone = await readDrawing(page);
    await openPlayground(page, `${view}&technique=${left}`);
    const leftAlone = await readDrawing(page);
    await openPlayground(page, `${view}&technique=${right}&compare=${left}`);
    const divider = page.getByRole('slider', { name: /Divider between/ });
    await divider.focus();
    for (let i = 0; i < 5; i++) await divider.press('ArrowLeft');
    await expect(divider).toHaveAttribute('aria-valuenow', '40');
    const both = await readDrawing(page);
    const split = Math.round(0.4 * both.width);
    expect(differingColumns(both, leftAlone).every((column) => column >= split)).toBe(true);
    expect(differingColumns(both, rightAlone).every((column) => column < split)).toBe(true);
    expect(differingColumns(both, rightAlone).length).toBeGreaterThan(20);
  });
}

function differingColumns(a: PNG, b: PNG): number[] {
  const columns = new Set<number>();
  for (let i = 0; i < a.data.length; i += 4) {
    if (a.data.readUInt32LE(i) !== b.data.readUInt32LE(i)) columns.add((i / 4) % a.width);
  }
  return [...columns];
}

test('lines follow the form as soon as that is baked, also where a link asks for it', { tag: '@all' }, async ({
  page,
}) => {
  const view = 'model=torus&technique=engraving&outlines=off&lightAzimuth=30';
  await openPlayground(page, view);
  const lit = await readDrawing(page);
  await follow(page, `${view}&direction=form`);
  await idle(page);
  const formed = await readDrawing(page);
  expect(changedShare(formed, lit)).toBeGreaterThan(0.1);
  for (const direction of ['form', 'auto']) {
    await openPlayground(page, `${view}&direction=${direction}`);
    await idle(page);
    expect(changedShare(formed, await readDrawing(page)), direction).toBeLessThan(0.01);
  }
});

test('strokes follow the form once it is baked, and the light again when it is chosen', { tag: '@all' }, async ({
  page,
}) => {
  const view = 'model=shell&technique=hatching&mapSize=64&mapTones=4&outlines=off&lightAzimuth=30';
  const following = `${view}&direction=form`;
  await openPlayground(page, following);
  await idle(page);
  const formed = await readDrawing(page);
  await expect(page.getByLabel('Direction', { exact: true })).toHaveValue('The form');
  await follow(page, view);
  expect(changedShare(formed, await readDrawing(page))).toBeGreaterThan(0.05);
  await follow(page, following);
  expect(changedShare(formed, await readDrawing(page))).toBeLessThan(0.01);
});

test('a picture that is saved while the form is baked waits for it', { tag: '@all' }, async ({ page }) => {
  const view = 'model=torus&technique=engraving&outlines=off&lightAzimuth=30';
  await openPlayground(page, view);
  const lit = await savePicture(page);
  await enterLink(page, `${view}&direction=form`);
  // The page fetches what follows links with the first one.
  await expect(page.getByLabel('Direction', { exact: true })).toHaveValue('The form');
  const atOnce = await savePicture(page);
  await idle(page);
  expect(changedShare(atOnce, lit)).toBeGreaterThan(0.1);
  expect(changedShare(atOnce, await savePicture(page))).toBe(0);
});

test('a preset sets the whole style at once, and can be undone', { tag: '@more' }, async ({ page }) => {
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, 'model=sphere');
  const presets = page.getByRole('group', { name: 'Presets' });
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(presets.locator('[aria-pressed=true]')).toHaveCount(0);
  await expect(undo).toBeDisabled();
  const first = await readDrawing(page);
  const seen = [first];
  const names = [
    ...cases([], ['Pen', 'Cross-hatching', 'Engraving', 'Banknote', 'Technical', 'Woodcut', 'Charcoal']),
    'Stipple',
    'Pencil',
  ];
  for (const name of names) {
    await presets.getByRole('button', { name, exact: true }).click();
    await expect(presets.getByRole('button', { name, exact: true })).toHaveAttribute('aria-pressed', 'true');
    const picture = await readDrawing(page);
    for (const other of seen) expect(changedShare(other, picture), name).toBeGreaterThan(0.05);
    seen.push(picture);
  }
  expect(await writtenHash(page)).toContain('technique=dryMedia');
  await page.getByRole('button', { name: 'More' }).click();
  const width = page.getByLabel('Stroke width');
  await width.fill('5');
  await width.press('Enter');
  await expect(presets.locator('[aria-pressed=true]')).toHaveCount(0);

  await undo.click();
  expect(changedShare(seen.at(-1)!, await readDrawing(page))).toBe(0);
  await page.keyboard.press('Control+z');
  await expect(presets.getByRole('button', { name: 'Stipple' })).toHaveAttribute('aria-pressed', 'true');
  for (let step = 1; step < names.length; step++) await undo.click();
  await expect(undo).toBeDisabled();
  expect(changedShare(first, await readDrawing(page))).toBe(0);
});

test('a preset gives the same picture whatever ground, shadows and hollows came before', { tag: '@all' }, async ({
  page,
}) => {
  const pictures: PNG[] = [];
  for (const before of ['', '&shadows=on&ground=floor&occlusion=20&shadowStrokes=reorient&debugView=tone']) {
    await page.setViewportSize({ width: 840, height: 480 });
    await openPlayground(page, `model=column${before}`);
    await page.getByRole('group', { name: 'Presets' }).getByRole('button', { name: 'Technical' }).click();
    pictures.push(await readDrawing(page));
  }
  expect(changedShare(pictures[0], pictures[1])).toBe(0);
});

test('every button of a preset holds its name, also with wide letters and under a thumb', { tag: '@all' }, async ({
  page,
}) => {
  for (const [width, height] of [
    [840, 480],
    [360, 640],
  ] as const) {
    await page.setViewportSize({ width, height });
    await openPlayground(page, `model=cube&mapSize=64&mapTones=4&outlines=off&camera=0,0,${width},0,0,0`);
    if (width === 360) await page.locator('#toggle-card').click();
    await widenLetters(page, '0.03em');
    const buttons = page.getByRole('group', { name: 'Presets' }).getByRole('button');
    await expect(buttons).toHaveCount(10);
    const bar = (await page.locator('#presets').boundingBox())!;
    for (const button of await buttons.all()) {
      const box = (await button.boundingBox())!;
      expect(box.x + box.width).toBeLessThanOrEqual(bar.x + bar.width);
      expect(box.y + box.height).toBeLessThanOrEqual(bar.y + bar.height + 1);
      if (width === 360) expect(box.height).toBeGreaterThanOrEqual(44);
      expect(await button.evaluate((one) => one.scrollWidth - one.clientWidth)).toBe(0);
    }
  }
});

test('shadows of its own fall on a model, under every kind of light', { tag: '@all' }, async ({ page }) => {
  for (const lightKind of ['directional', 'point', 'spot']) {
    const view = `model=teapot&lightKind=${lightKind}&lightAzimuth=-70&lightElevation=60&debugView=tone&outlines=off&mapSize=64&mapTones=4`;
    await openPlayground(page, view);
    const without = await readDrawing(page);
    await openPlayground(page, `${view}&shadows=on`);
    expect(changedShare(without, await readDrawing(page)), lightKind).toBeGreaterThan(0.002);
  }
});

test('a model stands on its shadow or on a floor; a picture without paper keeps only the shadow', {
  tag: '@all',
}, async ({ page }) => {
  // The whole shadow lies on the sheet: it dissolves sooner where it would leave it.
  const view =
    'model=sphere&camera=1.4,1.1,6.2,0,0,0&lightAzimuth=-60&lightElevation=50&outlines=off&technique=engraving&screenSpaceShare=100';
  const below: Region = { left: 0, top: 0.6, right: 1, bottom: 0.9 };
  const ink: Record<string, number> = {};
  for (const look of ['none', 'shadow', 'floor']) {
    await openPlayground(page, `${view}&shadows=on&ground=${look}&shadowTone=100&shadowFade=0&pictureGround=strokes`);
    ink[look] = meanInk(await readDrawing(page), below);
  }
  expect(ink.shadow - ink.none).toBeGreaterThan(0.03);
  // The floor is light, and its lines are thin on so small a sheet.
  expect(ink.floor - ink.shadow).toBeGreaterThan(0.015);
  // By default it is lighter, and dissolves.
  await openPlayground(page, `${view}&shadows=on&ground=shadow&pictureGround=strokes`);
  const light = meanInk(await readDrawing(page), below) - ink.none;
  expect(light).toBeGreaterThan(0.005);
  expect(light).toBeLessThan(0.6 * (ink.shadow - ink.none));
  // Crossing shadows are another drawing of the same tone.
  await openPlayground(page, `${view}&shadows=on&ground=floor`);
  const darkened = await readDrawing(page);
  await openPlayground(page, `${view}&shadows=on&ground=floor&shadowStrokes=cross`);
  const crossed = await readDrawing(page);
  expect(changedShare(darkened, crossed)).toBeGreaterThan(0.01);
  expect(Math.abs(meanInk(darkened, below) - meanInk(crossed, below))).toBeLessThan(0.02);
  // Shadows follow the light.
  await openPlayground(page, `${view.replace('-60', '60')}&shadows=on&ground=shadow`);
  const right: Region = { left: 0.5, top: 0.6, right: 1, bottom: 0.9 };
  const left: Region = { left: 0, top: 0.6, right: 0.5, bottom: 0.9 };
  const turned = await readDrawing(page);
  expect(meanInk(turned, left)).toBeGreaterThan(meanInk(turned, right));

  await openPlayground(page, `${view}&shadows=on&ground=shadow&pictureGround=strokes`);
  const saved = await savePicture(page);
  const clear = saved.data.filter((_, i) => i % 4 === 3 && saved.data[i] === 0).length / (saved.width * saved.height);
  expect(clear).toBeGreaterThan(0.5);
  expect(clear).toBeLessThan(0.98);
});

test('a picture saved at twice the size has the same strokes', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, `${CUBE}&camera=0,0,5,0,0,0&pictureSize=2`);
  const shown = await readDrawing(page);
  const large = await savePicture(page);
  expect(large.width).toBe(2 * shown.width);
  expect(likeness(shown, large, MIDDLE)).toBeGreaterThan(0.9);
  // Control: drawings with different strokes are not alike.
  await openPlayground(page, `${CUBE}&camera=0,0,5,0,0,0&mapSeed=2`);
  expect(likeness(await readDrawing(page), large, MIDDLE)).toBeLessThan(0.4);
});

test('strokes sized on the screen keep their spacing when the camera comes nearer, others grow', {
  tag: '@all',
}, async ({ page }) => {
  const faceDepth = 1 / Math.sqrt(3);
  const spacing = async (constancy: number, distanceToFace: number): Promise<number> => {
    const camera = `0,0,${(faceDepth + distanceToFace).toFixed(3)},0,0,0`;
    await openPlayground(page, `${CUBE}&screenSpaceShare=${constancy}&tilesPerObjectUnit=1&camera=${camera}`);
    return edgeSpacing(await readDrawing(page), MIDDLE);
  };
  const near = await spacing(100, 1.4);
  const between = await spacing(100, 1.98);
  const far = await spacing(100, 2.8);
  expect(near / far).toBeGreaterThan(0.9);
  expect(near / far).toBeLessThan(1.1);
  // In between, strokes of two sizes fade into each other. The spacing must not jump there.
  expect(Math.max(near, between, far) / Math.min(near, between, far)).toBeLessThan(1.6);
  expect((await spacing(0, 1.4)) / (await spacing(0, 2.8))).toBeGreaterThan(1.4);
});
