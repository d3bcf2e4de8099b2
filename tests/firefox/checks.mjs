import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PNG } from 'pngjs';

const TIMEOUT_MILLISECONDS = 60_000;
/** A small map, because its size takes time and proves nothing. */
const SMALL = 'mapSize=64&mapTones=4';

/** Checks that run one after another on one page, by title. */
export const checks = {
  'the page opens and draws': async ({ page, address }) => {
    await page.goto(`${address}#${SMALL}&model=sphere`);
    const picture = await drawing(page);
    assert.ok(coloursOf(picture) > 20, 'the drawing has many tones');
    assert.equal(await textOf(page, '#status'), '');
    const drawn = await page.evaluate(() => {
      const gl = document.querySelector('#drawing').getContext('webgl2');
      return { error: gl.getError(), isLost: gl.isContextLost() };
    });
    assert.deepEqual(drawn, { error: 0, isLost: false });
  },

  'the light is dragged with the mouse': async ({ page }) => {
    const before = await drawing(page);
    const { x, y, width, height } = await (await page.$('#lamp')).boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 160, y + height / 2 + 90, { steps: 6 });
    await page.mouse.up();
    assert.ok(changedShare(before, await drawing(page)) > 0.03, 'the picture changes');
  },

  'every technique draws': async ({ page }) => {
    const pictures = [];
    for (const technique of ['hatching', 'engraving', 'adjacency', 'triangle']) {
      await page.evaluate((link) => {
        location.hash = link;
      }, `${SMALL}&model=sphere&technique=${technique}`);
      pictures.push(await drawing(page));
      assert.ok(coloursOf(pictures.at(-1)) > 20, technique);
    }
    for (const [i, picture] of pictures.slice(1).entries()) assert.ok(changedShare(pictures[i], picture) > 0.02);
  },

  'a preset is chosen': async ({ page }) => {
    const before = await drawing(page);
    const [, other] = await page.$$('#presets button');
    await other.click();
    assert.ok(changedShare(before, await drawing(page)) > 0.02, 'the picture changes');
  },

  'files are read, good and damaged': async ({ page, modules, files }) => {
    const { file, octahedronDracoGlb, octahedronGlb, octahedronMeshoptGlb, octahedronPly } =
      await modules.ssrLoadModule('/tools/modelFiles/modelFiles.ts');
    const { fbx } = await modules.ssrLoadModule('/tools/modelFiles/sceneWriters.ts');
    const models = [
      file('plain.glb', octahedronGlb()),
      file('draco.glb', await octahedronDracoGlb()),
      file('meshopt.glb', await octahedronMeshoptGlb()),
      file('text.ply', octahedronPly),
      file('box.fbx', fbx()),
    ];
    const before = await drawing(page);
    for (const { name, buffer } of models) {
      await choose(page, files, name, buffer);
      await page.waitForFunction((title) => document.querySelector('#model-name').textContent === title, {}, name);
    }
    assert.ok(changedShare(before, await drawing(page)) > 0.02, 'the picture changes');
    await choose(page, files, 'cut.glb', octahedronGlb().subarray(0, 200));
    await page.waitForFunction(() => /^cut\.glb is cut short/.test(document.querySelector('#status').textContent));
    assert.equal(await textOf(page, '#model-name'), 'box.fbx');
  },

  'a model with bones and a picture moves': async ({ page, modules, files }) => {
    const { columnGlb } = await modules.ssrLoadModule('/tools/modelFiles/columnModel.ts');
    await choose(page, files, 'column.glb', columnGlb());
    await page.waitForFunction(() => document.querySelector('#model-name').textContent === 'column.glb');
    const frames = () => page.evaluate(() => window.__playground.framesDrawn);
    const seen = await frames();
    await page.waitForFunction((before) => window.__playground.framesDrawn > before + 3, {}, seen);
    await page.evaluate(() => {
      [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Pause').click();
    });
    assert.ok(coloursOf(await drawing(page)) > 20);
  },

  'the picture is saved': async ({ page, downloads }) => {
    await page.click('#save-png');
    const name = await until(() => readdirSync(downloads).find((one) => one.endsWith('.png')));
    const saved = await until(() => readPng(join(downloads, name)));
    const shown = await drawing(page);
    assert.deepEqual([saved.width >= shown.width, coloursOf(saved) > 20], [true, true]);
  },

  'the figures are drawn': async ({ page, address }) => {
    await page.goto(`${address}figures/`);
    await page.waitForFunction(() => window.__figures?.isIdle, { timeout: TIMEOUT_MILLISECONDS });
    const [canvas] = await page.$$('canvas');
    assert.ok(coloursOf(PNG.sync.read(Buffer.from(await canvas.screenshot()))) > 20);
  },
};

const textOf = (page, selector) => page.$eval(selector, ({ textContent }) => textContent);

/** Picks a file, as the button does. */
async function choose(page, folder, name, content) {
  const path = join(folder, name);
  writeFileSync(path, content);
  await (await page.$('#file-input')).uploadFile(path);
}

/** Waits until the page is idle. @returns a picture of the drawing, without what lies over it */
async function drawing(page) {
  // Some actions on the page begin in a later task, or with the next refresh of the screen.
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  await page.waitForFunction(() => document.documentElement.dataset.state === 'ready' && window.__playground.isIdle, {
    timeout: TIMEOUT_MILLISECONDS,
  });
  const show = (visibility) =>
    page.$$eval(
      '#viewport > :not(canvas)',
      (overlays, value) => {
        for (const { style } of overlays) style.visibility = value;
      },
      visibility,
    );
  await show('hidden');
  const picture = PNG.sync.read(Buffer.from(await (await page.$('#viewport')).screenshot()));
  await show('');
  return picture;
}

function coloursOf({ data }) {
  const colours = new Set();
  for (let i = 0; i < data.length; i += 4) colours.add(data.readUInt32LE(i));
  return colours.size;
}

/** The share of pixels that differ by more than can be seen. */
function changedShare(one, other) {
  let changed = 0;
  for (let i = 0; i < one.data.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs(one.data[i + k] - other.data[i + k]) > 25)) changed++;
  }
  return changed / (one.data.length / 4);
}

/** The first truthy result of `look`, which is called until there is one. */
async function until(look) {
  for (let waited = 0; waited < TIMEOUT_MILLISECONDS; waited += 100) {
    const found = look();
    if (found) return found;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`Nothing came of ${look}.`);
}

/** A PNG file; undefined while it is not whole. */
function readPng(path) {
  try {
    return PNG.sync.read(readFileSync(path));
  } catch {
    return undefined;
  }
}
