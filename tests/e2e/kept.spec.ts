import { readFile } from 'node:fs/promises';
import type { Locator, Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { strFromU8, strToU8, unzipSync, zipSync } from 'three/addons/libs/fflate.module.js';
import { drop, middleOf, openPlayground, readDrawing, ready, writtenHash } from '../../tools/browser/playground.js';
import { file, octahedronPly } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { cases } from '../selection.mjs';
import { changedShare, meanInk } from './pictures.js';

// Half of the pixels in each direction: what is kept does not depend on them.
test.use({ viewport: { width: 840, height: 360 }, deviceScaleFactor: 0.5 });

const LINK = 'model=cube&mapSize=64&mapTones=4&outlines=off';
const octahedron = file('octahedron.ply', octahedronPly);

/** Waits until the browser keeps what the page shows, by the link in the page's address. */
async function kept(page: Page): Promise<void> {
  await writtenHash(page);
  await expect
    .poll(() =>
      page.evaluate(
        () =>
          new Promise<boolean>((resolve) => {
            const request = indexedDB.open('three-hatching');
            request.onsuccess = () => {
              const all = request.result.transaction('drawings').objectStore('drawings').getAll();
              all.onsuccess = () => {
                request.result.close();
                resolve(all.result.some(({ link }) => `#${link}` === location.hash && history.state?.drawing));
              };
            };
          }),
      ),
    )
    .toBe(true);
}

/** The image in an element, as it is shown. */
async function thumbnailIn(element: Locator): Promise<PNG> {
  const image = element.locator('img');
  await expect.poll(() => image.evaluate((one: HTMLImageElement) => one.naturalWidth)).toBeGreaterThan(0);
  return PNG.sync.read(await image.screenshot());
}

/** Drops a model of one's own, changes its settings and its view, and waits until they are kept. Returns the named view `Near` and the last one, as drawn. */
async function keepOctahedron(page: Page): Promise<{ near: PNG; before: PNG }> {
  await openPlayground(page, LINK);
  await expect(page.locator('#open-recent')).toBeHidden();
  await drop(page, [octahedron]);
  await expect(page.locator('#model-name')).toHaveText('octahedron.ply');
  await page.locator('#lamp').press('ArrowLeft');
  await page.locator('#drawing').press('ArrowLeft');
  await page.locator('#drawing').press('+');
  await page.getByRole('button', { name: 'Stipple' }).click();
  // A view to return to: from where it is seen, and how it is lit.
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByLabel('Name', { exact: true }).fill('Near');
  await page.getByRole('button', { name: 'Keep this view' }).click();
  await expect(page.getByLabel('Name of Near')).toHaveValue('Near');
  await page.keyboard.press('Escape');
  const near = await readDrawing(page);
  await page.locator('#lamp').press('ArrowUp');
  await page.locator('#drawing').press('Home');
  await kept(page);
  const before = await readDrawing(page);
  expect(changedShare(before, near)).toBeGreaterThan(0.005);
  return { near, before };
}

test("one's own model, its settings and the view survive a reload and Back", async ({ page }) => {
  const name = page.locator('#model-name');
  const { before } = await keepOctahedron(page);
  await page.reload();
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(page))).toBe(0);
  // Steps before the reload cannot be undone.
  await expect(page.locator('#undo')).toBeDisabled();

  await page.getByRole('link', { name: 'Figures' }).click();
  await expect(page).toHaveURL(/figures/);
  await page.goBack();
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(page))).toBe(0);
});

test("one's own model, its settings and the view survive a closed page, until they are forgotten", {
  tag: '@all',
}, async ({ page, context, pageProblems }) => {
  const { near, before } = await keepOctahedron(page);
  await page.close();

  const later = await context.newPage();
  later.on('pageerror', (error) => pageProblems.push(String(error)));
  await openPlayground(later, LINK);
  await expect(later.locator('#model-name')).toHaveText('Cube');
  await later.getByRole('button', { name: 'Recent' }).click();
  const entry = later.getByRole('button', { name: 'octahedron.ply', exact: true });
  expect(meanInk(await thumbnailIn(entry))).toBeGreaterThan(0.02);
  await entry.click();
  await expect(later.locator('#model-name')).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(later))).toBe(0);
  const view = later.getByRole('group', { name: 'Views' }).getByRole('button', { name: 'Near' });
  await later.locator('#drawing').press('1');
  expect(changedShare(near, await readDrawing(later))).toBe(0);
  await expect(view).toHaveAttribute('aria-pressed', 'true');
  await later.getByRole('button', { name: 'Undo' }).click();
  expect(changedShare(before, await readDrawing(later))).toBe(0);
  await view.click();
  expect(changedShare(near, await readDrawing(later))).toBe(0);
  await later.getByRole('button', { name: 'Views' }).click();
  await later.getByRole('button', { name: 'Delete Near' }).click();
  await later.keyboard.press('Escape');
  await expect(view).toBeHidden();
  for (let step = 0; step < 2; step++) await later.getByRole('button', { name: 'Undo' }).click();
  await expect(view).toBeVisible();
  await later.getByRole('button', { name: 'Undo' }).click();
  await expect(later.locator('#model-name')).toHaveText('Cube');
  await later.getByRole('button', { name: 'Redo' }).click();
  await expect(later.locator('#model-name')).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(later))).toBe(0);

  // A write after the drawing was forgotten would store it again.
  await kept(later);
  await later.getByRole('button', { name: 'Recent' }).click();
  await later.getByRole('button', { name: 'Forget octahedron.ply' }).click();
  await expect(later.getByText('There are none')).toBeVisible();
  await later.getByRole('button', { name: 'Close' }).last().click();
  await expect(later.getByRole('button', { name: 'Recent' })).toBeHidden();
  await later.reload();
  await ready(later);
  await expect(later.locator('#model-name')).not.toHaveText('octahedron.ply');
});

test('a look of one’s own appears beside the presets, also after a reload, and can be renamed and deleted; it works without storage', {
  tag: '@all',
}, async ({ page }) => {
  await page.addInitScript(() => {
    if (location.search !== '?full') return;
    Storage.prototype.setItem = () => {
      throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
    };
  });
  const looks = page.getByRole('group', { name: 'Looks of your own' });
  const keep = async (name: string): Promise<void> => {
    await page.getByRole('button', { name: 'Looks' }).click();
    await page.getByLabel('Name', { exact: true }).fill(name);
    await page.getByLabel('Name', { exact: true }).press('Enter');
    await expect(page.getByLabel(`Name of ${name}`)).toBeVisible();
  };
  await openPlayground(page, `${LINK}&ink=%237a2e1d&paper=%23f4ead6&technique=engraving&shadows=on`);
  const red = await readDrawing(page);
  await keep('Red cut');
  await expect(page.locator('#named-said')).toHaveText('');
  await page.keyboard.press('Escape');
  await expect(looks.getByRole('button')).toHaveAttribute('aria-pressed', 'true');
  expect(meanInk(await thumbnailIn(looks))).toBeGreaterThan(0.02);
  await page.getByRole('button', { name: 'Pen', exact: true }).click();
  await expect(looks.getByRole('button')).toHaveAttribute('aria-pressed', 'false');
  expect(changedShare(red, await readDrawing(page))).toBeGreaterThan(0.05);
  await writtenHash(page);
  await page.reload();
  await ready(page);
  await looks.getByRole('button', { name: 'Red cut' }).click();
  expect(changedShare(red, await readDrawing(page))).toBe(0);

  await page.getByRole('button', { name: 'Looks' }).click();
  await page.getByLabel('Name of Red cut').fill('Rust');
  await page.getByLabel('Name of Red cut').press('Enter');
  await page.getByRole('button', { name: 'Show Rust' }).click();
  await expect(looks.getByRole('button', { name: 'Rust' })).toBeVisible();
  await page.getByRole('button', { name: 'Looks' }).click();
  await page.getByRole('button', { name: 'Delete Rust' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  await expect(looks).toBeHidden();

  await page.goto(`./?full#${LINK}&ink=%237a2e1d`);
  await ready(page);
  await keep('Full');
  await expect(page.locator('#named-said')).toHaveText(/your looks last until the page is closed\.$/);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Pen', exact: true }).click();
  await looks.getByRole('button', { name: 'Full' }).click();
  await expect(looks.getByRole('button', { name: 'Full' })).toHaveAttribute('aria-pressed', 'true');
});

test('a browser without storage, or without room in it, is reported once, in one sentence', { tag: '@all' }, async ({
  page,
}) => {
  await page.addInitScript(() => {
    if (location.search === '?full') {
      IDBObjectStore.prototype.put = () => {
        throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
      };
    } else if (location.search === '?silent') {
      IDBFactory.prototype.open = () => new EventTarget() as IDBOpenDBRequest;
    } else {
      IDBFactory.prototype.open = () => {
        throw new DOMException('A mutation operation was attempted on a database that did not allow mutations.');
      };
    }
  });
  const status = page.locator('#status');
  for (const [query, sentence] of [
    ['?private', /stores nothing for this page, as in a private window: after a reload, open octahedron\.ply again\.$/],
    ['?full', /^octahedron\.ply is larger than what this browser stores/],
  ] as const) {
    await page.goto(`./${query}#${LINK}`);
    await ready(page);
    await drop(page, [octahedron]);
    await expect(page.locator('#model-name')).toHaveText('octahedron.ply');
    await expect(status).toHaveText(sentence);
    const before = await readDrawing(page);
    await page.getByRole('button', { name: 'Stipple' }).click();
    expect(changedShare(before, await readDrawing(page))).toBeGreaterThan(0.005);
    await expect(status).toHaveText('');
  }

  // Storage that never answers: page and address work without it.
  await page.goto(`./?silent#${LINK}`);
  // No pending write can replace what follows.
  await writtenHash(page);
  await page.evaluate(() => history.replaceState({ drawing: 'a' }, ''));
  await page.reload();
  await expect(status).toHaveText('The browser does not return the drawing that it keeps: open your model again.');
  await ready(page);
  await expect(page.locator('#model-name')).toHaveText('Cube');
  await expect.poll(() => page.evaluate(() => history.state)).toBe(null);
});

test('a model is saved with its look, its view and its light, and is the same drawing where it is dropped; a hostile bundle changes nothing', {
  tag: '@all',
}, async ({ page }) => {
  const name = page.locator('#model-name');
  await openPlayground(page, `${LINK}&ink=%237a2e1d&lightAzimuth=20`);
  await drop(page, [octahedron]);
  await expect(name).toHaveText('octahedron.ply');
  await page.getByRole('button', { name: 'Stipple' }).click();
  await page.locator('#drawing').press('ArrowLeft');
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByRole('button', { name: 'Keep this view' }).click();
  await page.keyboard.press('Escape');
  const turned = await readDrawing(page);
  await page.locator('#drawing').press('ArrowUp');
  const before = await readDrawing(page);
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save with the model' }).click();
  expect((await download).suggestedFilename()).toBe('octahedron-drawing.zip');
  const bundle = await readFile(await (await download).path());

  await openPlayground(page, LINK);
  const other = await readDrawing(page);
  await drop(page, [file('for-you.zip', bundle)]);
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(page))).toBe(0);
  await expect(page.getByRole('group', { name: 'Views' }).getByRole('button')).toHaveText('1View 1');
  await expect(page.getByRole('button', { name: 'Stipple' })).toHaveAttribute('aria-pressed', 'true');
  await page.locator('#drawing').press('1');
  expect(changedShare(turned, await readDrawing(page))).toBe(0);
  for (let step = 0; step < 2; step++) await page.getByRole('button', { name: 'Undo' }).click();
  expect(changedShare(other, await readDrawing(page))).toBe(0);
  await expect(page.getByRole('group', { name: 'Views' })).toBeHidden();

  const entries = unzipSync(bundle);
  const described = JSON.parse(strFromU8(entries['three-hatching.json']));
  const describing = (drawing: unknown) =>
    zipSync({ ...entries, 'three-hatching.json': strToU8(JSON.stringify({ ...described, drawing })) });
  await drop(page, [file('damaged.zip', Buffer.from(describing(7)))]);
  await expect(page.locator('#status')).toHaveText(/^damaged\.zip could not be read; what says how its model is drawn/);
  expect(changedShare(other, await readDrawing(page))).toBe(0);
  const hostile =
    'model=https%3A%2F%2Fevil.test%2Ftrack.glb&technique=nonsense&strokeWidth=1e9&ink=url(x)&camera=NaN,1,2,3,4,5&view=x&__proto__=1';
  await drop(page, [file('hostile.zip', Buffer.from(describing(hostile)))]);
  await expect(name).toHaveText('octahedron.ply');
  await ready(page);
  await expect(page.getByRole('dialog')).toBeHidden();
  await expect.poll(() => page.url()).toContain('strokeWidth=8');
  expect(page.url()).not.toMatch(/evil|nonsense|url|camera|view|proto/);
});

test('Undo and Redo take back settings, the model, the view and the light, by buttons and keys', {
  tag: '@more',
}, async ({ page }) => {
  await openPlayground(page, LINK);
  const name = page.locator('#model-name');
  const pictures = [await readDrawing(page)];
  const after = async (change: () => Promise<unknown>): Promise<void> => {
    await change();
    pictures.push(await readDrawing(page));
    expect(changedShare(pictures.at(-2)!, pictures.at(-1)!)).toBeGreaterThan(0.002);
  };
  const { x, y } = await middleOf(page, '#viewport');
  const drag = async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y, { steps: 4 });
    await page.mouse.up();
  };
  const dropped = () => drop(page, [octahedron]).then(() => expect(name).toHaveText('octahedron.ply'));
  const light = () => page.locator('#lamp').press('ArrowLeft');
  const nearer = () => page.locator('#drawing').press('+');
  const sphere = () => page.getByRole('combobox', { name: 'Model', exact: true }).selectOption('Sphere');
  const stipple = () => page.getByRole('button', { name: 'Stipple' }).click();
  for (const change of cases([drag, light, dropped, stipple], [drag, light, dropped, nearer, sphere, stipple]))
    await after(change);

  const [undo, redo] = [page.getByRole('button', { name: 'Undo' }), page.getByRole('button', { name: 'Redo' })];
  await expect(redo).toBeDisabled();
  for (let i = pictures.length - 2; i >= 0; i--) {
    if (i % 2) await undo.click();
    else await page.locator('#drawing').press('Control+z');
    expect(changedShare(pictures[i], await readDrawing(page)), `undone to ${i}`).toBe(0);
  }
  await expect(undo).toBeDisabled();
  const keys = ['Control+y', 'Control+Shift+Z', 'Meta+Shift+Z'];
  for (let i = 1; i < pictures.length; i++) {
    if (i % 2) await redo.click();
    else await page.locator('#drawing').press(keys[i % keys.length]);
    expect(changedShare(pictures[i], await readDrawing(page)), `redone to ${i}`).toBe(0);
  }
  await expect(redo).toBeDisabled();
  await undo.click();
  await page.locator('#lamp').press('ArrowUp');
  await expect(redo).toBeDisabled();
});
