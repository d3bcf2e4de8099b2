import { readFile } from 'node:fs/promises';
import type { Locator, Page } from '@playwright/test';
import { encodePng } from '../../src/strokes/mapFiles/writeMapFiles.js';
import { drop, openPlayground, readDrawing, ready, writtenHash } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';

const PLAIN = 'technique=hatching&model=sphere&mapSize=64&mapTones=4';

interface PenPoint {
  x: number;
  y: number;
  /** Pressure from 0 to 1. */
  force: number;
}

const sheetOf = (page: Page): Locator => page.getByRole('complementary', { name: 'Your own hand' });
const saidOf = (page: Page): Locator => page.locator('.hand-said');
const swatches = (page: Page): Locator => page.getByRole('img', { name: /^The sheet to draw on/ });

async function openSheet(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Draw with your own hand' }).click();
  await expect(sheetOf(page)).toBeVisible();
}

/** Draws with a pen as a tablet sends it, between points in shares of the sheet. */
async function drawWithPen(page: Page, points: readonly PenPoint[], eraser = false): Promise<void> {
  const cdp = await page.context().newCDPSession(page);
  await swatches(page).scrollIntoViewIfNeeded();
  const box = (await swatches(page).boundingBox())!;
  for (const [i, { x, y, force }] of points.entries()) {
    const last = i === points.length - 1;
    await cdp.send('Input.dispatchMouseEvent', {
      type: i === 0 ? 'mousePressed' : last ? 'mouseReleased' : 'mouseMoved',
      x: box.x + x * box.width,
      y: box.y + y * box.height,
      button: 'left',
      buttons: last ? 0 : 1,
      clickCount: 1,
      pointerType: eraser ? 'mouse' : 'pen',
      force,
    });
  }
  await cdp.detach();
}

/** A slanted stroke of a pen that is pressed in its middle. @param x where it begins, in shares of the width of the sheet */
const stroke = (x: number, y = 0.62, force = 0.6): PenPoint[] =>
  Array.from({ length: 9 }, (_, i) => {
    const share = i / 8;
    return { x: x + 0.1 * share, y: y - 0.2 * share, force: force * Math.sin(Math.PI * (0.1 + 0.8 * share)) };
  });

async function drawStrokes(page: Page, count: number, from = 0): Promise<void> {
  for (let i = from; i < from + count; i++) await drawWithPen(page, stroke(0.1 + 0.07 * i));
}

const numberOf = (page: Page, label: string) =>
  sheetOf(page)
    .getByRole('slider', { name: label, exact: true })
    .evaluate((input: HTMLInputElement) => input.valueAsNumber);

test('a hand is learnt from five strokes of a pen: the model is hatched with it, and its properties are shown', async ({
  page,
}) => {
  await openPlayground(page, PLAIN);
  const before = await readDrawing(page);
  await openSheet(page);
  await expect(saidOf(page)).toHaveText('5 strokes are enough to begin with.');
  await drawStrokes(page, 4);
  await expect(saidOf(page)).toHaveText('4 strokes: 1 more to begin with.');
  await expect(sheetOf(page).getByRole('group', { name: 'What was learnt' })).toBeHidden();
  expect((await readDrawing(page)).data.equals(before.data)).toBe(true);
  await drawStrokes(page, 1, 4);
  await expect(saidOf(page)).toHaveText(/^5 strokes/);
  await expect.poll(async () => (await readDrawing(page)).data.equals(before.data)).toBe(false);
  // 0.1 of 76 mm across, and 0.2 of 72 mm up.
  expect(Math.abs((await numberOf(page, 'Length')) - Math.hypot(7.6, 14.4))).toBeLessThan(0.5);
  await expect(page.locator('select option:checked', { hasText: 'Your own hand' })).toHaveCount(1);
  await expect(swatches(page)).toHaveAccessibleName('The sheet to draw on, with 5 strokes: light 0, middle 5, dark 0');
});

test('the names of the fields stay on paper where strokes are drawn over them', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await openSheet(page);
  const label = sheetOf(page).getByText('Middle', { exact: true });
  const before = await label.screenshot();
  for (const y of [0.36, 0.38, 0.4]) {
    await drawWithPen(
      page,
      [0.7, 0.8, 0.9, 0.98].map((x) => ({ x, y, force: 0.9 })),
    );
  }
  await expect(saidOf(page)).toHaveText(/^3 strokes/);
  expect((await label.screenshot()).equals(before)).toBe(true);
});

test('the pen’s pressure is learnt: pressed harder, strokes are wider', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await openSheet(page);
  for (let i = 0; i < 5; i++) await drawWithPen(page, stroke(0.1 + 0.07 * i, 0.62, 0.25));
  const light = await numberOf(page, 'Width');
  await sheetOf(page).getByRole('button', { name: 'Clear the sheet' }).click();
  for (let i = 0; i < 5; i++) await drawWithPen(page, stroke(0.1 + 0.07 * i, 0.62, 0.9));
  expect(await numberOf(page, 'Width')).toBeGreaterThan(1.5 * light);
});

test('strokes are undone, redone, rubbed out and cleared, each as one step', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  const before = await readDrawing(page);
  await openSheet(page);
  await drawStrokes(page, 6);
  const said = saidOf(page);
  await expect(said).toHaveText(/^6 strokes/);
  await expect.poll(async () => (await readDrawing(page)).data.equals(before.data)).toBe(false);
  await sheetOf(page).getByRole('button', { name: 'Undo' }).click();
  await expect(said).toHaveText(/^5 strokes/);
  await page.keyboard.press('Control+z');
  await expect(said).toHaveText(/^4 strokes/);
  await expect.poll(async () => (await readDrawing(page)).data.equals(before.data)).toBe(true);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(said).toHaveText(/^5 strokes/);
  await sheetOf(page).getByRole('button', { name: 'Rubber' }).click();
  // Across the first two strokes.
  await drawWithPen(page, [
    { x: 0.12, y: 0.52, force: 0.5 },
    { x: 0.16, y: 0.52, force: 0.5 },
    { x: 0.22, y: 0.52, force: 0.5 },
    { x: 0.24, y: 0.52, force: 0.5 },
  ]);
  await expect(said).toHaveText(/^3 strokes/);
  await sheetOf(page).getByRole('button', { name: 'Undo' }).click();
  await expect(said).toHaveText(/^5 strokes/);
  await sheetOf(page).getByRole('button', { name: 'Clear the sheet' }).click();
  await expect(said).toHaveText('5 strokes are enough to begin with.');
  await sheetOf(page).getByRole('button', { name: 'Undo' }).click();
  await expect(said).toHaveText(/^5 strokes/);
});

test('a slider of the hand changes the drawing, keeps its value when more is drawn, and goes back', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await openSheet(page);
  await drawStrokes(page, 5);
  const slider = sheetOf(page).getByRole('slider', { name: 'Wobble' });
  await ready(page);
  const learnt = await readDrawing(page);
  await slider.focus();
  const [value] = [await numberOf(page, 'Wobble')];
  for (let i = 0; i < 10; i++) await page.keyboard.press('PageUp');
  expect(await numberOf(page, 'Wobble')).toBeGreaterThan(value + 0.3);
  await expect.poll(async () => (await readDrawing(page)).data.equals(learnt.data)).toBe(false);
  const set = await numberOf(page, 'Wobble');
  await drawStrokes(page, 1, 5);
  await expect(saidOf(page)).toHaveText(/^6 strokes/);
  expect(await numberOf(page, 'Wobble')).toBe(set);
  await sheetOf(page).getByRole('button', { name: 'As learnt' }).click();
  expect(await numberOf(page, 'Wobble')).toBeLessThan(value + 0.1);
});

test('a hand is saved as a file and loaded into another drawing; a bad file is refused in a sentence', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await openSheet(page);
  await drawStrokes(page, 5);
  await ready(page);
  const own = await readDrawing(page);
  const download = page.waitForEvent('download');
  await sheetOf(page).getByRole('button', { name: 'Save the hand as a file' }).click();
  const file = await download;
  expect(file.suggestedFilename()).toBe('hand.json');
  const json = await readFile(await file.path());
  await page.getByRole('button', { name: 'Clear the sheet' }).click();
  await expect.poll(async () => (await readDrawing(page)).data.equals(own.data)).toBe(false);
  const spoilt = Buffer.from(json.toString().replace(/"version":1/, '"version":9'));
  await drop(page, [{ name: 'hand.json', mimeType: 'application/json', buffer: spoilt }]);
  await expect(page.locator('#status')).toContainText('hand.version is 9, but must be 1');
  await drop(page, [{ name: 'mine.json', mimeType: 'application/json', buffer: json }]);
  await expect(saidOf(page)).toHaveText(/^5 strokes/);
  await expect.poll(async () => (await readDrawing(page)).data.equals(own.data)).toBe(true);
});

test('a link contains the hand, and a reload keeps its strokes', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await openSheet(page);
  await drawStrokes(page, 5);
  await ready(page);
  const own = await readDrawing(page);
  const length = await numberOf(page, 'Length');
  const link = (await writtenHash(page)).slice(1);
  expect(link).toMatch(/mapStyle=ownHand&.*hand=[\w-]+/);
  expect(link.length).toBeLessThan(2100);
  await page.reload();
  await ready(page);
  expect((await readDrawing(page)).data.equals(own.data)).toBe(true);
  // Opened in another browser, without storage.
  await page.evaluate(() => history.replaceState(null, '', location.href));
  await page.reload();
  await ready(page);
  await openSheet(page);
  await expect(saidOf(page)).toHaveText(/^5 strokes/);
  expect(Math.abs((await numberOf(page, 'Length')) - length)).toBeLessThan(0.11);
});

test('a link with a damaged hand is drawn without it, and says so', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, `${PLAIN}&mapStyle=ownHand&hand=AAAA`);
  await expect(page.locator('#status')).toContainText('The hand in this link is damaged');
  await expect(page.getByRole('combobox', { name: 'Style' }).locator('option:checked')).toHaveText('Hatching');
});

test('on a small phone one finger draws, two do not, and the model stays visible', { tag: '@all' }, async ({
  browser,
  baseURL,
}) => {
  const context = await browser.newContext({ viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true });
  const page = await context.newPage();
  await page.goto(`${baseURL}#${PLAIN}`);
  await ready(page);
  await page.getByRole('button', { name: 'Settings' }).tap();
  await page.getByRole('button', { name: 'Draw with your own hand' }).tap();
  await expect(sheetOf(page)).toBeVisible();
  const model = (await page.locator('#viewport').boundingBox())!;
  expect([model.width > 300, model.height > 180]).toEqual([true, true]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  await swatches(page).scrollIntoViewIfNeeded();
  const box = (await swatches(page).boundingBox())!;
  const cdp = await context.newCDPSession(page);
  const touch = async (type: 'touchStart' | 'touchMove' | 'touchEnd', ...places: (readonly [number, number])[]) =>
    void (await cdp.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: places.map(([x, y], id) => ({ x: box.x + x * box.width, y: box.y + y * box.height, id })),
    }));
  await touch('touchStart', [0.2, 0.5]);
  for (let i = 1; i <= 6; i++) await touch('touchMove', [0.2 + 0.05 * i, 0.5]);
  await touch('touchEnd');
  const said = saidOf(page);
  await expect(said).toHaveText(/^1 stroke:/);
  await touch('touchStart', [0.2, 0.6]);
  await touch('touchMove', [0.4, 0.6]);
  await touch('touchStart', [0.4, 0.6], [0.6, 0.8]);
  await touch('touchMove', [0.5, 0.6], [0.7, 0.8]);
  await touch('touchEnd');
  await touch('touchStart', [0.2, 0.8]);
  for (let i = 1; i <= 6; i++) await touch('touchMove', [0.2 + 0.05 * i, 0.8]);
  await touch('touchEnd');
  await expect(said).toHaveText(/^2 strokes:/);
  await context.close();
});

test('by keyboard the sheet opens, closes with Escape, and gives the focus back', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  const opener = page.getByRole('button', { name: 'Draw with your own hand' });
  await opener.focus();
  await page.keyboard.press('Enter');
  await expect(sheetOf(page)).toBeVisible();
  await expect(sheetOf(page).getByRole('button', { name: 'Close' })).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(sheetOf(page)).toBeHidden();
  await expect(opener).toBeFocused();
});

test('without drawing: a given hand is chosen and varied by keyboard, and the model is hatched with it', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, PLAIN);
  const before = await readDrawing(page);
  await page.getByRole('button', { name: 'Draw with your own hand' }).press('Enter');
  const given = sheetOf(page).getByRole('combobox', { name: 'Begin from' });
  await given.focus();
  await page.keyboard.press('ArrowDown');
  await expect(given.locator('option:checked')).toHaveText('a pointed brush');
  await expect.poll(async () => (await readDrawing(page)).data.equals(before.data)).toBe(false);
  const brush = await readDrawing(page);
  await page.keyboard.press('ArrowDown');
  await expect(given.locator('option:checked')).toHaveText('a dry brush');
  await expect.poll(async () => (await readDrawing(page)).data.equals(brush.data)).toBe(false);
  const dry = await readDrawing(page);
  const length = await numberOf(page, 'Length');
  await sheetOf(page).getByRole('slider', { name: 'Length', exact: true }).focus();
  await page.keyboard.press('Home');
  expect(await numberOf(page, 'Length')).toBeLessThan(length);
  await expect.poll(async () => (await readDrawing(page)).data.equals(dry.data)).toBe(false);
  // The varied hand is none of the given hands.
  await expect(given.locator('option:checked')).toHaveText('an empty sheet');
});

/** A grey picture with so many slanted strokes in a row, as a scanner has it: 10 pixels to a millimetre. */
async function scan(name: string, strokes: number) {
  const [width, height] = [600, 300];
  const data = new Uint8Array(width * height).fill(235);
  for (let i = 0; i < strokes; i++) {
    for (let k = 0; k <= 400; k++) {
      const [x, y] = [60 + 55 * i + 0.15 * k, 240 - 0.4 * k];
      for (let v = -4; v <= 4; v++) {
        for (let u = -4; u <= 4; u++) {
          if (u * u + v * v <= 16) data[Math.round(y + v) * width + Math.round(x + u)] = 40;
        }
      }
    }
  }
  return { name, mimeType: 'image/png', buffer: Buffer.from(await encodePng({ width, height, channels: 1, data })) };
}

test('a hand is learnt from the strokes of a picture; a picture without strokes and a file that is not a picture are refused in a sentence', {
  tag: '@all',
}, async ({ page }) => {
  await openPlayground(page, PLAIN);
  const before = await readDrawing(page);
  await openSheet(page);
  const pick = async (file: Awaited<ReturnType<typeof scan>>): Promise<void> => {
    const chooser = page.waitForEvent('filechooser');
    await sheetOf(page).getByRole('button', { name: 'From a picture' }).click();
    await (await chooser).setFiles(file);
  };
  await pick(await scan('blank.png', 0));
  await expect(page.locator('#status')).toContainText(/^blank\.png: .*no strokes/);
  await pick({ name: 'notes.png', mimeType: 'image/png', buffer: Buffer.from('not a picture') });
  await expect(page.locator('#status')).toHaveText(
    'notes.png is no picture that this browser can read: PNG and JPEG are.',
  );
  await expect(saidOf(page)).toHaveText('5 strokes are enough to begin with.');
  expect((await readDrawing(page)).data.equals(before.data)).toBe(true);
  await pick(await scan('swatch.png', 8));
  await expect(saidOf(page)).toHaveText(/^8 strokes/);
  await expect.poll(async () => (await readDrawing(page)).data.equals(before.data)).toBe(false);
  // 160 pixels high in a field of 24 mm less its margin: nothing was made smaller. Each is 17 mm long.
  expect(Math.abs((await numberOf(page, 'Length')) - Math.hypot(6, 16))).toBeLessThan(1.7);
  expect(Math.abs((await numberOf(page, 'Width')) - 0.9)).toBeLessThan(0.12);
});

test('the copied code draws with the hand as a file beside it', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, PLAIN);
  await openSheet(page);
  await drawStrokes(page, 5);
  await ready(page);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Picture' }).click();
  await page.getByRole('button', { name: 'Code and embedding' }).click();
  await page.getByRole('combobox', { name: 'As' }).selectOption('A module');
  const code = await page.getByRole('textbox', { name: 'The code' }).inputValue();
  expect(code).toContain("tonalArtMap: { hand: await (await fetch('hand.json')).json(), size: 64, tones: 4 },");
  expect(code).toContain('saves your own hand as hand.json');
});
