import type { Page } from '@playwright/test';
import { countObjects, type LiveObjects, liveObjects } from '../../tools/browser/liveObjects.js';
import { drop, enterLink, openPlayground, ready, savePicture } from '../../tools/browser/playground.js';
import { columnGlb } from '../../tools/modelFiles/columnModel.js';
import { file, octahedronPly } from '../../tools/modelFiles/modelFiles.js';
import { expect, test } from '../browser/test.js';

declare global {
  interface Window {
    __kept?: Element[];
  }
}

test.use({ viewport: { width: 320, height: 260 }, contextOptions: { reducedMotion: 'reduce' } });

/**
 * Rounds in which everything must have been given back once. What leaks grows in each of them; what is only kept for later, such as a
 * texture of a kept map that is first drawn with when a frame comes between two links, grows in the first ones.
 */
const ROUNDS = 3;
/** Small pictures and maps, so that rounds are short. */
const SMALL = 'mapSize=64&mapTones=4';
/** Objects whose number varies: idle workers end by themselves, downloads keep their URL for a while. */
const SLACK: Record<string, number> = { Worker: 1, URL: 1, listeners: 4, nodes: 20, kilobytes: 8 };

const idle = (page: Page) => page.waitForFunction(() => window.__playground!.isIdle);

/** Follows a link in the open page. */
async function follow(page: Page, hash: string): Promise<void> {
  await enterLink(page, `${SMALL}&${hash}`);
  await idle(page);
}

/** Keeps the controls of motion from being freed, as browsers do with some that were taken out of a page. */
const keepControls = (page: Page) =>
  page.evaluate(() => {
    window.__kept ??= [];
    window.__kept.push(...document.querySelectorAll('#motion :not(option)'));
  });

/** Actions that allocate: models with and without a skin, broken files, techniques, comparisons, maps, shadows, pictures. */
async function oneRound(page: Page): Promise<void> {
  for (const name of ['a.glb', 'b.glb']) {
    await drop(page, [file(name, columnGlb())]);
    await expect(page.locator('#model-name')).toHaveText(name);
    await idle(page);
    await keepControls(page);
  }
  await drop(page, [file('broken.ply', octahedronPly.slice(0, 60))]);
  await expect(page.locator('#status')).toHaveText(/^broken\.ply/);
  await drop(page, [file('octahedron.ply', octahedronPly)]);
  await expect(page.locator('#model-name')).toHaveText('octahedron.ply');
  await follow(page, 'model=cube&occlusion=50');
  await follow(page, 'model=cube&technique=adjacency&compare=triangle&mapSeed=2');
  await follow(page, 'model=cube&technique=engraving&shadows=on&ground=floor');
  await savePicture(page);
  await follow(page, 'model=cube');
}

test('objects made for models, maps, techniques, comparisons and shadows are freed', { tag: '@all' }, async ({
  page,
}) => {
  await countObjects(page);
  await openPlayground(page, `${SMALL}&model=cube`);
  // The first round fills what is kept for later.
  await oneRound(page);
  // A sketch comes first, and the rest of a drawing after it.
  await ready(page);
  let before = await liveObjects(page);
  expect(before.Texture).toBeGreaterThan(3);
  expect(before.kilobytes).toBeGreaterThan(50);
  let grown: string[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    await oneRound(page);
    await ready(page);
    grown = await growthSince(page, before);
    if (grown.length === 0) return;
    before = await liveObjects(page);
  }
  expect(grown).toEqual([]);
});

/** The objects that have become more, after late releases. */
async function growthSince(page: Page, before: LiveObjects): Promise<string[]> {
  let grown: string[] = [];
  for (let look = 0; look < 10; look++) {
    grown = Object.entries(await liveObjects(page))
      .filter(([kind, count]) => count > before[kind] + (SLACK[kind] ?? 0))
      .map(([kind, count]) => `${kind}: ${before[kind]}, then ${count}`);
    if (grown.length === 0) break;
    await idle(page);
  }
  return grown;
}
