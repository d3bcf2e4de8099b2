import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { openPlayground, ready, refreshes } from '../../tools/browser/playground.js';
import { FIGURES, type Figure } from '../../tools/figures/figures.js';
import { expect, test } from '../browser/test.js';
import { angleBetween, changedShare, strokeDirection } from './pictures.js';

test.use({ viewport: { width: 860, height: 560 } });

/** Within the middle triangle of figure 4, which almost faces the viewer. */
const MIDDLE_TRIANGLE = { left: 0.44, top: 0.2, right: 0.54, bottom: 0.4 };

const panelOf = (number: Figure['number'], name: string) => `#figure-${number} [data-panel="${name}"]`;

async function openFigures(page: Page): Promise<void> {
  await page.goto('./figures');
  await settled(page);
}

/** Waits until every panel in view is up to date. */
async function settled(page: Page): Promise<void> {
  // Two frames, so that the page knows what is in view.
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  await page.waitForFunction(() => window.__figures?.isIdle, null, { timeout: 90_000 });
  expect(await page.locator('#status').textContent()).toBe('');
}

async function scrollTo(page: Page, selector: string): Promise<void> {
  await page.locator(selector).evaluate((element) => element.scrollIntoView({ block: 'center' }));
  await settled(page);
}

/** The picture that a panel shows. */
async function readPanel(page: Page, selector: string): Promise<PNG> {
  await scrollTo(page, selector);
  return pictureOf(page, selector);
}

/** The picture of a panel in view. */
async function pictureOf(page: Page, selector: string): Promise<PNG> {
  const address = await page.locator(selector).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  return PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
}

/** Turns the light by 45°, by keys. */
async function turnLight(page: Page): Promise<void> {
  await page.getByRole('slider', { name: 'Turn the light' }).focus();
  for (let i = 0; i < 9; i++) await page.keyboard.press('ArrowRight');
  await expect(page.locator('#turn-value')).toHaveText('45°');
}

/** Whether a panel in view is of one colour. Asked of the page: encoding every panel takes longer than drawing it. */
const isBlank = (page: Page, selector: string): Promise<boolean> =>
  page.locator(selector).evaluate((canvas: HTMLCanvasElement) => {
    const small = document.createElement('canvas').getContext('2d')!;
    small.drawImage(canvas, 0, 0, small.canvas.width, small.canvas.height);
    const { data } = small.getImageData(0, 0, small.canvas.width, small.canvas.height);
    return new Set(new Uint32Array(data.buffer)).size === 1;
  });

test('every figure has a caption, and every panel of it is drawn, in one graphics context; light and technique change what they should', {
  tag: '@all',
}, async ({ page }) => {
  test.setTimeout(300_000);
  const addresses: string[] = [];
  page.on('request', (request) => addresses.push(request.url()));
  await page.addInitScript(() => {
    const moved: string[] = [];
    (window as unknown as { __moved: string[] }).__moved = moved;
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) moved.push(JSON.stringify(entry));
    }).observe({ type: 'layout-shift', buffered: true });
    addEventListener('securitypolicyviolation', (event) => moved.push(`forbidden: ${event.violatedDirective}`));
  });
  await openFigures(page);
  expect(FIGURES.map(({ number }) => number)).toEqual([4, 8, 9, 10, 11, 12, 13, 14, 'A', 'B', 'C', 'D']);
  await expect(page.getByRole('heading', { name: 'Beyond the paper' })).toHaveCount(1);
  const rowsOfLines = await page.locator('.row').evaluateAll((rows) =>
    rows.map((row) => {
      const tops = [...row.querySelectorAll('canvas')].map((canvas) => Math.round(canvas.getBoundingClientRect().top));
      return new Set(tops).size;
    }),
  );
  expect(rowsOfLines, 'the panels of a row stand side by side').toEqual(rowsOfLines.map(() => 1));
  const lastPanels = FIGURES.map(({ number, rows }) => panelOf(number, rows.at(-1)!.panels.at(-1)!.name));
  const blending: [string, boolean][] = [
    [panelOf(4, 'a'), false],
    [panelOf(4, 'b'), true],
    [panelOf(8, 'all'), false],
    [panelOf(14, 'tangent'), true],
  ];
  const compared = new Set([...lastPanels, ...blending.map(([selector]) => selector)]);
  const before = new Map<string, PNG>();
  for (const figure of FIGURES) {
    const caption = page.getByRole('figure').filter({ hasText: `Figure ${figure.number}. ${figure.title}` });
    await expect(caption).toContainText(figure.inThePaper ?? figure.here);
    await expect(caption).toContainText(figure.here);
    for (const { name } of figure.rows.flatMap(({ panels }) => panels)) {
      const selector = panelOf(figure.number, name);
      await scrollTo(page, selector);
      expect(await isBlank(page, selector), selector).toBe(false);
      if (compared.has(selector)) before.set(selector, await pictureOf(page, selector));
    }
  }
  const changeOf = async (selector: string) => changedShare(before.get(selector)!, await readPanel(page, selector));

  // The light turns the strokes of every figure, by key and by touch.
  const lamp = page.getByRole('slider', { name: 'Turn the light' });
  await turnLight(page);
  for (const selector of lastPanels) expect(await changeOf(selector), selector).toBeGreaterThan(0.02);
  const { x, y, width, height } = (await lamp.boundingBox())!;
  await page.mouse.click(x + width / 2, y + height / 2);
  await expect(page.locator('#turn-value')).toHaveText('0°');
  for (const selector of lastPanels.slice(0, 2)) expect(await changeOf(selector), selector).toBe(0);

  // The technique changes the panels that blend, and no others.
  await page.getByRole('radio', { name: 'as in the paper' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('radio', { name: 'hatching' })).toBeChecked();
  for (const [selector, isChanged] of blending) expect((await changeOf(selector)) > 0.02, selector).toBe(isChanged);

  expect(await page.evaluate(() => window.__webglContexts?.length)).toBe(1);
  expect(await page.evaluate(() => (window as unknown as { __moved: string[] }).__moved)).toEqual([]);
  const { origin } = new URL(page.url());
  expect(addresses.filter((address) => !address.startsWith(origin) && !/^(blob|data):/.test(address))).toEqual([]);
});

test.describe('on a screen of high resolution, where strokes are wide enough to measure', () => {
  test.use({ deviceScaleFactor: 2 });

  test('strokes of a flat triangle that faces the viewer follow a light that turns about the line of sight', {
    tag: '@all',
  }, async ({ page }) => {
    await openFigures(page);
    const direction = strokeDirection(await readPanel(page, panelOf(4, 'a')), MIDDLE_TRIANGLE);
    await turnLight(page);
    const turned = strokeDirection(await readPanel(page, panelOf(4, 'a')), MIDDLE_TRIANGLE);
    expect(angleBetween(turned, direction)).toBeGreaterThan(35);
    expect(angleBetween(turned, direction + 45)).toBeLessThan(10);
  });
});

test('draws nothing while nothing changes, and only what is in view when something does', { tag: '@all' }, async ({
  page,
}) => {
  await openFigures(page);
  const frames = () => page.evaluate(() => window.__figures!.framesDrawn);
  const before = await frames();
  await refreshes(page, 10);
  expect(await frames()).toBe(before);
  const sizeOfLast = () => page.locator(panelOf(14, 'tangent')).evaluate((canvas: HTMLCanvasElement) => canvas.width);
  expect(await sizeOfLast()).toBe(0);
  await page.locator('#turn').press('ArrowLeft');
  await settled(page);
  expect(await frames()).toBeGreaterThan(before);
  expect(await sizeOfLast()).toBe(0);
});

test('fits a screen 360 pixels wide in dark mode, with a light slider large enough for a thumb', {
  tag: '@all',
}, async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 360, height: 640 });
  await openFigures(page);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(360);
  const lamp = page.getByRole('slider', { name: 'Turn the light' });
  for (const target of [
    lamp,
    page.getByRole('link', { name: 'Playground' }),
    page.getByText('hatching', { exact: true }),
  ]) {
    const box = (await target.boundingBox())!;
    expect(box.height).toBeGreaterThanOrEqual(44);
    expect(box.x + box.width).toBeLessThanOrEqual(360);
  }
  await scrollTo(page, panelOf(14, 'tangent'));
  const { y, height } = (await lamp.boundingBox())!;
  expect(y + height).toBeLessThanOrEqual(640);
  const box = (await page.locator(panelOf(14, 'tangent')).boundingBox())!;
  expect(box.width).toBeGreaterThan(140);
});

test('the pages link to each other', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, 'model=cube');
  await page.getByRole('link', { name: 'Figures' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('The figures of the paper');
  await settled(page);
  await page.getByRole('link', { name: 'Playground' }).click();
  await expect(page.locator('#drawing')).toBeVisible();
  await ready(page);
  // The links work on the development server too.
  expect((await page.request.get('/figures')).url()).toMatch(/\/figures\/$/);
});

test('a lost graphics context is reported, and the figures come back', { tag: '@all' }, async ({ page }) => {
  await openFigures(page);
  const before = await readPanel(page, panelOf(4, 'b'));
  await page.evaluate(() => {
    const extension = window.__webglContexts![0].getExtension('WEBGL_lose_context')!;
    (window as unknown as { __bringBack: () => void }).__bringBack = () => extension.restoreContext();
    extension.loseContext();
  });
  await expect(page.locator('#status')).toHaveText(/^The graphics card has let go of the figures/);
  await page.locator('#turn').press('ArrowLeft');
  await page.evaluate(() => (window as unknown as { __bringBack: () => void }).__bringBack());
  await expect(page.locator('#status')).toHaveText('');
  expect(changedShare(before, await readPanel(page, panelOf(4, 'b')))).toBeGreaterThan(0.02);
});

test('a browser without WebGL 2 gets a message, and the captions', { tag: '@all' }, async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto('./figures/');
  await expect(page.locator('#status')).toHaveText(/^The figures need WebGL 2/);
  await expect(page.getByRole('figure')).toHaveCount(FIGURES.length);
});
