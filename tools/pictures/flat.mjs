import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PNG } from 'pngjs';
import { sheetOf } from './sheetOf.mjs';

/** The size of each picture unless asked otherwise. */
const SIZE = '520x390';

/**
 * Writes drawings of plain faces into tests/output/flat, to be looked at: each by itself, a sheet for each scene with a row for each
 * preset, and a sheet for each preset with a row for each scene.
 *
 * @param {import('vite').ViteDevServer} server
 * @param {import('@playwright/test').Browser} browser
 * @param {string} root of the project
 * @param {string[]} presets the names of all presets
 * @param {{ scenes?: string, presets?: string, views?: string, size?: string, shadows?: boolean }} options what is drawn, as names with
 *   commas between them; all of them unless named
 */
export async function drawFlat(server, browser, root, presets, options) {
  const page = await browser.newPage();
  page.on('console', (message) => {
    if (message.type() === 'error') console.error(message.text());
  });
  await page.goto(`${server.resolvedUrls.local[0]}tools/pictures/flat.html`);
  await page.waitForFunction(() => typeof window.drawFlat === 'function');
  const known = await page.evaluate(() => ({ scenes: window.flatScenes, views: window.flatViews }));
  const scenes = chosen('scenes', options.scenes, known.scenes);
  const views = chosen('views', options.views, known.views);
  const looks = chosen('presets', options.presets, presets);
  const [width, height] = (options.size ?? SIZE).split('x').map(Number);
  const folder = join(root, 'tests/output/flat');
  mkdirSync(join(folder, 'single'), { recursive: true });

  const drawn = new Map();
  // Presets are the outer loop, since scenes share the shaders of a preset.
  for (const preset of looks) {
    for (const scene of scenes) {
      const pictures = { scene, preset, views, width, height, shadows: options.shadows === true };
      const addresses = await page.evaluate((what) => window.drawFlat(what), pictures);
      for (const [i, view] of views.entries()) {
        const content = Buffer.from(addresses[i].slice(addresses[i].indexOf(',') + 1), 'base64');
        writeFileSync(join(folder, `single/${scene}-${preset}-${view}.png`), content);
        drawn.set(`${scene} ${preset} ${view}`, PNG.sync.read(content));
      }
    }
    write(
      `preset-${preset}`,
      scenes.flatMap((scene) => views.map((view) => `${scene} ${preset} ${view}`)),
    );
  }
  for (const scene of scenes) {
    write(
      `scene-${scene}`,
      looks.flatMap((preset) => views.map((view) => `${scene} ${preset} ${view}`)),
    );
  }
  await page.close();

  function write(name, pictures) {
    const sheet = sheetOf(
      pictures.map((picture) => drawn.get(picture)),
      views.length,
    );
    writeFileSync(join(folder, `${name}.png`), PNG.sync.write(sheet));
    console.log(`flat: ${name}`);
  }
}

/** The names that are asked for, all of them if none are. */
function chosen(option, text, known) {
  const names = text === undefined ? known : text.split(',');
  const unknown = names.find((name) => !known.includes(name));
  if (unknown !== undefined) {
    throw new Error(`tools/pictures/flat.mjs: --${option} has no "${unknown}"; there are ${known.join(', ')}.`);
  }
  return names;
}
