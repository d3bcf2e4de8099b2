import type { Page } from '@playwright/test';
import type { PNG } from 'pngjs';
import { launchOptions } from '../../tools/browser/launchOptions.mjs';
import {
  drop,
  enterLink,
  fetchedAhead,
  idle,
  openPlayground,
  readDrawing,
  savePicture,
  writtenHash,
} from '../../tools/browser/playground.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { tetrahedron } from '../../tools/modelFiles/GltfBuilder.js';
import { file } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';
import { changedShare, meanInk } from './pictures.js';

test.use({ viewport: { width: 860, height: 440 }, launchOptions: await launchOptions(undefined, { webgpu: 'shown' }) });

const LINES = 'model=knot&technique=engraving&shadows=on&ground=floor';

declare global {
  interface Window {
    /**
     * Objects on the graphics card, as counted by the tests, and the number of programs of WebGPU that are being built for a frame
     * that waits for them.
     */
    __held?: { programs: number; textures: number; devices: number; awaited: number; lose: () => void };
  }
}

/** Runs in the page before its own scripts: counts what it holds, as `__held` says, and can say that a device is lost. */
function count(): void {
  const held = { programs: 0, textures: 0, devices: 0, awaited: 0, lose: () => {} };
  window.__held = held;
  const { prototype } = WebGL2RenderingContext;
  for (const [what, counter] of [
    ['Program', 'programs'],
    ['Texture', 'textures'],
  ] as const) {
    const [create, remove] = [prototype[`create${what}`], prototype[`delete${what}`]];
    Object.assign(prototype, {
      [`create${what}`](this: WebGL2RenderingContext) {
        held[counter]++;
        return create.call(this);
      },
      [`delete${what}`](this: WebGL2RenderingContext, object: WebGLProgram | WebGLTexture | null) {
        if (object) held[counter]--;
        remove.call(this, object);
      },
    });
  }
  if (!('gpu' in navigator)) return;
  const { requestDevice } = GPUAdapter.prototype;
  GPUAdapter.prototype.requestDevice = async function (...args) {
    const device = await requestDevice.apply(this, args);
    held.devices++;
    void device.lost.then(() => held.devices--);
    const isLost = new Promise<object>((resolve) => {
      held.lose = () => resolve({ reason: 'unknown', message: 'for a test' });
    });
    Object.defineProperty(device, 'lost', { value: isLost });
    return device;
  };
  const { createRenderPipeline } = GPUDevice.prototype;
  GPUDevice.prototype.createRenderPipeline = function (descriptor) {
    held.awaited++;
    setTimeout(() => this.queue.onSubmittedWorkDone().finally(() => held.awaited--));
    return createRenderPipeline.call(this, descriptor);
  };
}

const held = (page: Page) =>
  page.evaluate(() => {
    const { programs, textures, devices, awaited } = window.__held!;
    return { programs, textures, devices, awaited };
  });

/** three.js never gives back the program of its shadow maps. */
async function expectWebGPUAlone(page: Page): Promise<void> {
  const { programs, devices } = await held(page);
  expect(programs).toBeLessThan(2);
  expect(devices).toBe(1);
}

const renderers = (page: Page) => page.getByLabel('Renderer');
const nodeScreen = (page: Page) => page.locator('.node-screen');
const note = (page: Page) => page.locator('.lil-controller', { hasText: 'Renderer' }).locator('.note');

/** The column, bent by its bones. */
function bentGlb(): Buffer {
  const bend = { rotation: [0, 0, Math.sin(0.4), Math.cos(0.4)] };
  return columnGlb({ changes: () => ({ nodes: [{ mesh: 0, skin: 0 }, bend, { children: [1] }], animations: [] }) });
}

/** A tetrahedron whose places are integers of 16 bits, with a gap after each. */
function packedGlb(): Buffer {
  const builder = tetrahedron();
  const { json } = builder;
  const corners = Uint16Array.of(20, 20, 20, 0, 0, 0, 20, 0, 0, 20, 0, 0, 20, 0, 0, 0);
  json.meshes[0].primitives[0].attributes.POSITION = builder.accessor(corners, 'VEC3', { count: 4 });
  json.bufferViews.at(-1).byteStride = 8;
  json.extensionsUsed = json.extensionsRequired = ['KHR_mesh_quantization'];
  return Buffer.from(builder.glb());
}

/** The copy that covers the drawing while a picture is saved: its size, and whether something is on it. */
const firstCover = (page: Page) =>
  page.evaluate(
    () =>
      new Promise<object>((resolve) => {
        new MutationObserver(() => {
          const copy = document.querySelector<HTMLCanvasElement>('.cover');
          if (!copy) return;
          const { width, height } = copy;
          resolve({ width, height, alpha: copy.getContext('2d')!.getImageData(0, 0, 1, 1).data[3] });
        }).observe(document.querySelector('#viewport')!, { childList: true });
      }),
  );

async function openMore(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'More', exact: true }).click();
}

/**
 * The share of pixels that differ by more than a little: the edges of strokes may be smoothed another way. A screenshot may be a pixel larger than the
 * canvas, whose width follows from that of letters.
 */
function unlikeShare(a: PNG, b: PNG): number {
  const [width, height] = [Math.min(a.width, b.width), Math.min(a.height, b.height)];
  expect(Math.max(a.width, b.width) - width + Math.max(a.height, b.height) - height).toBeLessThanOrEqual(2);
  let unlike = 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      if (Math.abs(a.data[4 * (y * a.width + x)] - b.data[4 * (y * b.width + x)]) > 32) unlike++;
  return unlike / (width * height);
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript(count);
  await page.goto('/tests/browser/blank.html');
  const hasWebGPU = await page.evaluate(async () => (await navigator.gpu?.requestAdapter()) != null);
  test.skip(!hasWebGPU, 'This browser has no WebGPU.');
});

test('WebGPU draws the same picture when it is chosen, WebGL draws it again, and each leaves nothing behind', async ({
  page,
}) => {
  const scripts: string[] = [];
  page.on('response', async (response) => {
    if (/\.js$/.test(response.url()) && (await response.text().catch(() => '')).includes('isWebGPUBackend'))
      scripts.push(response.url());
  });
  await openPlayground(page, LINES);
  const before = await readDrawing(page);
  await fetchedAhead(page);
  expect(scripts).toEqual([]);
  // Outlines have all their textures from the second frame on.
  await page.locator('#lamp').focus();
  for (const key of ['ArrowRight', 'ArrowLeft']) await page.keyboard.press(key);
  await idle(page);
  const usual = await held(page);
  expect(usual.devices).toBe(0);
  expect(usual.programs).toBeGreaterThan(2);

  await openMore(page);
  await renderers(page).selectOption('WebGPU, experimental');
  await idle(page);
  expect((await held(page)).awaited).toBe(0);
  const onWebGPU = await readDrawing(page);
  await expect.poll(() => scripts.length).toBeGreaterThan(0);
  await expect(nodeScreen(page)).toBeVisible();
  await expect(note(page)).toHaveText('Pictures, prints, videos and vector files are drawn by WebGL.');
  expect(await writtenHash(page)).toContain('renderer=webgpu');
  await expectWebGPUAlone(page);
  expect(unlikeShare(before, onWebGPU)).toBeLessThan(0.002);

  // The light is dragged, and the picture that is saved shows it.
  await page.locator('#lamp').focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight');
  const turned = await readDrawing(page);
  expect(changedShare(onWebGPU, turned)).toBeGreaterThan(0.02);
  const cover = firstCover(page);
  const saved = await savePicture(page);
  expect(unlikeShare(turned, saved)).toBeLessThan(0.002);
  expect(await cover).toEqual({ width: saved.width, height: saved.height, alpha: 255 });
  expect(unlikeShare(turned, await readDrawing(page))).toBe(0);
  await expect(nodeScreen(page)).toBeVisible();
  await expectWebGPUAlone(page);

  await renderers(page).selectOption('WebGL');
  await idle(page);
  await expect(nodeScreen(page)).toHaveCount(0);
  expect(unlikeShare(turned, await readDrawing(page))).toBeLessThan(0.002);
  await expect.poll(async () => (await held(page)).devices).toBe(0);
  expect((await held(page)).textures).toBeLessThanOrEqual(usual.textures);
  await expect(note(page)).toBeEmpty();

  // Both choices are steps of undo.
  await page.getByRole('button', { name: 'Undo' }).click();
  await idle(page);
  await expect(nodeScreen(page)).toBeVisible();
  await expect(renderers(page)).toHaveValue('WebGPU, experimental');
});

test('WebGL draws what WebGPU cannot, and a sentence beside the choice says so', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, 'model=cube&technique=engraving&renderer=webgpu&background=on');
  await openMore(page);
  await expect(note(page)).toHaveText('WebGL draws this, because WebGPU lacks a hatched background.');
  await expect(nodeScreen(page)).toBeHidden();
  const onWebGL = await readDrawing(page);
  await enterLink(page, 'model=cube&technique=engraving&renderer=webgpu');
  await idle(page);
  await expect(nodeScreen(page)).toBeVisible();
  expect(changedShare(onWebGL, await readDrawing(page))).toBeGreaterThan(0.01);
  await enterLink(page, 'model=cube&technique=engraving&renderer=webgpu&background=on');
  await idle(page);
  await expect(nodeScreen(page)).toBeHidden();
  expect(unlikeShare(onWebGL, await readDrawing(page))).toBeLessThan(0.001);
});

for (const [what, glb] of [
  ['bones', bentGlb()],
  ['packed vertices', packedGlb()],
] as const) {
  test(`a model with ${what} is drawn by both, whichever of them has drawn it first`, { tag: '@all' }, async ({
    page,
  }) => {
    await openPlayground(page, 'model=cube&technique=engraving&shadows=on');
    await drop(page, [file('model.glb', glb)]);
    await idle(page);
    const before = await readDrawing(page);
    await openMore(page);
    await renderers(page).selectOption('WebGPU, experimental');
    await idle(page);
    await expect(nodeScreen(page)).toBeVisible();
    expect(unlikeShare(before, await readDrawing(page))).toBeLessThan(0.002);
    await drop(page, [file('again.glb', glb)]);
    await idle(page);
    await expect(nodeScreen(page)).toBeVisible();
    expect(unlikeShare(before, await readDrawing(page))).toBeLessThan(0.002);
    await renderers(page).selectOption('WebGL');
    await idle(page);
    await expect(nodeScreen(page)).toHaveCount(0);
    expect(unlikeShare(before, await readDrawing(page))).toBeLessThan(0.002);
  });
}

test('WebGL draws on when a frame of WebGPU fails', { tag: '@all' }, async ({ page, pageProblems }) => {
  await openPlayground(page, 'model=cube&technique=engraving&renderer=webgpu');
  await expect(nodeScreen(page)).toBeVisible();
  const before = await readDrawing(page);
  await page.evaluate(() => {
    GPUQueue.prototype.submit = () => {
      throw new Error('for a test');
    };
  });
  await page.locator('#lamp').focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.locator('#status')).toHaveText('The graphics card has let go of WebGPU; WebGL draws on.');
  await idle(page);
  await expect(nodeScreen(page)).toHaveCount(0);
  expect(changedShare(before, await readDrawing(page))).toBeGreaterThan(0.001);
  expect(pageProblems.splice(0)).toEqual([expect.stringContaining('for a test')]);
});

test('WebGL draws on when WebGPU is lost, and can be left again for it', { tag: '@all' }, async ({ page }) => {
  await openPlayground(page, 'model=cube&technique=engraving&renderer=webgpu');
  await expect(nodeScreen(page)).toBeVisible();
  const before = await readDrawing(page);
  await page.evaluate(() => window.__held!.lose());
  await expect(page.locator('#status')).toHaveText('The graphics card has let go of WebGPU; WebGL draws on.');
  await idle(page);
  await expect(nodeScreen(page)).toHaveCount(0);
  expect(unlikeShare(before, await readDrawing(page))).toBeLessThan(0.02);
  expect(await writtenHash(page)).not.toContain('renderer=webgpu');
  await openMore(page);
  await renderers(page).selectOption('WebGPU, experimental');
  await idle(page);
  await expect(nodeScreen(page)).toBeVisible();
});

test('without an adapter there is no choice, and a link that asks for WebGPU is drawn by WebGL, in so many words', {
  tag: '@all',
}, async ({ page }) => {
  await page.addInitScript(() => {
    GPU.prototype.requestAdapter = async () => null;
  });
  await openPlayground(page, 'model=cube&technique=engraving');
  await openMore(page);
  await expect(renderers(page)).toBeHidden();
  await enterLink(page, 'model=cube&technique=engraving&renderer=webgpu');
  await expect(page.locator('#status')).toHaveText('This browser has no WebGPU for the page; WebGL draws on.');
  await idle(page);
  await expect(renderers(page)).toBeHidden();
  await expect(nodeScreen(page)).toHaveCount(0);
  expect(meanInk(await readDrawing(page))).toBeGreaterThan(0.01);
});
