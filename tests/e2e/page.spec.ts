import { chromium, type Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { launchOptions } from '../../tools/browser/launchOptions.mjs';
import {
  drop,
  fetchedAhead,
  framesDrawn,
  idle,
  middleOf,
  openPlayground,
  readDrawing,
  ready,
  refreshes,
  savePicture,
  writtenHash,
} from '../../tools/browser/playground.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { file, octahedronObj, octahedronPly } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { loseContext, restoreContext } from './graphicsContext.js';
import { changedShare, largestDifference, meanInk } from './pictures.js';

test.use({ viewport: { width: 400, height: 300 } });

/** A model and a map that are made in no time. */
const SMALL = 'model=cube&mapSize=64&mapTones=4&outlines=off';

test('opens with the dragon, hatched, without a layout shift and without requests to other sites', async ({ page }) => {
  const addresses: string[] = [];
  page.on('request', (request) => addresses.push(request.url()));
  await page.addInitScript(() => {
    const problems: string[] = [];
    (window as unknown as { __problems: string[] }).__problems = problems;
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        const { sources } = entry as unknown as { sources: { node: Node | null }[] };
        problems.push(...sources.map(({ node }) => `moved: ${(node?.parentElement ?? undefined)?.outerHTML}`));
      }
    }).observe({ type: 'layout-shift', buffered: true });
    addEventListener('securitypolicyviolation', (event) => problems.push(`forbidden: ${event.violatedDirective}`));
  });
  await page.setViewportSize({ width: 900, height: 600 });
  await openPlayground(page);
  await expect(page.locator('#model-name')).toHaveText('Stanford dragon');
  await expect(page.locator('#model-statistics')).toHaveText(/^47,794 triangles, 2,094 non-manifold edges$/);
  await expect(page.getByRole('slider', { name: 'Light' })).toBeVisible();
  await expect(page.getByText('drag the light')).toBeVisible();
  const picture = await readDrawing(page);
  expect(meanInk(picture)).toBeGreaterThan(0.03);
  expect(meanInk(picture)).toBeLessThan(0.4);
  // Its shadow is not cut by the edge of the sheet.
  expect(meanInk(picture, { left: 0.975, top: 0, right: 0.99, bottom: 0.85 })).toBeLessThan(0.001);
  const notice = page.getByRole('link', { name: 'Credits and licences' });
  await expect(notice).toBeVisible();
  const { origin, href } = new URL(page.url());
  const terms = await page.request.get(new URL((await notice.getAttribute('href'))!, href).href);
  expect(await terms.text()).toContain('Stanford Computer Graphics Laboratory');
  expect(addresses.filter((address) => !address.startsWith(origin) && !/^(blob|data):/.test(address))).toEqual([]);
  expect(await page.evaluate(() => (window as unknown as { __problems: string[] }).__problems)).toEqual([]);
});

test('the first model is read by one worker that was begun before the page’s script, and other models are not read ahead', {
  tag: '@all',
}, async ({ page }) => {
  const opened = async (hash: string): Promise<string[]> => {
    const seen: string[] = [];
    const note = (address: string): void => {
      const name = /\/(graphics|index|model\.worker|dragon_vrip_res3(?:\.ply|_occlusion))[^/]*$/.exec(address);
      if (name) seen.push(name[1]);
    };
    await page.addInitScript(() => {
      const { Worker: PlainWorker } = window;
      const before: string[] = [];
      window.Worker = class extends PlainWorker {
        constructor(...args: ConstructorParameters<typeof Worker>) {
          super(...args);
          if (!window.__playground) before.push(String(args[0]));
        }
      };
      Object.assign(window, { __before: before });
    });
    page.on('request', (request) => note(request.url()));
    await openPlayground(page, hash);
    page.removeAllListeners('request');
    const before = await page.evaluate(() => (window as unknown as { __before: string[] }).__before);
    return [...before.map((address) => /(graphics|model\.worker)/.exec(address)?.[1] ?? ''), '|', ...seen.sort()];
  };
  const first = await opened('');
  expect(first.slice(0, first.indexOf('|'))).toEqual(['graphics', 'model.worker']);
  for (const file of ['dragon_vrip_res3.ply', 'dragon_vrip_res3_occlusion'])
    expect(first.filter((name) => name === file)).toHaveLength(1);
  expect(first.slice(first.indexOf('|')).filter((name) => name === 'model.worker')).toHaveLength(1);
  await page.goto('about:blank');
  const other = await opened(`${SMALL}&technique=triangle`);
  expect(other.slice(0, other.indexOf('|'))).toEqual(['graphics']);
  expect(other.filter((name) => name.startsWith('dragon'))).toEqual([]);
  // A script that comes after the page's own would do once more what that has done.
  await page.goto('about:blank');
  await page.route(/\/ahead-[^/]*\.js$/, async (route) => {
    await page.waitForFunction(() => window.__playground);
    await route.continue();
  });
  const late = await opened(`${SMALL}&technique=triangle`);
  expect(late).toContain('index');
  expect(late).not.toContain('graphics');
});

test('unopened parts of the page open without a connection, once the page has been idle', async ({
  page,
  pageProblems,
}) => {
  await page.setViewportSize({ width: 1000, height: 600 });
  await openPlayground(page, SMALL);
  // All its files are fetched, and none is run.
  const parts = await fetchedAhead(page);
  expect(parts.length).toBeGreaterThan(20);
  await expect(page.locator('link[rel=modulepreload][href^=assets]')).toHaveCount(0);

  // While Playwright blocks the network, a new worker neither runs nor fails.
  await page.route(/^https?:/, (route) => route.abort('internetdisconnected'));
  await page.getByRole('button', { name: 'Gallery' }).click();
  await expect(page.getByRole('heading', { name: 'Gallery' })).toBeVisible();
  await page.keyboard.press('Escape');
  await page.getByRole('combobox', { name: 'Compare with' }).selectOption('Engraving');
  await expect(page.locator('#divider')).toBeVisible();
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  await page.getByRole('button', { name: 'Code and embedding' }).click();
  await expect(page.locator('#code-text')).toHaveValue(/applyHatching|HatchingMaterial/);
  await page.keyboard.press('Escape');
  await savePicture(page);
  // The worker can no longer be fetched, so the file is read on the main thread.
  await drop(page, [file('octahedron.obj', octahedronObj)]);
  await expect(page.locator('#model-name')).toHaveText('octahedron.obj');
  await ready(page);
  await expect(page.locator('#status')).toHaveText('');
  // The pictures of the gallery, the worker, the icon of the page.
  const isOffline = (problem: string) =>
    /ERR_INTERNET_DISCONNECTED.*(gallery\/.*\.webp|worker|lamp\.svg)/s.test(problem);
  expect(pageProblems.splice(0).filter((problem) => !isOffline(problem))).toEqual([]);
});

test('an idle page draws no frames', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, SMALL);
  const before = await framesDrawn(page);
  await refreshes(page, 10);
  expect(await framesDrawn(page)).toBe(before);
  await page.locator('#lamp').press('ArrowLeft');
  await ready(page);
  expect(await framesDrawn(page)).toBeGreaterThan(before);
});

test('the camera orbits by mouse and keys, and frames the whole model again', { tag: '@all' }, async ({ page }) => {
  // Wide enough for the lamp to lie beside the middle.
  await page.setViewportSize({ width: 640, height: 480 });
  await openPlayground(page, SMALL);
  const first = await readDrawing(page);
  const { x, y } = await middleOf(page, '#viewport');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 20, { steps: 3 });
  await page.mouse.up();
  expect(changedShare(first, await readDrawing(page))).toBeGreaterThan(0.05);
  await page.mouse.dblclick(x, y);
  expect(changedShare(first, await readDrawing(page))).toBe(0);
  await page.locator('#drawing').press('ArrowLeft');
  await page.locator('#drawing').press('+');
  expect(changedShare(first, await readDrawing(page))).toBeGreaterThan(0.05);
  await page.locator('#drawing').press('Home');
  expect(changedShare(first, await readDrawing(page))).toBe(0);
});

test('another model is seen whole, however near the camera was; a link keeps its own place', { tag: '@all' }, async ({
  page,
}) => {
  const near = '0.2,0.1,1,0,0,0.7';
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, `${SMALL}&camera=${near}`);
  await page.evaluate((camera) => {
    location.hash = `model=sphere&mapSize=64&mapTones=4&outlines=off&camera=${camera}`;
  }, near);
  await expect(page.locator('#model-name')).toHaveText('Sphere');
  expect(await writtenHash(page)).toContain(encodeURIComponent(near));
  await page.getByRole('combobox', { name: 'Model', exact: true }).selectOption('Cube');
  await expect(page.locator('#model-name')).toHaveText('Cube');
  expect(await writtenHash(page)).not.toContain('camera');
});

test('the link restores every setting after a reload, and unknown ones are ignored', async ({ page }) => {
  await openPlayground(page, `${SMALL}&strokeWidth=3&ink=%23203080&lightElevation=999&technique=magic&nothing=1`);
  const picture = await readDrawing(page);
  await page.locator('#lamp').press('ArrowDown');
  expect(await writtenHash(page)).toContain('lightElevation=84');
  await page.locator('#lamp').press('ArrowUp');
  const written = await writtenHash(page);
  expect(written).toContain('lightElevation=89');
  expect(written).not.toContain('magic');
  await page.reload();
  expect(changedShare(picture, await readDrawing(page))).toBe(0);
});

test('saves the drawing as PNG, on paper and without, at the size of the page and larger', async ({ page }) => {
  // Four times as wide is wider than a tile.
  await page.setViewportSize({ width: 560, height: 280 });
  await openPlayground(page, SMALL);
  const shown = await readDrawing(page);
  const onPaper = await savePicture(page);
  expect([onPaper.width, onPaper.height]).toEqual([shown.width, shown.height]);
  expect([...onPaper.data.subarray(0, 4)]).toEqual([0xf7, 0xf3, 0xe8, 255]);
  expect(changedShare(shown, onPaper)).toBeLessThan(0.001);

  await openPlayground(page, `${SMALL}&pictureGround=transparent`);
  const small = await savePicture(page);
  expect([...small.data.subarray(0, 4)]).toEqual([0, 0, 0, 0]);

  await openPlayground(page, `${SMALL}&pictureGround=strokes`);
  const strokes = await savePicture(page);
  expect(opaqueShare(strokes)).toBeGreaterThan(0.02);
  expect(opaqueShare(strokes)).toBeLessThan(0.6 * opaqueShare(small));
  // Every opaque pixel is ink. None is paper, not even partly.
  expect(lightestRed(strokes)).toBeLessThan(0x40);

  // Large enough to be drawn in tiles, which must fit together.
  await openPlayground(page, `${SMALL}&pictureSize=4&pictureGround=transparent`);
  const large = await savePicture(page);
  expect([large.width, large.height]).toEqual([4 * shown.width, 4 * shown.height]);
  expect(opaqueShare(small)).toBeGreaterThan(0.1);
  expect(differentlyOpaqueShare(small, large)).toBeLessThan(0.01);
  // Saving does not change what the page shows.
  expect(changedShare(shown, await readDrawing(page))).toBe(0);
  await page.getByRole('button', { name: 'Settings' }).click();
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  await page.getByLabel('Layers').last().selectOption('Apart, in a ZIP');
  await expect(page.getByRole('button', { name: 'Save ZIP' })).toHaveCount(2);
});

test('copies the picture to the clipboard, asked for within the click; where that is not allowed, one sentence says so', {
  tag: '@all',
}, async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.addInitScript(() => {
    const { write } = Clipboard.prototype;
    Clipboard.prototype.write = function (items) {
      // The event exists only while a click is handled.
      document.documentElement.dataset.asked = window.event?.type ?? 'too late';
      if (location.search === '?refused') return Promise.reject(new DOMException('No.', 'NotAllowedError'));
      return write.call(this, items);
    };
  });
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, SMALL);
  const saved = await savePicture(page);
  const copy = async (): Promise<void> => {
    await page.getByRole('button', { name: 'Picture', exact: true }).click();
    await page.getByRole('button', { name: 'Copy the picture' }).click();
  };
  await copy();
  await expect(page.locator('#status')).toHaveText('The picture is on the clipboard, as PNG.');
  await expect(page.locator('html')).toHaveAttribute('data-asked', 'click');
  const base64 = await page.evaluate(async () => {
    const [item] = await navigator.clipboard.read();
    const bytes = new Uint8Array(await (await item.getType('image/png')).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  });
  expect(largestDifference(PNG.sync.read(Buffer.from(base64, 'base64')), saved)).toBe(0);

  await page.goto(`./?refused#${SMALL}`);
  await ready(page);
  await copy();
  await expect(page.locator('#status')).toHaveText(
    'The browser does not let this page use the clipboard: save the picture instead.',
  );
});

test.describe('with a touch screen', () => {
  test.use({ hasTouch: true });

  test('copies the facts for a report by key and by touch, without the name of the file', { tag: '@all' }, async ({
    page,
    context,
  }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await openPlayground(page, 'mapSize=64&mapTones=4&outlines=off&ink=%23123456');
    await drop(page, [file('secret.ply', octahedronPly)]);
    await expect(page.locator('#model-name')).toHaveText('secret.ply');
    await idle(page);
    await page.getByRole('button', { name: 'Settings', exact: true }).tap();
    const group = page.getByRole('button', { name: 'Picture', exact: true });
    const copy = page.getByRole('button', { name: 'Copy the facts for a report' });
    await group.focus();
    await page.keyboard.press('Enter');
    for (const press of [() => copy.press('Enter'), () => copy.tap()]) {
      await page.evaluate(() => navigator.clipboard.writeText(''));
      await press();
      const copied = (): Promise<string> => page.evaluate(() => navigator.clipboard.readText());
      await expect.poll(copied).not.toBe('');
      await expect(page.locator('#status')).toHaveText('The facts are on the clipboard, without the name of a file.');
      const facts = await copied();
      for (const fact of [
        `Browser: ${await page.evaluate(() => navigator.userAgent)}`,
        'Model: own, PLY, in 1 file',
        'Mesh: 8 triangles',
        'ink=%23123456',
      ]) {
        expect(facts).toContain(fact);
      }
      expect(facts).toMatch(/^three-hatching: \d+\.\d+\.\d+\nthree\.js: r\d+\n/);
      expect(facts).toMatch(/\nGraphics: \S+/);
      expect(facts).not.toContain('secret');
    }

    // Without permission for the clipboard, they are saved as a file.
    await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
    const [download] = await Promise.all([page.waitForEvent('download'), copy.press('Enter')]);
    expect(download.suggestedFilename()).toBe('three-hatching-facts.txt');
  });
});

function opaqueShare({ data }: PNG): number {
  let opaque = 0;
  for (let i = 3; i < data.length; i += 4) if (data[i] > 127) opaque++;
  return opaque / (data.length / 4);
}

/** The highest red value of all pixels that are not nearly transparent. */
function lightestRed({ data }: PNG): number {
  let lightest = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 40) lightest = Math.max(lightest, data[i]);
  return lightest;
}

/** The share of pixels that are opaque in one picture and transparent at the same place of the other, larger one. */
function differentlyOpaqueShare(small: PNG, large: PNG): number {
  const factor = large.width / small.width;
  let different = 0;
  for (let y = 0; y < small.height; y++) {
    for (let x = 0; x < small.width; x++) {
      const inSmall = small.data[4 * (y * small.width + x) + 3] > 127;
      const [largeX, largeY] = [Math.floor((x + 0.5) * factor), Math.floor((y + 0.5) * factor)];
      if (inSmall !== large.data[4 * (largeY * large.width + largeX) + 3] > 127) different++;
    }
  }
  return different / (small.width * small.height);
}

test('fits a screen 360 pixels wide, with everything large enough for a thumb', { tag: '@all' }, async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await openPlayground(page, SMALL);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(360);
  expect(await page.evaluate(() => document.documentElement.scrollHeight)).toBe(740);
  const settings = page.getByRole('button', { name: 'Settings' });
  await expect(page.getByLabel('Technique')).toBeHidden();
  for (const target of [page.locator('#lamp'), settings, page.getByRole('button', { name: 'Open a model' })]) {
    const box = (await target.boundingBox())!;
    expect(box.width).toBeGreaterThanOrEqual(44);
    expect(box.height).toBeGreaterThanOrEqual(44);
    expect(box.x).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width).toBeLessThanOrEqual(360);
  }
  await settings.click();
  await expect(page.getByLabel('Technique')).toBeVisible();
  const viewport = (await page.locator('#viewport').boundingBox())!;
  const card = (await page.locator('#card').boundingBox())!;
  expect(viewport.height).toBeGreaterThan(180);
  expect(viewport.y + viewport.height).toBeLessThanOrEqual(card.y);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(360);
  await page.keyboard.press('Escape');
  await expect(page.getByLabel('Technique')).toBeHidden();
});

test('settings have labels and units, apply at once and are reset by double-click', { tag: '@all' }, async ({
  page,
}) => {
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, `${SMALL}&technique=adjacency`);
  const before = await readDrawing(page);
  await page.getByRole('button', { name: 'More' }).click();
  const scale = page.getByLabel('Stroke scale');
  await scale.fill('6');
  await scale.press('Enter');
  expect(changedShare(before, await readDrawing(page))).toBeGreaterThan(0.05);
  await page.getByText('Stroke scale').dblclick();
  await expect(scale).toHaveValue('2.5');
  await expect(page.getByText('tiles').first()).toBeVisible();
  expect(changedShare(before, await readDrawing(page))).toBe(0);
  await page.getByLabel('Style').selectOption('Stippling');
  await expect.poll(async () => changedShare(before, await readDrawing(page))).toBeGreaterThan(0.05);
});

test('the drawing fills the screen by button and key, and a letter in a field does not make it', {
  tag: '@all',
}, async ({ page }) => {
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, `${SMALL}&technique=adjacency`);
  const filling = () => page.evaluate(() => document.fullscreenElement?.id);
  await page.getByRole('button', { name: 'View', exact: true }).click();
  await page.getByRole('button', { name: 'Full screen (F)' }).click();
  await expect.poll(filling).toBe('sheet');
  await ready(page);
  expect(meanInk(await readDrawing(page))).toBeGreaterThan(0.005);
  await page.locator('#drawing').press('f');
  await expect.poll(filling).toBe(undefined);
  await page.getByLabel('Technique').press('f');
  await page.locator('#drawing').press('Shift+F');
  await expect.poll(filling).toBe('sheet');
});

test('the keys are shown by ?, H, F1 and a button, but not by a letter in a field; an open fold has the height of the window', {
  tag: '@all',
}, async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 900 });
  await openPlayground(page, `${SMALL}&technique=adjacency`);
  const dialog = page.getByRole('dialog', { name: 'Keys and gestures' });
  for (const key of ['?', 'h', 'F1']) {
    await page.locator('#drawing').press(key);
    await expect(dialog, key).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(dialog).toBeHidden();
  }
  await page.getByRole('button', { name: 'Keys' }).click();
  await expect(dialog.getByText('full screen')).toBeVisible();
  await dialog.getByRole('button', { name: 'Close' }).click();
  await page.getByRole('button', { name: 'More' }).click();
  const width = page.getByRole('spinbutton', { name: 'Stroke scale' });
  for (const key of ['h', '?']) await width.press(key);
  await page.getByLabel('Technique').press('?');
  // It would have opened by then.
  await page.locator('#drawing').press('ArrowLeft');
  await idle(page);
  await expect(dialog).toBeHidden();

  // The longest fold fills the window.
  const seen = await page.evaluate(() => {
    const fold = document.querySelector('.lil-gui .lil-gui:not(.lil-closed)')!.getBoundingClientRect();
    const card = document.querySelector('#card')!.getBoundingClientRect();
    return Math.min(fold.bottom, card.bottom) - Math.max(fold.top, card.top) - Math.min(fold.height, card.height);
  });
  expect(seen).toBeGreaterThan(-2);
  expect(await page.evaluate(() => document.querySelector('#card')!.clientHeight)).toBeGreaterThan(780);
});

test('only settings of the techniques in use are offered', { tag: '@all' }, async ({ page }) => {
  await page.setViewportSize({ width: 840, height: 480 });
  await openPlayground(page, SMALL);
  await page.getByRole('button', { name: 'More' }).click();
  const [anchors, shift] = [page.getByLabel('Anchors'), page.getByLabel('Shift along')];
  await expect(anchors).toBeVisible();
  await expect(shift).toBeHidden();
  await page.getByLabel('Compare with').selectOption('Adjacency');
  await expect(anchors).toBeVisible();
  await expect(shift).toBeVisible();
  await page.getByLabel('Compare with').selectOption('Nothing');
  await page.getByLabel('Technique').selectOption('Per triangle');
  await expect(anchors).toBeHidden();
  await expect(shift).toBeVisible();
  // Dots come from no map and have no direction.
  const [style, direction] = [page.getByLabel('Style'), page.getByLabel('Strokes run', { exact: true })];
  await expect(style).toBeVisible();
  await page.getByRole('button', { name: 'Stipple', exact: true }).click();
  for (const hidden of [anchors, shift, style, direction]) await expect(hidden).toBeHidden();
  await page.getByRole('button', { name: 'Pencil', exact: true }).click();
  await page.getByLabel('Direction', { exact: true }).selectOption('The light');
  for (const shown of [anchors, style, direction]) await expect(shown).toBeVisible();
  // A pen draws the lines of another technique.
  await page.getByRole('button', { name: 'Pen', exact: true }).click();
  for (const hidden of [anchors, style, direction]) await expect(hidden).toBeHidden();
});

test.describe('a lost graphics context', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' }, viewport: { width: 400, height: 360 } });

  test('is reported and comes back with the same drawing and saved pictures; lost again, the last picture stays', async ({
    page,
  }) => {
    await openPlayground(page, `${SMALL}&technique=adjacency&shadows=on&ground=shadow`);
    // A model with a skin, a morph target and a texture.
    await drop(page, [file('column.glb', columnGlb())]);
    await expect(page.locator('#model-name')).toHaveText('column.glb');
    const before = await readDrawing(page);
    const saved = await savePicture(page);

    await loseContext(page);
    await expect(page.locator('#status')).toHaveText(/let go of the drawing\. It should come back/);
    await expect(page.locator('html')).toHaveAttribute('data-state', 'lost');
    await page.locator('#lamp').press('ArrowLeft');
    await page.locator('#lamp').press('ArrowRight');
    await page.getByRole('button', { name: 'Save PNG' }).last().click();
    await expect(page.locator('#status')).toHaveText(/nothing to save/);
    await restoreContext(page);
    await expect(page.locator('#status')).toHaveText('The drawing is back.');
    expect(largestDifference(before, await readDrawing(page))).toBe(0);
    expect(largestDifference(saved, await savePicture(page))).toBe(0);
    // From now on the page keeps a copy.
    await copied(page, before);

    await loseContext(page);
    await expect(page.locator('#status')).toHaveText(/again\. This is its last picture/);
    expect(largestDifference(before, await readLastPicture(page))).toBe(0);
    // Changes made meanwhile are drawn later.
    await drop(page, [file('octahedron.ply', octahedronPly)]);
    await expect(page.locator('#model-name')).toHaveText('octahedron.ply');
    await expect(page.locator('html')).toHaveAttribute('data-state', 'lost');
    await expect(page.locator('#status')).toHaveText(/again\. This is its last picture/);
    await restoreContext(page);
    expect(changedShare(before, await readDrawing(page))).toBeGreaterThan(0.05);
    // Disposes of what was uploaded before and after.
    await drop(page, [file('column.glb', columnGlb())]);
    await expect(page.locator('#model-name')).toHaveText('column.glb');
    expect(largestDifference(before, await readDrawing(page))).toBe(0);
  });
});

test('after a crash of the graphics process the same drawing comes back, also as a saved picture; after a second, its last picture stays', {
  tag: '@all',
}, async ({ baseURL }) => {
  // A browser of its own, because others would crash with it.
  const browser = await chromium.launch(await launchOptions());
  try {
    const page = await browser.newPage({ baseURL: baseURL!, viewport: { width: 400, height: 360 } });
    await openPlayground(page, SMALL);
    const shown = await readDrawing(page);
    const saved = await savePicture(page);
    const session = await browser.newBrowserCDPSession();
    const crash = () => session.send('Browser.crashGpuProcess').catch(() => {});
    await crash();
    await expect(page.locator('#status')).toHaveText('The drawing is back.');
    expect(largestDifference(shown, await readDrawing(page))).toBe(0);
    expect(largestDifference(saved, await savePicture(page))).toBe(0);
    await copied(page, shown);

    await crash();
    await expect(page.locator('#status')).toHaveText(/again\. This is its last picture/);
    expect(largestDifference(shown, await readLastPicture(page))).toBe(0);
  } finally {
    await browser.close();
  }
});

/** Waits until the page has a copy of the picture, as it is shown. Where frames follow each other, it is made a second after the first. */
async function copied(page: Page, shown: PNG): Promise<void> {
  await expect
    .poll(async () => {
      const address = await page.locator('.last-picture').evaluate((copy: HTMLCanvasElement) => copy.toDataURL());
      const copy = PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
      return copy.width === shown.width && copy.height === shown.height ? largestDifference(shown, copy) : 255;
    })
    .toBe(0);
}

/** The picture of a page that has lost its context, without lamp and focus ring. */
async function readLastPicture(page: Page): Promise<PNG> {
  const above = page.locator('.lamp, #drawing, #status');
  const show = (visibility: string) =>
    above.evaluateAll((elements, value) => {
      for (const element of elements) (element as HTMLElement).style.visibility = value;
    }, visibility);
  await show('hidden');
  const picture = await page.locator('#viewport').screenshot();
  await show('');
  return PNG.sync.read(picture);
}

test('missing files at the start are reported, and later successes do not hide the report', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const status = page.locator('#status');
  await page.route(/dragon_vrip_res4\.ply.*\.gz$/, (route) => route.fulfill({ status: 404 }));
  await page.goto('./#model=dragon4&mapSize=64&mapTones=4&mapSeed=1.5');
  await expect(page.locator('html')).toHaveAttribute('data-state', 'failed');
  await expect(status).toHaveText('The dragon could not be fetched: the server answered 404.');
  expect(pageProblems.splice(0).every((problem) => problem.includes('404'))).toBe(true);
  // A change of the look neither causes nor mends the failure.
  await page.getByRole('button', { name: 'Settings' }).click();
  await page.getByRole('button', { name: 'Stipple' }).click();
  await idle(page);
  await expect(status).toHaveText('The dragon could not be fetched: the server answered 404.');

  // The script of the worker that reads files: small ones are read without.
  await page.route('**/model.worker*', (route) => route.fulfill({ contentType: 'text/html', body: '<html></html>' }));
  await page.getByRole('combobox', { name: 'Model', exact: true }).selectOption('Suzanne');
  await expect(page.locator('#model-name')).toHaveText('Suzanne');
  await ready(page);
  await expect(status).toHaveText('');
  expect(pageProblems.splice(0).filter((problem) => !/404|model\.worker/.test(problem))).toEqual([]);
});

test('a model is drawn although the worker that prepares it ends silently', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  await openPlayground(page, SMALL);
  const drawing = await readDrawing(page);
  await page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    let isKilled = false;
    Worker.prototype.postMessage = function (this: Worker, ...args: unknown[]) {
      postMessage.apply(this, args as [unknown]);
      if (isKilled || (args[0] as { task?: string }).task === undefined) return;
      isKilled = true;
      this.terminate();
    };
  });
  await page.reload();
  await ready(page);
  expect(changedShare(drawing, await readDrawing(page))).toBe(0);
  expect(pageProblems.splice(0)).toEqual([
    expect.stringContaining('the worker died (it has ended). Its tasks start over in a new worker.'),
  ]);
});

test('a browser without WebGL 2 gets a message', async ({ page }) => {
  await page.addInitScript(() => {
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: [string]) {
      return args[0] === 'webgl2' ? null : getContext.apply(this, args);
    } as typeof getContext;
  });
  await page.goto('./');
  await expect(page.locator('#status')).toHaveText(/^This page needs WebGL 2/);
});
