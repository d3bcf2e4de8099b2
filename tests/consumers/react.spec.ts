import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect, test } from '../browser/test.js';
import { projectFolder } from './packedLibrary.js';
import { type ReactServer, startReactServer } from './reactServer.js';

/** The settings of the page. */
type Shown = Record<string, unknown>;

/** A React app in StrictMode on a development server with hot reload, with the packed library. */
let server: ReactServer;

test.beforeAll(async () => {
  server = await startReactServer('react.html');
});

test.afterAll(() => server.close());

test.beforeEach(async ({ page }) => {
  await page.goto(`${server.address}react.html`);
  await page.waitForFunction(() => window.page?.hatchings > 0);
});

/** Objects left on an empty page: React frees them when it is idle. */
const NOTHING = { geometries: 0, textures: 0, programs: 0, meshes: 0 };

const heldBy = (page: Page) =>
  page.evaluate(() => {
    window.page.pixels();
    return { ...window.page.memory(), meshes: Object.keys(window.page.meshes()).length };
  });

test('StrictMode mounts, unmounts and mounts: the children are hatched', { tag: '@all' }, async ({ page }) => {
  expect(await page.evaluate(() => window.page.meshes())).toEqual({
    first: { material: 'HatchingMaterial', ink: '1c1a17', color: 'ffffff', triangles: 12 },
  });
  const red = await page.evaluate(() => window.page.pixels());
  const part = (from: number, to: number) => red.filter((value) => value >= from && value < to).length / red.length;
  expect(part(0, 64), 'ink').toBeGreaterThan(0.02);
  // The paper of the preset, by the number: no tone mapping has changed it.
  expect(part(0xf7, 0xf8), 'paper').toBeGreaterThan(0.02);
  const progress = await page.evaluate(() => window.page.progress);
  expect(progress.at(-1)).toBe(1);
});

test('changes are hatched again, and no frame in between is unhatched', { tag: '@all' }, async ({ page }) => {
  const show = (change: Shown) => page.evaluate((c) => window.page.show(c), change);
  const meshes = () => page.evaluate(() => window.page.meshes());
  await show({ shape: 'sphere' });
  await expect.poll(async () => (await meshes()).first.triangles).toBe(16 * 12 * 2 - 2 * 16);
  await show({ color: '#ff0000' });
  await expect
    .poll(async () => (await meshes()).first)
    .toMatchObject({ material: 'HatchingMaterial', color: 'ff0000' });
  await show({ second: true, loaded: true });
  const materials = async () => Object.values(await meshes()).map(({ material }) => material);
  await expect.poll(materials).toEqual(Array(3).fill('HatchingMaterial'));
  await show({ options: { preset: 'woodcut', tonalArtMap: { size: 64, tones: 4, style: 'woodcut' } } });
  await expect.poll(async () => Object.values(await meshes()).map(({ ink }) => ink)).toEqual(Array(3).fill('120e0a'));
  await show({ second: false, loaded: false });
  await expect.poll(async () => Object.keys(await meshes())).toEqual(['first']);
  await show({ late: true });
  await page.waitForFunction(() => window.page.isLateAwaited);
  await page.evaluate(() => window.page.arrive());
  await expect.poll(() => page.evaluate(() => window.page.meshes().late?.material)).toBe('HatchingMaterial');
  expect(await page.evaluate(() => window.page.flashes)).toBe(0);
  expect(await page.evaluate(() => window.page.errors)).toEqual([]);
});

test('objects that cannot be hatched are skipped; an error leaves the scene unhatched', { tag: '@all' }, async ({
  page,
}) => {
  await page.evaluate(() => window.page.show({ broken: true }));
  await page.waitForFunction(() => window.page.last!.skipped.length > 0);
  expect(await page.evaluate(() => window.page.last!.skipped.map(({ mesh }) => mesh.name))).toEqual(['broken']);
  await page.evaluate(() => window.page.show({ broken: false, hatched: false }));
  await page.waitForFunction(() => !window.page.meshes().first);
  await page.evaluate(() => window.page.show({ hatched: true, options: { preset: 'pen', creaseAngle: 90 } }));
  await page.waitForFunction(() => window.page.errors.length > 0);
  expect(await page.evaluate(() => window.page.errors)).toEqual([expect.stringContaining('creaseAngle is 90')]);
  expect((await page.evaluate(() => window.page.meshes())).first.material).toBe('MeshStandardMaterial');
});

test('40 mounts and unmounts leave nothing behind: no textures, geometries, programs, workers', {
  tag: '@all',
}, async ({ page }) => {
  // Programs are compiled eight times.
  test.slow();
  const toggle = (times: number) =>
    page.evaluate(async (count) => {
      const until = async (isSo: () => boolean) => {
        while (!isSo()) await new Promise((go) => requestAnimationFrame(go));
      };
      const isMounted = () => Object.keys(window.page.meshes()).length > 0;
      for (let i = 0; i < count; i++) {
        const { hatchings } = window.page;
        window.page.show({ hatched: true, loaded: true });
        await until(isMounted);
        // Four of five are removed before they are hatched.
        if (i % 5 === 0) {
          await until(() => window.page.hatchings > hatchings);
          window.page.pixels();
        }
        window.page.show({ hatched: false });
        await until(() => !isMounted());
      }
    }, times);
  await page.evaluate(() => window.page.show({ hatched: false, options: { preset: 'technical' } }));
  await page.waitForFunction(() => !window.page.meshes().first);
  for (const times of [1, 10, 10, 10, 10]) {
    await toggle(times);
    await expect.poll(() => heldBy(page), { message: `after ${times} more` }).toMatchObject(NOTHING);
    // The size of the pool, whatever the number of scenes.
    const cores = await page.evaluate(() => navigator.hardwareConcurrency);
    expect(page.workers().length).toBeLessThanOrEqual(Math.min(cores, 4));
  }
});

test('hot reload: an edited component is hatched anew, and the page and what it shows stay', { tag: '@all' }, async ({
  page,
}) => {
  await page.evaluate(() => {
    Object.assign(window, { stays: true });
    window.page.show({ second: true });
  });
  await expect.poll(() => page.evaluate(() => window.page.meshes().edited?.triangles)).toBe(12);
  const file = join(projectFolder, 'ReactModel.tsx');
  const text = readFileSync(file, 'utf8');
  const triangles = () => page.evaluate(() => window.page.meshes().edited?.triangles);
  writeFileSync(file, text.replace('<boxGeometry args={[0.6, 0.6, 0.6]} />', '<sphereGeometry args={[0.4, 8, 6]} />'));
  try {
    await expect.poll(triangles).toBe(8 * 6 * 2 - 2 * 8);
  } finally {
    writeFileSync(file, text);
  }
  await expect.poll(triangles).toBe(12);
  expect(await page.evaluate(() => [Reflect.get(window, 'stays'), window.page.flashes])).toEqual([true, 0]);
  expect((await page.evaluate(() => window.page.meshes())).first.material).toBe('HatchingMaterial');
});

test('the components alone: map, geometry, material and lines; removed props return to their defaults', {
  tag: '@all',
}, async ({ page }) => {
  const look = { ink: '#aa0000', outlineWidth: 5, weights: { creases: 0.9 } };
  await page.evaluate((given) => window.page.show({ hatched: false, byHand: true, ...given }), look);
  await page.waitForFunction(() => window.page.meshes()['by hand']);
  const parts = () =>
    page.evaluate(() => {
      const mesh = window.page.state.scene.getObjectByName('by hand') as import('three').Mesh;
      const material = mesh.material as unknown as import('three-hatching').HatchingMaterial;
      const [lines] = mesh.children as import('three-hatching').HatchingOutlines[];
      window.page.pixels();
      return {
        ink: material.ink.getHexString(),
        offset: material.perTriangle.strokeOffset.x,
        map: (material.tonalArtMap as import('three-hatching').TonalArtMap).size,
        outlineWidth: lines.material.outlineWidth,
        wobble: lines.material.wobble,
        weights: [lines.material.weights.creases, lines.material.weights.shade],
      };
    });
  const always = { offset: 0.5, map: 64, wobble: 1 };
  expect(await parts()).toEqual({ ...always, ink: 'aa0000', outlineWidth: 5, weights: [0.9, 1.7] });
  await page.evaluate(() => window.page.show({ weights: { shade: 3 } }));
  await expect.poll(parts).toEqual({ ...always, ink: 'aa0000', outlineWidth: 5, weights: [0.35, 3] });
  await page.evaluate(() => window.page.show({ ink: undefined, outlineWidth: undefined, weights: undefined }));
  await expect.poll(parts).toEqual({ ...always, ink: '000000', outlineWidth: 1.8, weights: [0.35, 1.7] });
  await page.evaluate(() => window.page.show({ byHand: false }));
  await expect.poll(() => heldBy(page)).toMatchObject(NOTHING);
});

test('in a canvas with a tone mapping a material that asks for it is advised against, once', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const hatched = async (change: Shown) => {
    const before = await page.evaluate((c) => {
      const { hatchings } = window.page;
      window.page.show(c);
      return hatchings;
    }, change);
    await page.waitForFunction((n) => window.page.hatchings > n, before);
  };
  await hatched({ flat: false });
  for (const preset of ['engraving', 'technical'])
    await hatched({ options: { preset, material: { toneMapped: true } } });
  // The checks are loaded with the first frame.
  await expect.poll(() => pageProblems.length).toBeGreaterThan(0);
  expect(pageProblems).toEqual([
    expect.stringMatching(/console warning: HatchingMaterial: the Mesh .* tone mapping .* <Canvas flat>/),
  ]);
  pageProblems.length = 0;
});
