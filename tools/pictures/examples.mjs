import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { toWebp } from './toWebp.mjs';

/** Width of the page, in CSS pixels, and size of the picture, in its own. */
const PAGE_WIDTH = 560;
const PICTURE = { width: 480, height: 360 };
const QUALITY = 0.8;
/** A picture is finished if it is the same after this many milliseconds. A picture of a model that moves never is. */
const REST = 700;
const MOST_LOOKS = 40;

/**
 * Draws the small pictures of the examples, as visitors see them, into their folders.
 *
 * @param {import('vite').ViteDevServer} server
 * @param {import('@playwright/test').Browser} browser
 * @param {string} root of the project
 */
export async function drawExamples(server, browser, root) {
  const { EXAMPLES } = await server.ssrLoadModule('/examples/examples.ts');
  let bytes = 0;
  for (const { folder } of EXAMPLES) {
    const page = await browser.newPage({
      viewport: { width: PAGE_WIDTH, height: 800 },
      deviceScaleFactor: 2,
      reducedMotion: 'reduce',
    });
    await page.goto(`${server.resolvedUrls.local[0]}examples/${folder}/`);
    await page.locator('.picture button').evaluateAll((buttons) => {
      for (const button of buttons) button.hidden = true;
    });
    const picture = await finished(page);
    const file = await page.evaluate(toWebp, [picture.toString('base64'), PICTURE, QUALITY]);
    await page.close();
    const content = Buffer.from(file, 'base64');
    bytes += content.length;
    writeFileSync(join(root, `examples/${folder}/picture.webp`), content);
  }
  console.log(`examples: ${EXAMPLES.length} pictures, ${Math.round(bytes / 1000)} kB`);
}

/** The picture of an example, once it has been drawn and nothing changes any more. */
async function finished(page) {
  const blank = await page.locator('.picture').screenshot();
  let last = blank;
  for (let look = 0; look < MOST_LOOKS; look++) {
    await page.waitForTimeout(REST);
    const now = await page.locator('.picture').screenshot();
    if (now.length > 2 * blank.length && now.equals(last)) return now;
    last = now;
  }
  return last;
}
