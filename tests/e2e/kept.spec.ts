import type { Page } from '@playwright/test';
import { expect, test } from '../browser/test.js';
import { file, octahedronPly } from './modelFiles.js';
import { changedShare } from './pictures.js';
import { drop, middleOf, openPlayground, readDrawing, ready } from './playground.js';

test.use({ viewport: { width: 900, height: 420 } });

const LINK = 'model=cube&mapSize=64&mapTones=4&lines=off';
const octahedron = file('octahedron.ply', octahedronPly);

/** Waits until the browser keeps what the page shows, by the link in the page's address. */
async function kept(page: Page): Promise<void> {
  await ready(page);
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

test("one's own model, its settings and the view survive a reload, Back and a closed page, until they are forgotten", async ({
  page,
  context,
  pageProblems,
}) => {
  const name = page.locator('#model-name');
  await openPlayground(page, LINK);
  await expect(page.locator('#open-recent')).toBeHidden();
  await drop(page, [octahedron]);
  await expect(name).toHaveText('octahedron.ply');
  await page.locator('#lamp').press('ArrowLeft');
  await page.locator('#drawing').press('ArrowLeft');
  await page.locator('#drawing').press('+');
  await page.getByRole('button', { name: 'Stipple' }).click();
  await kept(page);
  const before = await readDrawing(page);

  await page.reload();
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(page))).toBe(0);
  // Nothing that was done before can be undone, because nothing of it is there.
  await expect(page.locator('#undo')).toBeDisabled();

  await page.getByRole('link', { name: 'Figures' }).click();
  await expect(page).toHaveURL(/figures/);
  await page.goBack();
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(page))).toBe(0);
  await page.close();

  const later = await context.newPage();
  later.on('pageerror', (error) => pageProblems.push(String(error)));
  await openPlayground(later, LINK);
  await expect(later.locator('#model-name')).toHaveText('Cube');
  await later.getByRole('button', { name: 'Recent' }).click();
  await later.getByRole('button', { name: 'octahedron.ply', exact: true }).click();
  await expect(later.locator('#model-name')).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(later))).toBe(0);
  await later.getByRole('button', { name: 'Undo' }).click();
  await expect(later.locator('#model-name')).toHaveText('Cube');
  await later.getByRole('button', { name: 'Redo' }).click();
  await expect(later.locator('#model-name')).toHaveText('octahedron.ply');
  expect(changedShare(before, await readDrawing(later))).toBe(0);

  await later.getByRole('button', { name: 'Recent' }).click();
  await later.getByRole('button', { name: 'Forget octahedron.ply' }).click();
  await expect(later.getByText('There are none')).toBeVisible();
  await later.getByRole('button', { name: 'Close' }).last().click();
  await expect(later.getByRole('button', { name: 'Recent' })).toBeHidden();
  await later.reload();
  await ready(later);
  await expect(later.locator('#model-name')).not.toHaveText('octahedron.ply');
});

test('a browser that keeps nothing, or has no room, says so in one sentence, once', async ({ page }) => {
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
    ['?private', /keeps nothing here, as in a private window: after a reload, open octahedron\.ply again\.$/],
    ['?full', /^octahedron\.ply is larger than what this browser keeps/],
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

  // One that does not answer at all: a reload goes on without it, and so does the page's address.
  await page.goto(`./?silent#${LINK}`);
  await ready(page);
  await page.evaluate(() => history.replaceState({ drawing: 'a' }, ''));
  await page.reload();
  await expect(status).toHaveText('The browser does not give back the drawing that it keeps: open your model again.');
  await ready(page);
  await expect(page.locator('#model-name')).toHaveText('Cube');
  await expect.poll(() => page.evaluate(() => history.state)).toBe(null);
});

test('Undo and Redo take back settings, the model, the view and the light, by buttons and keys', async ({ page }) => {
  await openPlayground(page, LINK);
  const name = page.locator('#model-name');
  const pictures = [await readDrawing(page)];
  const after = async (change: () => Promise<unknown>): Promise<void> => {
    await change();
    // Changes of one kind that follow at once would be one step.
    await page.waitForTimeout(1000);
    pictures.push(await readDrawing(page));
    expect(changedShare(pictures.at(-2)!, pictures.at(-1)!)).toBeGreaterThan(0.002);
  };
  const { x, y } = await middleOf(page, '#viewport');
  await after(async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y, { steps: 4 });
    await page.mouse.up();
  });
  await after(() => page.locator('#lamp').press('ArrowLeft'));
  await after(() => drop(page, [octahedron]).then(() => expect(name).toHaveText('octahedron.ply')));
  await after(() => page.locator('#drawing').press('+'));
  await after(() => page.getByRole('combobox', { name: 'Model', exact: true }).selectOption('Sphere'));
  await after(() => page.getByRole('button', { name: 'Stipple' }).click());

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
