import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { serveFolders } from '../../tools/browser/serveFolders.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { expect, test } from '../browser/test.js';
import { SAMPLES } from '../unit/docs/sampleList.js';
import { installPackedLibrary, projectFolder, root } from './packedLibrary.js';
import { viteBuild } from './viteBuild.js';

/** The pictures of the samples, to be looked at. */
const pictures = join(root, 'tests/output/samplePictures');
/** A picture differs from its own background in at least so many of its pixels. */
const LEAST_DRAWN = 0.005;

/** The guides that have samples, by which these are named and numbered. */
const GUIDES = [...new Set(SAMPLES.map(({ name }) => guideOf(name)))];

let server: Awaited<ReturnType<typeof serveFolders>>;

test.beforeAll(async () => {
  server = await serveFolders({ '/': await buildSamples() });
  rmSync(pictures, { recursive: true, force: true });
  mkdirSync(pictures, { recursive: true });
});

test.afterAll(() => server.close());

for (const guide of GUIDES) {
  const title = `every sample of ${guide} draws a picture, without a word in the console`;
  test(title, { tag: '@all' }, async ({ page, pageProblems }) => {
    await answerFiles(page);
    await page.setViewportSize({ width: 240, height: 180 });
    await open(page);
    for (const { name, kind, code } of SAMPLES.filter((sample) => guideOf(sample.name) === guide)) {
      const facts = {
        html: kind === 'html' ? code : undefined,
        hasCanvas: /<Canvas|<hatched-model/.test(code),
        isLit: /new \w*Light\(/.test(code),
        lamp: lampOf(code),
      };
      const failure = await page
        .evaluate(([which, how]) => window.runSample(which, how), [name, facts] as const)
        .then(() => undefined, String);
      expect.soft(failure, name).toBeUndefined();
      if (failure !== undefined) continue;
      const path = join(pictures, `${name}.png`);
      const drawn = async (): Promise<number> => drawnShare(await page.screenshot({ path }));
      await expect.soft.poll(drawn, { message: name, intervals: [100, 250] }).toBeGreaterThan(LEAST_DRAWN);
      expect.soft(pageProblems.splice(0), name).toEqual([]);
      // The renderer would otherwise draw the scene of the next sample.
      if (/const renderer = new/.test(code)) await open(page);
    }
  });
}

async function open(page: Page): Promise<void> {
  await page.goto(`${server.url}/samples.html`);
  await page.waitForFunction(() => 'runSample' in window);
}

/** The lamp that a sample changes: one that it hatches itself, or a hatched one. */
function lampOf(code: string): 'none' | 'plain' | 'hatched' {
  if (/applyHatching\(lamp\b/.test(code)) return 'plain';
  return /\b(lamp|hatched|shade|cord)\b/.test(code) && !code.includes('const hatched =') ? 'hatched' : 'none';
}

function guideOf(sample: string): string {
  return sample.replace(/-\d+$/, '');
}

/** The share of pixels that are not of the most frequent colour. */
function drawnShare(screenshot: Buffer): number {
  const { data } = PNG.sync.read(screenshot);
  const counts = new Map<number, number>();
  for (let i = 0; i < data.length; i += 4) {
    const colour = data.readUInt32LE(i);
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  return 1 - Math.max(...counts.values()) / (data.length / 4);
}

/** Bundles all samples with the packed library, each to be loaded when it is run. Returns the folder. */
async function buildSamples(): Promise<string> {
  installPackedLibrary();
  const folder = join(projectFolder, 'samples');
  mkdirSync(folder, { recursive: true });
  for (const { name, kind, code } of SAMPLES) if (kind !== 'html') writeFileSync(join(folder, `${name}.${kind}`), code);
  return viteBuild('samples', { target: 'es2022', minify: false });
}

/** Answers for the files that samples load: models, and the images of a map, of which those in the dark have more ink. */
async function answerFiles(page: Page): Promise<void> {
  const model = columnGlb();
  await page.route(/\.glb$/, (route) => route.fulfill({ body: model }));
  await page.route(/\.png$/, (route) => {
    const name = new URL(route.request().url()).pathname.slice(1);
    const order = ['light', 'middle', 'dark'].findIndex((tone) => name.startsWith(tone));
    const tone = order >= 0 ? order + 1 : Number(/\d/.exec(name)?.[0] ?? 1);
    return route.fulfill({ body: hatchImage(tone), contentType: 'image/png' });
  });
}

/** A tile of 64 × 64 texels with as many strokes as the number of the tone asks for. */
function hatchImage(tone: number): Buffer {
  const picture = new PNG({ width: 64, height: 64 });
  for (let i = 0; i < 64 * 64; i++) {
    const row = Math.floor(i / 64);
    const isInk = row % 8 < 2 && Math.floor(row / 8) < tone;
    picture.data.set([...Array(3).fill(isInk ? 0 : 255), 255], 4 * i);
  }
  return PNG.sync.write(picture);
}
