import type { Browser, Page } from '@playwright/test';
import { Random } from '../../src/viewer/settings/Random.js';
import { countObjects } from '../browser/liveObjects.js';
import { follow, idle } from '../browser/playground.js';
import { watchProblems } from '../browser/watchProblems.js';
import { ACTIONS } from './actions.js';
import { judge, type Lap } from './judge.js';
import { format, measure, REST, settleFigures, turnFigures } from './measure.js';

interface SoakOptions {
  /** Base URL of the pages. */
  address: string;
  minutes: number;
  seed: number;
  /** Prints a line. */
  say: (line: string) => void;
}

const KEPT_ACTIONS = 5;
const COLUMNS = [
  'minute',
  'lap',
  'buffer',
  'texture',
  'program',
  'framebuffer',
  'vertexarray',
  'sync',
  'worker',
  'url',
  'listeners',
  'nodes',
  'arrays',
  'heap',
  'process',
] as const;

/**
 * Uses the playground for some minutes, in laps that do every action in random order, and then the page of the figures.
 *
 * @returns a line for each thing that went wrong
 */
export async function soak(browser: Browser, { address, minutes, seed, say }: SoakOptions): Promise<string[]> {
  const random = new Random(seed);
  const page = await browser.newPage({ viewport: { width: 480, height: 360 } });
  const problems = watchProblems(page);
  await countObjects(page);
  await page.goto(`${address}#${REST}`);
  await idle(page);
  // Shadow maps and the ground are created when they are first needed, and kept.
  for (const light of ['directional', 'point', 'spot']) {
    await follow(page, `${REST}&shadows=on&ground=floor&compare=triangle&lightKind=${light}`);
  }
  const start = performance.now();
  const laps: Lap[] = [];
  /** The latest actions, for finding the cause. */
  let trail: string[] = [];
  const place = (): string => `Lap ${laps.length + 1}, after ${trail.join(', ')}: `;
  say(COLUMNS.map((name) => name.slice(0, 9).padStart(10)).join(''));
  try {
    while (performance.now() - start < 60_000 * minutes) {
      for (const { name, act } of shuffled(random)) {
        trail = [...trail.slice(-KEPT_ACTIONS + 1), name];
        await act(page, random);
        await idle(page);
        if (problems.length > 0) return [`${place()}${problems.join('\n')}`];
      }
      const lap = await measure(page, browser);
      laps.push(lap);
      const row: Record<string, number> = { minute: (performance.now() - start) / 60_000, lap: laps.length, ...lap };
      say(COLUMNS.map((name) => format(row[name]).padStart(10)).join(''));
    }
    return [...judge(laps), ...(await soakFigures(page, address, say)), ...problems];
  } catch (error) {
    return [`${place()}${(error as Error).message}`, ...problems];
  }
}

/** Turns the light of the figures forty times. */
async function soakFigures(page: Page, address: string, say: (line: string) => void): Promise<string[]> {
  await page.goto(`${address}figures/`);
  await settleFigures(page);
  const laps = [await turnFigures(page, 2)];
  for (let i = 0; i < 4; i++) laps.push(await turnFigures(page, 10));
  say(`Figures, the light turned 42 times: ${laps.map(({ texture }) => texture).join(', ')} textures.`);
  return judge(laps).map((complaint) => `Figures: ${complaint}`);
}

function shuffled(random: Random): (typeof ACTIONS)[number][] {
  const actions = ACTIONS.flatMap((action) => Array.from({ length: action.times }, () => action));
  for (let i = actions.length - 1; i > 0; i--) {
    const j = random.below(i + 1);
    [actions[i], actions[j]] = [actions[j], actions[i]];
  }
  return actions;
}
