import type { Browser, Page } from '@playwright/test';
import { Random } from '../../src/viewer/settings/Random.js';
import { countObjects } from '../browser/liveObjects.js';
import { drop, follow, idle } from '../browser/playground.js';
import { watchProblems } from '../browser/watchProblems.js';
import { file } from '../modelFiles/modelFiles.js';
import { partsGlb } from '../modelFiles/partsModel.js';
import { GOOD, MODELS, playAnimated, STYLES, TECHNIQUES } from './actions.js';
import { askForModel } from './askForModel.js';
import { grown, type Lap } from './judge.js';
import { countsOf, format, measure, REST, settleFigures, turnFigures } from './measure.js';

interface RepeatOptions {
  /** Base URL of the pages. */
  address: string;
  /** Number of repeats of each action. */
  times: number;
  /** Prints a line. */
  say: (line: string) => void;
}

/** Does one action for the `i`th time. The value it sets changes each time, and comes again after a few times. */
type Repeated = (page: Page, i: number) => Promise<void>;

const at = <Item>(items: readonly Item[], i: number): Item => items[i % items.length];

const link =
  (key: string, values: readonly string[]): Repeated =>
  (page, i) =>
    follow(page, `${REST.replace(key === 'model' ? 'model=cube' : '', '')}&${key}=${at(values, i)}`);

const REPEATED: Readonly<Record<string, Repeated>> = {
  model: link('model', MODELS),
  technique: link('technique', TECHNIQUES),
  preset: async (page, i) => {
    // The card may be closed on a small page.
    await page.locator('#presets button').evaluateAll((buttons, place) => {
      (buttons[place % buttons.length] as HTMLElement).click();
    }, i);
    await idle(page);
  },
  map: link('mapStyle', STYLES),
  comparison: link('compare', ['triangle', 'none', 'engraving', 'adjacency']),
  file: async (page, i) => {
    const [name, content] = at(GOOD, i);
    await drop(page, [file(name, await content())]);
    await idle(page);
  },
  'animated model': playAnimated,
  'many parts': async (page) => {
    await drop(page, [file('parts.glb', partsGlb())]);
    await idle(page);
  },
  'model of another site': async (page, i) => void (await askForModel(page, new Random(i))),
};

/** The columns of the table: the kinds that are counted. */
const COLUMNS = ['buffer', 'texture', 'program', 'framebuffer', 'vertexarray', 'worker', 'url', 'listeners', 'nodes'];
const MEGABYTES = ['arrays', 'heap', 'process'];
/** Number of repeats before the first count, so that every value has been shown once: programs and maps are kept. */
const MOST_VALUES = Math.max(MODELS.length, TECHNIQUES.length, STYLES.length, GOOD.length);

/**
 * Does each action many times, and counts the objects before and after.
 *
 * @returns a line for each kind that grew
 */
export async function repeat(browser: Browser, { address, times, say }: RepeatOptions): Promise<string[]> {
  const page = await browser.newPage({ viewport: { width: 480, height: 360 } });
  const problems = watchProblems(page);
  await countObjects(page);
  await page.goto(`${address}#${REST}`);
  await idle(page);
  const complaints: string[] = [];
  const row = (name: string, before: Lap, after: Lap): void => {
    const pairs = [...COLUMNS, ...MEGABYTES].filter((kind) => kind in before);
    say(`${name}: ${pairs.map((kind) => `${kind} ${format(before[kind])} → ${format(after[kind])}`).join(', ')}`);
    complaints.push(...grown(before, after).map((complaint) => `${name}: ${complaint}`));
  };
  for (const [name, act] of Object.entries(REPEATED)) {
    for (let i = 0; i < MOST_VALUES; i++) await act(page, i);
    const before = await measure(page, browser);
    for (let i = 0; i < times; i++) await act(page, i);
    row(`${name}, ${times} times`, before, await measure(page, browser));
    if (problems.length > 0) return [...complaints, ...problems];
  }
  await repeatFigures(page, address, times, row);
  return [...complaints, ...problems];
}

/** Turns the light of the figures, and opens their page anew. */
async function repeatFigures(
  page: Page,
  address: string,
  times: number,
  row: (name: string, before: Lap, after: Lap) => void,
): Promise<void> {
  await page.goto(`${address}figures/`);
  await settleFigures(page);
  row(`light of the figures, ${times} times`, await turnFigures(page, 2), await turnFigures(page, times));
  const before = await countsOf(page);
  for (let i = 0; i < times; i++) {
    await page.reload();
    await page.waitForFunction(() => window.__figures !== undefined);
  }
  await settleFigures(page);
  row(`page of the figures, ${times} times`, before, await turnFigures(page, 2));
}
