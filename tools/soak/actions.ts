import type { Page } from '@playwright/test';
import type { Random } from '../../src/viewer/settings/Random.js';
import { SETTINGS } from '../../src/viewer/settings/settings.js';
import { drop, framesDrawn, idle, savePicture } from '../browser/playground.js';
import { columnGlb } from '../modelFiles/columnModel.js';
import {
  file,
  octahedronAsciiStl,
  octahedronBinaryStl,
  octahedronGlb,
  octahedronMeshoptGlb,
  octahedronMtl,
  octahedronObj,
  octahedronPly,
  type TestFile,
} from '../modelFiles/modelFiles.js';
import { partsGlb } from '../modelFiles/partsModel.js';
import { askForModel } from './askForModel.js';
import { LACKS, visitPoor } from './poorBrowsers.js';

/** Something that a user does. */
type Action = (page: Page, random: Random) => Promise<void>;

export const MODELS = ['cube', 'sphere', 'teapot', 'bunny', 'dragon4', 'suzanne', 'fish'];
export const TECHNIQUES = Object.keys(SETTINGS.technique.choices);
/** The built-in styles, without the user's own. */
export const STYLES = Object.keys(SETTINGS.mapStyle.choices).filter((style) => style !== 'file');

const setting =
  (key: string, values: readonly string[]): Action =>
  async (page, random) => {
    await page.evaluate(
      ([name, value]) => {
        const link = new URLSearchParams(location.hash.slice(1));
        link.set(name, value);
        // Maps are drawn small: a large one takes longer and tests nothing more.
        for (const [small, size] of [
          ['mapSize', '64'],
          ['mapTones', '4'],
        ])
          link.set(small, size);
        location.hash = link.toString();
      },
      [key, random.pick(values)] as const,
    );
  };

export const GOOD: (readonly [name: string, content: () => Buffer | string | Promise<Buffer>])[] = [
  ['column.glb', columnGlb],
  ['still.glb', () => columnGlb({ still: true })],
  ['octahedron.glb', octahedronGlb],
  ['meshopt.glb', octahedronMeshoptGlb],
  ['octahedron.ply', () => octahedronPly],
  ['binary.stl', octahedronBinaryStl],
  ['ascii.stl', () => octahedronAsciiStl],
  ['octahedron.obj', () => octahedronObj],
];

/** Drops a model that moves, lets it play, and drags the slider of one of its clips. */
export async function playAnimated(page: Page, clip: number): Promise<void> {
  await drop(page, [file('column.glb', columnGlb())]);
  await idle(page);
  const clips = page.locator('#motion select');
  const choices = await clips.locator('option').count();
  await clips.evaluate((select: HTMLSelectElement, index) => {
    // The card may be closed on a small page.
    select.selectedIndex = index;
    select.dispatchEvent(new Event('change', { bubbles: true }));
  }, clip % choices);
  await page.locator('#motion').evaluate((panel) => {
    [...panel.querySelectorAll('button')].find(({ textContent }) => textContent === 'Play')?.click();
  });
  const frames = await framesDrawn(page);
  await page.waitForFunction((before) => window.__playground!.framesDrawn > before + 3, frames);
  await idle(page);
}

async function chooseFile(random: Random): Promise<TestFile> {
  const [name, content] = random.pick(GOOD);
  return file(name, await content());
}

/** Returns the file cut short, or with some bytes changed. */
function broken({ name, buffer }: TestFile, random: Random): TestFile {
  if (random.next() < 0.5) return file(`cut-${name}`, buffer.subarray(0, random.below(buffer.length)));
  const changed = Buffer.from(buffer);
  for (let i = 0; i < 8; i++) changed[random.below(changed.length)] = random.below(256);
  return file(`changed-${name}`, changed);
}

async function dragFrom(page: Page, random: Random, selector: string): Promise<void> {
  const box = await page.locator(selector).boundingBox();
  if (!box) return;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 0; i < 6; i++) await page.mouse.move(x + 160 * (random.next() - 0.5), y + 120 * (random.next() - 0.5));
  await page.mouse.up();
}

/** The actions of a lap, in random order, each with its number of repeats. */
export const ACTIONS: readonly { times: number; name: string; act: Action }[] = [
  { times: 6, name: 'drag the light', act: (page, random) => dragFrom(page, random, '#lamp') },
  { times: 2, name: 'turn the model', act: (page, random) => dragFrom(page, random, '#drawing') },
  { times: 4, name: 'model', act: setting('model', MODELS) },
  { times: 3, name: 'technique', act: setting('technique', TECHNIQUES) },
  { times: 2, name: 'comparison', act: setting('compare', ['none', 'none', ...TECHNIQUES]) },
  { times: 2, name: 'style', act: setting('mapStyle', STYLES) },
  { times: 1, name: 'seed', act: setting('mapSeed', ['1', '2', '3', '4', '5']) },
  { times: 1, name: 'shadows', act: setting('shadows', ['on', 'off']) },
  { times: 1, name: 'ground', act: setting('ground', ['none', 'shadow', 'floor']) },
  { times: 1, name: 'light', act: setting('lightKind', ['directional', 'point', 'spot']) },
  { times: 1, name: 'occlusion', act: setting('occlusion', ['0', '50']) },
  { times: 1, name: 'lines', act: setting('lines', ['on', 'off']) },
  { times: 1, name: 'surfaces', act: setting('surfaceColors', ['shown', 'paper']) },
  {
    times: 3,
    name: 'file',
    act: async (page, random) => drop(page, [await chooseFile(random), file('octahedron.mtl', octahedronMtl)]),
  },
  {
    times: 3,
    name: 'broken file',
    act: async (page, random) => drop(page, [broken(await chooseFile(random), random)]),
  },
  { times: 2, name: 'animated model', act: (page, random) => playAnimated(page, random.below(8)) },
  { times: 1, name: 'many parts', act: (page) => drop(page, [file('parts.glb', partsGlb())]) },
  {
    times: 3,
    name: 'model of another site',
    act: async (page, random) => {
      await askForModel(page, random);
      // Later links that keep this model would ask again.
      await setting('model', MODELS)(page, random);
    },
  },
  ...Object.keys(LACKS).map((lack) => ({
    times: 1,
    name: `a browser ${lack}`,
    act: (page: Page) => visitPoor(page, lack),
  })),
  { times: 1, name: 'save', act: async (page) => void (await savePicture(page)) },
];
