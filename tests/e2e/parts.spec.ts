import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { BUNDLE, describeBundle } from '../../src/viewer/files/bundle.js';
import { drop, openPlayground, readDrawing, ready, savePicture, writtenHash } from '../../tools/browser/playground.js';
import { tetrahedron } from '../../tools/modelFiles/GltfBuilder.js';
import { file, type TestFile } from '../../tools/modelFiles/modelFiles.js';
import { boxStl } from '../../tools/modelFiles/modelWriters.js';
import { zip } from '../../tools/modelFiles/sceneWriters.js';
import { expect, test } from '../browser/test.js';
import { changedShare, meanInk } from './pictures.js';

// Wide enough for the card.
test.use({ viewport: { width: 1000, height: 500 }, contextOptions: { reducedMotion: 'reduce' } });

const SMALL = 'technique=engraving&occlusion=0';

/** A box of an OBJ file, by its centre and its size. */
function box(name: string, [x, y, z]: readonly number[], [width, height, depth]: readonly number[]): string {
  const corners = Array.from(
    { length: 8 },
    (_, i) =>
      `v ${x + (i & 1 ? 0.5 : -0.5) * width} ${y + (i & 2 ? 0.5 : -0.5) * height} ${z + (i & 4 ? 0.5 : -0.5) * depth}`,
  );
  const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'];
  const relative = faces.map((face) => `f ${face.replace(/\d/g, (corner) => String(Number(corner) - 9))}`);
  return [`o ${name}`, ...corners, ...relative].join('\n');
}

/** A table with a ball-like box below it, so that hiding its top shows more. */
const table = file(
  'table.obj',
  [
    box('Top', [0, 1, 0], [4, 0.2, 4]),
    ...[-1.7, 1.7].flatMap((x) => [-1.7, 1.7].map((z) => box('Leg', [x, 0, z], [0.3, 1.8, 0.3]))),
    box('Box', [0, -0.5, 0], [1, 0.8, 1]),
  ].join('\n'),
);

/** Many boxes, as a file of a machine has. */
const manyParts = (count: number): TestFile =>
  file(
    'many.obj',
    Array.from({ length: count }, (_, i) =>
      box(i % 2 ? `Bolt ${i}` : `Plate ${i}`, [2 * (i % 70), 0, 2 * Math.floor(i / 70)], [1, 1, 1]),
    ).join('\n'),
  );

const fold = (page: Page) => page.locator('#parts > summary');
const eye = (page: Page, name: string) => page.getByRole('button', { name: `${name}, shown`, exact: true });

async function open(page: Page, ...files: TestFile[]): Promise<void> {
  await openPlayground(page, SMALL);
  await drop(page, files);
  await ready(page);
  await fold(page).click();
  // The part below the pointer would show.
  await page.mouse.move(300, 10);
}

test('parts of a joined mesh are hidden and shown, with undo, and a reload restores them', async ({ page }) => {
  await open(page, table);
  await expect(fold(page)).toHaveText('Parts: 6');
  await expect(page.locator('.part-eye')).toHaveText(['Top', 'Leg', 'Leg 2', 'Leg 3', 'Leg 4', 'Box']);
  const whole = await readDrawing(page);
  await eye(page, 'Top').click();
  await expect(eye(page, 'Top')).toHaveAttribute('aria-pressed', 'false');
  await expect(fold(page)).toHaveText('Parts: 6, 1 hidden');
  await page.mouse.move(300, 10);
  const topless = await readDrawing(page);
  expect(changedShare(whole, topless)).toBeGreaterThan(0.03);
  expect(new URLSearchParams(await writtenHash(page)).get('hidden')).toBe('1');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(eye(page, 'Top')).toHaveAttribute('aria-pressed', 'true');
  expect(changedShare(whole, await readDrawing(page))).toBe(0);
  await page.getByRole('button', { name: 'Redo' }).click();
  expect(changedShare(topless, await readDrawing(page))).toBe(0);

  await page.getByRole('button', { name: 'Only Box' }).click();
  await expect(fold(page)).toHaveText('Parts: 6, 5 hidden');
  await page.mouse.move(300, 10);
  const alone = await readDrawing(page);
  // It stays as large as it was.
  expect(meanInk(alone)).toBeLessThan(0.5 * meanInk(topless));
  expect(new URLSearchParams(await writtenHash(page)).get('hidden')).toBe('1-5');
  await page.reload();
  await fold(page).click();
  await page.mouse.move(300, 10);
  await expect(fold(page)).toHaveText('Parts: 6, 5 hidden');
  expect(changedShare(alone, await readDrawing(page))).toBe(0);
  await eye(page, 'Box').click();
  await expect(fold(page)).toHaveText('Parts: 6, 6 hidden');
  await ready(page);
  await page.getByRole('button', { name: 'Show all' }).click();
  await page.mouse.move(300, 10);
  expect(changedShare(whole, await readDrawing(page))).toBe(0);
});

test('hidden parts are in no saved file', { tag: '@all' }, async ({ page }) => {
  await open(page, table);
  const svg = async (): Promise<string> => {
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save SVG, as lines' }).click();
    return readFile(await (await download).path(), 'utf8');
  };
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  const whole = await svg();
  const ink = meanInk(await savePicture(page));
  await page.getByRole('button', { name: 'Only Box' }).click();
  await ready(page);
  const alone = await svg();
  expect(alone.match(/<path/g)?.length ?? 0).toBeGreaterThan(0);
  expect(alone.length).toBeLessThan(0.5 * whole.length);
  expect(meanInk(await savePicture(page))).toBeLessThan(0.5 * ink);
});

test('parts of a scene that moves are hidden at once, with their shadows and outlines', { tag: '@all' }, async ({
  page,
}) => {
  const builder = tetrahedron();
  const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR', { min: [0], max: [1] });
  const output = builder.accessor(Float32Array.of(0, 4, 0, 0, 4.2, 0), 'VEC3');
  Object.assign(builder.json, {
    nodes: [
      { name: 'Body', mesh: 0, children: [1] },
      { name: 'Arm', mesh: 0, translation: [0, 4, 0] },
    ],
    animations: [
      { samplers: [{ input: times, output }], channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }] },
    ],
  });
  await open(page, file('robot.glb', Buffer.from(builder.glb())));
  const whole = await readDrawing(page);
  // Its arm, which is its child, stays.
  await eye(page, 'Body').click();
  await page.mouse.move(300, 10);
  const arm = await readDrawing(page);
  expect(meanInk(arm)).toBeLessThan(0.8 * meanInk(whole));
  await eye(page, 'Arm').click();
  await page.mouse.move(300, 10);
  const none = await readDrawing(page);
  expect(meanInk(none)).toBeLessThan(0.3 * meanInk(arm));
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(changedShare(arm, await readDrawing(page))).toBe(0);
});

test('thousands of parts are searched and hidden by keys, and few of them are in the document', {
  tag: '@all',
}, async ({ page }) => {
  await open(page, manyParts(2000));
  await expect(fold(page)).toHaveText('Parts: 2,000');
  expect(await page.locator('.part').count()).toBeLessThan(40);
  await eye(page, 'Plate 0').focus();
  await page.keyboard.press('End');
  await expect(eye(page, 'Bolt 1999')).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Space');
  await expect(eye(page, 'Plate 1998')).toHaveAttribute('aria-pressed', 'false');
  await expect(eye(page, 'Plate 1998')).toBeFocused();
  await expect(page.locator('.part:has(:focus)')).toHaveAttribute('aria-posinset', '1999');
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('button', { name: 'Only Plate 1998' })).toBeFocused();
  await page.keyboard.press('Home');
  await expect(page.getByRole('button', { name: 'Only Plate 0' })).toBeFocused();
  expect(await page.locator('.part').count()).toBeLessThan(40);

  await page.getByRole('searchbox', { name: 'Find a part' }).fill('bolt 19');
  await expect(page.locator('.part-eye').first()).toHaveText('Bolt 19');
  // All bolts whose number has a 19 in it, beside the plate.
  await page.getByRole('button', { name: 'Hide these' }).click();
  await expect(fold(page)).toHaveText('Parts: 2,000, 80 hidden');
  await page.getByRole('searchbox', { name: 'Find a part' }).fill('nothing');
  await expect(page.getByText('No part has such a name.')).toBeVisible();
  await ready(page);
});

test('the part that is pointed at shows in the picture', { tag: '@all' }, async ({ page }) => {
  await open(page, table);
  const whole = await readDrawing(page);
  const frames = await page.evaluate(() => window.__playground!.framesDrawn);
  await eye(page, 'Top').hover();
  expect(changedShare(whole, await readDrawing(page))).toBeGreaterThan(0.1);
  // No frame is drawn for it.
  expect(await page.evaluate(() => window.__playground!.framesDrawn)).toBe(frames);
  await page.mouse.move(300, 10);
  expect(changedShare(whole, await readDrawing(page))).toBe(0);
});

test('a drawing that was saved with its model hides the parts that it hid', { tag: '@all' }, async ({ page }) => {
  const saved = zip({ [BUNDLE.description]: describeBundle(`${SMALL}&hidden=1-5`), 'model/table.obj': table.buffer });
  await open(page, file('table.zip', Buffer.from(saved)));
  await expect(fold(page)).toHaveText('Parts: 6, 5 hidden');
  await ready(page);
  await eye(page, 'Top').click();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(fold(page)).toHaveText('Parts: 6, 5 hidden');
});

test('what was done to a file is undone by switches behind “i”, which are steps of the history', async ({ page }) => {
  await openPlayground(page, SMALL);
  await drop(page, [file('box.stl', Buffer.from(boxStl([0, 0, 0])))]);
  await ready(page);
  await page.locator('#about-model summary').click();
  await expect(page.getByRole('switch')).toBeVisible();
  const up = page.locator('#model-changes li:not([hidden]) input');
  await expect(up).toBeChecked();
  await expect(page.locator('#model-changes')).toHaveText(/stood up: z is up in STL files/);
  const stood = await readDrawing(page);
  await up.click();
  await expect(page.locator('#model-changes')).toHaveText(/it lies as in the file/);
  await ready(page);
  const lying = await readDrawing(page);
  expect(changedShare(stood, lying)).toBeGreaterThan(0.02);
  expect(new URLSearchParams(await writtenHash(page)).get('switched')).toBe('up');
  await page.getByRole('button', { name: 'Undo' }).click();
  await ready(page);
  await page.locator('#about-model summary').click();
  await expect(up).toBeChecked();
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(up).not.toBeChecked();
  expect(await writtenHash(page)).toContain('switched=up');
  await page.reload();
  await ready(page);
  await page.locator('#about-model summary').click();
  await expect(up).not.toBeChecked();
  await up.click();
  await ready(page);
  expect(await writtenHash(page)).not.toContain('switched');
});

test('both sides of one-sided surfaces are drawn by a switch behind “i”, which is a step of the history', async ({
  page,
}) => {
  const builder = tetrahedron();
  const inward = Uint16Array.of(0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2);
  builder.json.meshes[0].primitives[0].indices = builder.accessor(inward, 'SCALAR');
  await openPlayground(page, SMALL);
  await drop(page, [file('room.glb', Buffer.from(builder.glb()))]);
  await ready(page);
  const seenThrough = await readDrawing(page);
  await page.locator('#about-model summary').click();
  const sides = page.getByRole('switch', { name: 'Draw both sides' });
  await expect(sides).not.toBeChecked();
  await sides.click();
  await ready(page);
  expect(changedShare(seenThrough, await readDrawing(page))).toBeGreaterThan(0.02);
  expect(new URLSearchParams(await writtenHash(page)).get('switched')).toBe('sides');
  await page.getByRole('button', { name: 'Undo' }).click();
  await ready(page);
  expect(changedShare(seenThrough, await readDrawing(page))).toBe(0);
  await page.reload();
  await ready(page);
  await page.locator('#about-model summary').click();
  await expect(sides).not.toBeChecked();
});
