import type { Page } from '@playwright/test';
import { drop, idle, openPlayground, readDrawing } from '../../tools/browser/playground.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import {
  file,
  octahedronAsciiStl,
  octahedronBin,
  octahedronBinaryStl,
  octahedronDracoGlb,
  octahedronGltf,
  octahedronMeshoptGlb,
  octahedronMtl,
  octahedronObj,
  octahedronPly,
  skyPng,
  squareMtl,
  squareObj,
  type TestFile,
} from '../../tools/modelFiles/modelFiles.js';
import { dae, fbx, tds, threeMf, usda, wrl, zip } from '../../tools/modelFiles/sceneWriters.js';
import { expect, test } from '../browser/test.js';
import { changedShare } from './pictures.js';

test.use({ viewport: { width: 400, height: 300 }, contextOptions: { reducedMotion: 'reduce' } });

/** Puts the page under a Content-Security-Policy, beside those that it has, from its next loading on. */
async function forbid(page: Page, policy: string): Promise<void> {
  await page.goto('about:blank');
  await page.addInitScript((content) => {
    new MutationObserver((_, observer) => {
      if (!document.head) return;
      observer.disconnect();
      const meta = document.createElement('meta');
      meta.httpEquiv = 'Content-Security-Policy';
      meta.content = content;
      document.head.prepend(meta);
    }).observe(document, { childList: true, subtree: true });
  }, policy);
}

/** The expected messages of browser and library about the policy. */
const ABOUT_THE_POLICY = /Content[ -]Security[ -]Policy/i;

/** Drops models under a policy, each of which needs something that policies forbid. */
async function expectModelsDrawn(page: Page, pageProblems: string[], policy: string): Promise<void> {
  const name = page.locator('#model-name');
  await forbid(page, policy);
  await openPlayground(page, 'model=cube&mapSize=64&mapTones=4');
  const before = await readDrawing(page);
  // A file with its buffer in a data: URI.
  const uri = `data:application/octet-stream;base64,${octahedronBin().toString('base64')}`;
  await drop(page, [file('inside.gltf', octahedronGltf(uri))]);
  await expect(name).toHaveText('inside.gltf');
  // A file that needs a fetched decoder.
  await drop(page, [file('draco.glb', await octahedronDracoGlb())]);
  await expect(name).toHaveText('draco.glb');
  // A file with an embedded picture.
  await drop(page, [file('column.glb', columnGlb())]);
  await expect(name).toHaveText('column.glb');
  expect(changedShare(before, await readDrawing(page))).toBeGreaterThan(0.05);
  await expect(page.locator('#status')).toHaveText('');
  expect(pageProblems.filter((problem) => !ABOUT_THE_POLICY.test(problem))).toEqual([]);
  pageProblems.splice(0);
  // The policy holds.
  expect(await page.evaluate(() => fetch('data:,x').then(String, () => 'forbidden'))).toBe('forbidden');
  expect(pageProblems.splice(0).length).toBeGreaterThan(0);
}

test('files are read and drawn where a page may use neither blob: nor data:', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  await expectModelsDrawn(page, pageProblems, "worker-src 'self'; connect-src 'self'; img-src 'self'");
});

test('files are read and drawn where a page may have no workers, nor WebAssembly', { tag: '@all' }, async ({
  page,
  pageProblems,
}) => {
  const name = page.locator('#model-name');
  const status = page.locator('#status');
  await expectModelsDrawn(page, pageProblems, "worker-src 'none'; connect-src 'self'; img-src 'self'");
  // Without workers all of them are read on the main thread.
  const formats: TestFile[][] = [
    [file('octahedron.obj', octahedronObj), file('octahedron.mtl', octahedronMtl)],
    [file('square.obj', squareObj), file('square.mtl', squareMtl), file('sky.png', skyPng())],
    [file('moving.fbx', fbx(7300, true))],
    [file('box.dae', dae())],
    [file('box.3ds', Buffer.from(tds()))],
    [file('box.3mf', Buffer.from(threeMf()))],
    [file('box.usda', usda())],
    [file('box.usdz', Buffer.from(zip({ 'box.usda': usda() }, 0)))],
    [file('box.wrl', wrl())],
    [file('octahedron.ply', octahedronPly)],
    [file('ascii.stl', octahedronAsciiStl)],
    [file('binary.stl', octahedronBinaryStl())],
    [file('meshopt.glb', await octahedronMeshoptGlb())],
  ];
  for (const files of formats) {
    await drop(page, files);
    await idle(page);
    await expect(status).toHaveText('');
    await expect(name).toHaveText(files[0].name);
  }
  // Nor may it use WebAssembly, which unpacks Draco faster.
  await forbid(page, "worker-src 'none'; script-src 'self'");
  await openPlayground(page, 'model=suzanne&mapSize=64&mapTones=4');
  await expect(name).toHaveText('Suzanne');
  await expect(status).toHaveText('');
  expect(await page.evaluate(() => WebAssembly.compile(new Uint8Array()).catch(String))).toMatch(ABOUT_THE_POLICY);
  expect(pageProblems.filter((problem) => !ABOUT_THE_POLICY.test(problem))).toEqual([]);
  pageProblems.splice(0);
});
