import { existsSync, readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { PNG } from 'pngjs';
import {
  drop,
  framesDrawn,
  openPlayground,
  readDrawing,
  ready,
  refreshes,
  writtenHash,
} from '../../tools/browser/playground.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { file, type TestFile } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { changedShare, meanInk } from './pictures.js';

/** Animated and textured models. */

test.use({ viewport: { width: 840, height: 420 } });

const column = (options = {}): TestFile[] => [file('column.glb', columnGlb(options))];
const time = (page: Page) => page.getByRole('slider', { name: 'Time' });
const play = (page: Page) => page.getByRole('button', { name: 'Play' });
const pause = (page: Page) => page.getByRole('button', { name: 'Pause' });

async function openModel(page: Page, files: readonly TestFile[], hash = ''): Promise<void> {
  await openPlayground(page, `model=cube&mapSize=64&mapTones=4&camera=0,0,5,0,0,0&${hash}`);
  await drop(page, files);
  await expect(page.locator('#model-name')).toHaveText(files[0].name);
}

/** The share of pixels that are clearly more red, or more blue, than anything else. */
function colouredShare({ data }: PNG, channel: 0 | 2): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if (data[i + channel] > 100 + Math.max(data[i + 1], data[i + 2 - channel])) count++;
  return count / (data.length / 4);
}

test('a model with a clip plays when it is dropped; paused, the page is idle', async ({ page }) => {
  await openModel(page, column());
  await expect(pause(page)).toBeVisible();
  const before = await framesDrawn(page);
  await expect.poll(() => framesDrawn(page)).toBeGreaterThan(before + 3);
  await expect.poll(() => time(page).inputValue()).not.toBe('0');
  await pause(page).click();
  await ready(page);
  const frames = await framesDrawn(page);
  await refreshes(page, 10);
  expect(await framesDrawn(page)).toBe(frames);
  // The space bar on the drawing does the same.
  await page.locator('#drawing').press(' ');
  await expect(pause(page)).toBeVisible();
  await expect.poll(() => framesDrawn(page)).toBeGreaterThan(frames + 1);
  await page.locator('#drawing').press(' ');
  await ready(page);
  await expect(play(page)).toBeVisible();
});

test('the built-in fish swims, and is in the link', { tag: '@all' }, async ({ page }) => {
  await page.goto('./#model=fish&mapSize=64&mapTones=4&lightElevation=50');
  await expect(page.locator('#model-name')).toHaveText('Fish');
  await expect(pause(page)).toBeVisible();
  await pause(page).click();
  await ready(page);
  await page.getByRole('slider', { name: 'Speed' }).fill('2');
  await page.locator('#lamp').press('ArrowDown');
  expect(await writtenHash(page)).toMatch(/model=fish.*lightElevation=45/);
  await page.getByRole('combobox', { name: 'Model', exact: true }).selectOption('Cube');
  await expect(page.locator('#model-name')).toHaveText('Cube');
  await expect(page.getByRole('group', { name: 'Motion' })).toBeHidden();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.locator('#model-name')).toHaveText('Fish');
});

test.describe('with reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('a model does not start by itself; time, clips and morph targets change the drawing, and back', {
    tag: '@all',
  }, async ({ page }) => {
    await openModel(page, column());
    const first = await readDrawing(page);
    await expect(play(page)).toBeVisible();
    await expect(time(page)).toHaveValue('0');

    await time(page).fill('0.5');
    await expect(time(page)).toHaveAttribute('aria-valuetext', '0.5 s');
    const bent = await readDrawing(page);
    expect(changedShare(first, bent)).toBeGreaterThan(0.02);
    await time(page).press('Home');
    expect(changedShare(first, await readDrawing(page))).toBe(0);

    const clips = page.getByRole('combobox', { name: 'Clip' });
    const atFirst = await clips.inputValue();
    await clips.selectOption('Turn');
    await expect(time(page)).toHaveAttribute('max', '2');
    // The change is a step of undo, and the page's address restores it.
    expect(await writtenHash(page)).toContain('clip=2');
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(clips).toHaveValue(atFirst);
    expect(await writtenHash(page)).not.toContain('clip');
    await page.getByRole('button', { name: 'Redo' }).click();
    expect(await writtenHash(page)).toContain('clip=2');
    await page.reload();
    await expect(clips).toHaveValue('1');
    await expect(time(page)).toHaveAttribute('max', '2');
    await time(page).fill('1');
    const turned = await readDrawing(page);
    expect(changedShare(first, turned)).toBeGreaterThan(0.01);
    expect(changedShare(bent, turned)).toBeGreaterThan(0.02);
    await time(page).fill('0');
    expect(changedShare(first, await readDrawing(page))).toBe(0);

    const swollen = page.getByRole('slider', { name: 'Swollen' });
    await swollen.fill('1');
    await expect(swollen).toHaveAttribute('aria-valuetext', '100 %');
    const wide = await readDrawing(page);
    expect(changedShare(first, wide)).toBeGreaterThan(0.02);
    await page.getByText('Swollen').dblclick();
    await expect(swollen).toHaveValue('0');
    expect(changedShare(first, await readDrawing(page))).toBe(0);
  });

  test('techniques and the comparison follow the pose', { tag: '@all' }, async ({ page }) => {
    for (const technique of ['adjacency', 'triangle']) {
      await openModel(page, column(), `technique=${technique}&compare=hatching&surfaceColors=paper`);
      const first = await readDrawing(page);
      await time(page).fill('0.5');
      const bent = await readDrawing(page);
      expect(changedShare(first, bent)).toBeGreaterThan(0.02);
      expect(meanInk(bent)).toBeGreaterThan(0.01);
    }
  });

  test('the controls disappear with a model that does not move', { tag: '@all' }, async ({ page }) => {
    await openModel(page, column());
    await expect(page.getByRole('group', { name: 'Motion' })).toBeVisible();
    await drop(page, [file('still.glb', columnGlb({ still: true }))]);
    await expect(page.locator('#model-name')).toHaveText('still.glb');
    await expect(page.getByRole('group', { name: 'Motion' })).toBeHidden();
    await page.locator('#drawing').press(' ');
    await ready(page);
  });

  test('surfaces show their textures, or paper, and undo restores them', { tag: '@all' }, async ({ page }) => {
    await openModel(page, column());
    const coloured = await readDrawing(page);
    expect(colouredShare(coloured, 0)).toBeGreaterThan(0.01);
    expect(colouredShare(coloured, 2)).toBeGreaterThan(0.01);
    await page.getByRole('button', { name: 'Colours' }).click();
    await page.getByLabel('Surfaces').selectOption('White as paper');
    const white = await readDrawing(page);
    expect(colouredShare(white, 0)).toBe(0);
    expect(colouredShare(white, 2)).toBe(0);
    expect(meanInk(white)).toBeGreaterThan(0.01);
    expect(await writtenHash(page)).toContain('surfaceColors=paper');
    await page.getByRole('button', { name: 'Undo' }).click();
    expect(changedShare(coloured, await readDrawing(page))).toBe(0);
    await expect(page.locator('#model-name')).toHaveText('column.glb');
  });

  test('broken parts of an animated model are left out or reported', { tag: '@all' }, async ({ page }) => {
    const numbers = [0, 0, 0, 1, Number.NaN, 0, 0, 1, 0, 0, 0, 1];
    await openModel(page, column({ bend: numbers }));
    await expect(page.locator('#model-note')).toHaveText('1 damaged animation track left out');
    await expect(page.getByRole('combobox', { name: 'Clip' }).locator('option')).toHaveText(['Turn']);

    // An image of 30,000 × 30,000 pixels, in a few bytes, would decode to gigabytes.
    const png = Buffer.alloc(64);
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1').copy(png);
    png.write('IHDR', 12);
    png.writeUInt32BE(30_000, 16);
    png.writeUInt32BE(30_000, 20);
    await drop(page, [file('bomb.glb', columnGlb({ picture: png }))]);
    await expect(page.locator('#model-name')).toHaveText('bomb.glb');
    const before = await readDrawing(page);
    expect(colouredShare(before, 0)).toBe(0);

    const cases: [name: string, content: Buffer, sentence: RegExp][] = [
      [
        'nodes.glb',
        columnGlb({ changes: () => ({ scenes: [{ nodes: [-1] }] }) }),
        /^nodes\.glb is damaged: scenes\[0\]\.nodes\[0\] is -1, not one of its \d+ nodes\.$/,
      ],
      [
        'meshes.glb',
        columnGlb({ changes: () => ({ meshes: [] }) }),
        /^meshes\.glb is damaged: nodes\[\d\]\.mesh is 0, not one of its 0 meshes\.$/,
      ],
      [
        'cut.glb',
        columnGlb({
          changes: ({ bufferViews }) => ({
            bufferViews: (bufferViews as { byteLength: number }[]).map((view, i) =>
              i === 0 ? { ...view, byteLength: 1e6 } : view,
            ),
          }),
        }),
        /^cut\.glb is cut short: its buffer ends before the data it lists\.$/,
      ],
    ];
    for (const [name, content, sentence] of cases) {
      await drop(page, [file(name, content)]);
      await expect(page.locator('#status')).toHaveText(sentence);
      await expect(page.locator('#model-name')).toHaveText('bomb.glb');
    }
    expect(changedShare(before, await readDrawing(page))).toBe(0);
  });

  test('assembling a large animated model can be cancelled', { tag: '@all' }, async ({ page }) => {
    await openModel(page, column());
    const before = await readDrawing(page);
    // Pressed by the page itself: the model may be there before a test has found the button.
    await page.locator('#status').evaluate((status) => {
      new MutationObserver((_, observer) => {
        if (!/^(Joining triangles|Putting the parts together)/.test(status.textContent ?? '')) return;
        observer.disconnect();
        document.querySelector<HTMLElement>('#cancel')!.click();
      }).observe(status, { childList: true, characterData: true, subtree: true });
    });
    await drop(page, [file('tower.glb', columnGlb({ rings: 16_000 }))]);
    await expect(page.locator('#status')).toHaveText('Cancelled; the drawing is as it was.');
    await ready(page);
    await expect(page.locator('#model-name')).toHaveText('column.glb');
    expect(changedShare(before, await readDrawing(page))).toBe(0);
  });

  const folder = new URL('../../../shared/models/', import.meta.url);
  for (const [names, seconds] of [
    [['Fox.glb'], 1],
    [['CesiumMan.glb'], 1],
    [['SimpleSkin.gltf'], 2],
    [['MorphStressTest.gltf'], 1],
    [['AnimatedMorphCube.gltf', 'AnimatedMorphCube.bin'], 2],
  ] as const) {
    test(`${names[0]} moves`, { tag: '@all' }, async ({ page }) => {
      test.skip(!existsSync(folder), 'The folder ../shared/models with sample models is not there.');
      await openModel(
        page,
        names.map((name) => file(name, readFileSync(new URL(name, folder)))),
      );
      await page.locator('#drawing').press('Home');
      const first = await readDrawing(page);
      expect(meanInk(first)).toBeGreaterThan(0.004);
      await time(page).fill(String(seconds));
      expect(changedShare(first, await readDrawing(page))).toBeGreaterThan(0.003);
    });
  }
});
