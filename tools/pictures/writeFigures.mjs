/**
 * `npm run figures`: writes docs/research/figures/*.png and docs/research/figures.md from the figures page. `npm run figures -- 4 D`
 * writes only the images of some figures.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import { PNG } from 'pngjs';
import { createServer } from 'vite';
import { launchOptions } from '../browser/launchOptions.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const wanted = process.argv.slice(2);

const server = await createServer({ root, mode: 'test', logLevel: 'error', server: { host: '127.0.0.1', port: 0 } });
const { FIGURES } = await server.ssrLoadModule('/tools/figures/figures.ts');
const chosen = FIGURES.filter(({ number }) => wanted.length === 0 || wanted.includes(String(number)));
const { writePalettePng } = await server.ssrLoadModule('/tools/pictures/writePalettePng.ts');
await server.listen();
const browser = await chromium.launch(await launchOptions());
let bytes = 0;
try {
  // High enough for a whole figure, because only what is in view is drawn.
  const page = await browser.newPage({ viewport: { width: 960, height: 2400 } });
  await page.goto(`${server.resolvedUrls.local[0]}figures/`);
  // Elements that could show at the edges of a picture are hidden.
  await page.evaluate(() => {
    document.body.style.background = 'var(--paper)';
    document.querySelector('.lamp-bar').style.visibility = 'hidden';
    for (const figure of document.querySelectorAll('figure')) figure.style.boxShadow = 'none';
  });
  mkdirSync(`${root}docs/research/figures`, { recursive: true });
  for (const { number } of chosen) {
    const plates = page.locator(`#figure-${number} .plates`);
    await plates.evaluate((element) => element.scrollIntoView());
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    await page.waitForFunction(() => window.__figures?.isIdle, null, { timeout: 300_000 });
    const file = writePalettePng(PNG.sync.read(await plates.screenshot()));
    writeFileSync(`${root}docs/research/figures/figure-${number}.png`, file);
    bytes += file.length;
    console.log(`figure ${number}: ${Math.round(file.length / 1000)} kB`);
  }
} finally {
  await browser.close();
  await server.close();
}
console.log(`${Math.round(bytes / 1000)} kB together`);

if (wanted.length === 0) {
  const sectionOf = ({ number, title, inThePaper, here }) =>
    [
      `## Figure ${number}. ${title}`,
      `![Figure ${number}](figures/figure-${number}.png)`,
      ...(inThePaper ? [`*In the paper:* ${inThePaper}`, `*Here:* ${here}`] : [here]),
    ].join('\n\n');
  const again = FIGURES.filter(({ inThePaper }) => inThePaper).map(sectionOf);
  const beyond = FIGURES.filter(({ inThePaper }) => !inThePaper).map(sectionOf);
  const introduction = `# The figures of the paper

Written by \`npm run figures\` from the page \`/figures\` of the playground, where all of them are live and the light can be
turned. Figures 1 and 2 show a tonal art map: \`npx three-hatching tam\` writes out every image of one. Figures 3, 5, 6 and
7 explain the construction, which [paper.md](paper.md) goes through. Figure 15 compares frame rates: [methods.md](methods.md#cost) has
ours, and \`npm run bench\` measures yours.
`;
  const turn = `# Beyond the paper

What the paper does not have: strokes anchored to the object ([media.md](../media.md#anchored-strokes)), engraved lines ([engraving.md](../engraving.md)),
contours and creases ([outlines.md](../outlines.md)), and presets that join all of them ([presets.md](../presets.md)).`;
  writeFileSync(
    `${root}docs/research/figures.md`,
    `${[introduction.trimEnd(), ...again, turn, ...beyond].join('\n\n')}\n`,
  );
}
