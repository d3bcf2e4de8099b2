import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
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

test('changes are hatched again, and nothing is drawn unhatched in between', { tag: '@all' }, async ({ page }) => {
  const hatched = async (change: Shown) => {
    const before = await page.evaluate((c) => {
      const { hatchings } = window.page;
      window.page.show(c);
      return hatchings;
    }, change);
    await page.waitForFunction((n) => window.page.hatchings > n, before);
    return page.evaluate(() => window.page.meshes());
  };
  expect((await hatched({ shape: 'sphere' })).first.triangles).toBe(16 * 12 * 2 - 2 * 16);
  expect((await hatched({ color: '#ff0000' })).first.color).toBe('ff0000');
  const both = await hatched({ second: true, loaded: true });
  expect(Object.values(both).map(({ material }) => material)).toEqual(Array(3).fill('HatchingMaterial'));
  const woodcut = await hatched({
    options: { preset: 'woodcut', tonalArtMap: { size: 64, tones: 4, style: 'woodcut' } },
  });
  expect(Object.values(woodcut).map(({ ink }) => ink)).toEqual(Array(3).fill('120e0a'));
  const fewer = await hatched({ second: false, loaded: false });
  expect(Object.keys(fewer)).toEqual(['first']);
  await page.evaluate(() => window.page.show({ late: true }));
  await page.evaluate(() => window.page.arrive());
  await expect.poll(() => page.evaluate(() => window.page.meshes().late?.material)).toBe('HatchingMaterial');
  expect(await page.evaluate(() => window.page.flashes)).toBe(0);
  expect(await page.evaluate(() => window.page.errors)).toEqual([]);
});

test('what cannot be hatched is skipped; an error shows the scene as it is', { tag: '@all' }, async ({ page }) => {
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
  const toggle = async (times: number) => {
    const memory = await page.evaluate(async (count) => {
      const frame = () => new Promise((go) => requestAnimationFrame(go));
      for (let i = 0; i < count; i++) {
        const { hatchings } = window.page;
        window.page.show({ hatched: true, loaded: true });
        // Four of five are removed before they are hatched.
        for (let n = 0; n < 2 || (i % 5 === 0 && window.page.hatchings === hatchings); n++) await frame();
        if (i % 5 === 0) window.page.pixels();
        window.page.show({ hatched: false });
        await frame();
      }
      for (let i = 0; i < 3; i++) await frame();
      window.page.pixels();
      return { ...window.page.memory(), meshes: Object.keys(window.page.meshes()).length };
    }, times);
    return { ...memory, workers: page.workers().length };
  };
  await page.evaluate(() => window.page.show({ hatched: false, options: { preset: 'technical' } }));
  const { workers: firstWorkers, ...firstOthers } = await toggle(1);
  expect(firstOthers).toMatchObject({ geometries: 0, textures: 0, meshes: 0 });
  for (let i = 0; i < 4; i++) {
    const { workers, ...others } = await toggle(10);
    expect(others, `after ${10 * (i + 1)}`).toEqual(firstOthers);
    // The first time the map is drawn beside the geometry; later it is there already.
    expect(workers).toBeLessThanOrEqual(firstWorkers);
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

test('the parts by hand: map, geometry, material and lines; what is taken away is at its default again', {
  tag: '@all',
}, async ({ page }) => {
  await page.evaluate(() => window.page.show({ hatched: false, byHand: true, ink: '#aa0000', outlineWidth: 5 }));
  await page.waitForFunction(() => window.page.meshes()['by hand']);
  const parts = () =>
    page.evaluate(() => {
      const mesh = window.page.state.scene.getObjectByName('by hand') as import('three').Mesh;
      const material = mesh.material as unknown as import('three-hatching').HatchingMaterial;
      const [lines] = mesh.children as import('three-hatching').HatchingOutlines[];
      window.page.pixels();
      return {
        ink: material.ink.getHexString(),
        offset: material.strokeOffset.x,
        map: (material.tonalArtMap as import('three-hatching').TonalArtMap).size,
        outlineWidth: lines.material.outlineWidth,
        wobble: lines.material.wobble,
      };
    });
  expect(await parts()).toEqual({ ink: 'aa0000', offset: 0.5, map: 64, outlineWidth: 5, wobble: 1 });
  await page.evaluate(() => window.page.show({ ink: undefined, outlineWidth: undefined }));
  await expect.poll(parts).toEqual({ ink: '000000', offset: 0.5, map: 64, outlineWidth: 1.8, wobble: 1 });
  const memory = await page.evaluate(async () => {
    window.page.show({ byHand: false });
    for (let i = 0; i < 3; i++) await new Promise((go) => requestAnimationFrame(go));
    window.page.pixels();
    return window.page.memory();
  });
  expect(memory).toMatchObject({ geometries: 0, textures: 0 });
});

test('in a canvas with a tone mapping a material that asks for it is advised against, once', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  await page.evaluate(() => window.page.show({ flat: false }));
  const before = await page.evaluate(() => window.page.hatchings);
  await page.waitForFunction((n) => window.page.hatchings > n, before);
  for (const preset of ['engraving', 'technical'] as const) {
    const shown = await page.evaluate(() => window.page.hatchings);
    await page.evaluate((options) => window.page.show({ options }), {
      preset,
      material: { toneMapped: true },
    });
    await page.waitForFunction((n) => window.page.hatchings > n, shown);
  }
  // The checks are loaded with the first frame.
  await expect.poll(() => pageProblems.length).toBeGreaterThan(0);
  expect(pageProblems).toEqual([
    expect.stringMatching(/console warning: HatchingMaterial: the Mesh .* tone mapping .* <Canvas flat>/),
  ]);
  pageProblems.length = 0;
});
