import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { isSettled } from './isSettled.mjs';
import { toWebp } from './toWebp.mjs';

/** Sides of the sheet that is drawn, in CSS pixels, and of the picture, in its own. */
const DRAWING = { sheet: 320, side: 256 };
/** A sphere shows all tones of a preset. */
const PRESET = { sheet: 72, side: 96 };
const QUALITY = 0.8;

/**
 * Draws the small pictures of the gallery and of the presets, as the playground itself draws them, into public/gallery.
 *
 * @param {import('vite').ViteDevServer} server
 * @param {import('@playwright/test').Browser} browser
 * @param {string} root of the project
 * @param {readonly string[]} [only] the names of those that are drawn; all of them unless given
 */
export async function drawGallery(server, browser, root, only) {
  const { GALLERY } = await server.ssrLoadModule('/src/viewer/settings/gallery.ts');
  const { PRESET_NAMES } = await server.ssrLoadModule('/src/viewer/settings/presets.ts');
  const pictures = [
    ...GALLERY.map(({ name, link }) => ({ ...DRAWING, name, link })),
    ...PRESET_NAMES.map((name) => ({ ...PRESET, name: `preset-${name}`, link: `preset=${name}&model=sphere` })),
  ].filter(({ name }) => !only || only.includes(name));
  const folder = join(root, 'public/gallery');
  mkdirSync(folder, { recursive: true });
  let bytes = 0;
  for (const { name, link, sheet, side } of pictures) {
    const page = await browser.newPage({
      viewport: { width: sheet, height: sheet },
      deviceScaleFactor: 2,
      reducedMotion: 'reduce',
    });
    await page.goto(`${server.resolvedUrls.local[0]}#${link}`);
    // The sheet alone, without lamps.
    await page.evaluate(() => {
      Object.assign(document.getElementById('viewport').style, { position: 'fixed', inset: '0', zIndex: '9' });
      for (const lamp of document.querySelectorAll('.lamp')) lamp.style.display = 'none';
    });
    await page.waitForFunction(isSettled, null, { polling: 100, timeout: 120_000 });
    const picture = await page.screenshot();
    const file = await page.evaluate(toWebp, [picture.toString('base64'), { width: side, height: side }, QUALITY]);
    await page.close();
    const content = Buffer.from(file, 'base64');
    bytes += content.length;
    writeFileSync(join(folder, `${name}.webp`), content);
  }
  console.log(`gallery: ${pictures.length} pictures, ${Math.round(bytes / 1000)} kB`);
}
