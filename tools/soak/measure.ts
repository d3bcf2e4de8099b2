import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import type { Browser, Page } from '@playwright/test';
import { liveObjects } from '../browser/liveObjects.js';
import { follow } from '../browser/playground.js';
import type { Lap } from './judge.js';

/** The link to what the page shows while its objects are counted. */
export const REST = 'mapSize=64&mapTones=4&model=cube';

/** Counts the objects after the page has gone to what it shows at the end of every lap. */
export async function measure(page: Page, browser: Browser): Promise<Lap> {
  for (const model of ['sphere', 'cube']) {
    await follow(page, REST.replace('cube', model));
  }
  const { kilobytes, ...counts } = await countsOf(page);
  return { ...counts, arrays: kilobytes / 1000, heap: await heapOf(page), process: await memoryOf(browser) };
}

/** The number of objects of each kind, under names in lower case. */
export async function countsOf(page: Page): Promise<Lap> {
  const counts = Object.entries(await liveObjects(page));
  return Object.fromEntries(counts.map(([kind, count]) => [kind.toLowerCase(), count]));
}

/** Longer than anything here should take, also on a slow machine. */
const STUCK_MILLISECONDS = 120_000;

/** Waits until the page of the figures has drawn all that it shows. */
export const settleFigures = (page: Page) =>
  page.waitForFunction(() => window.__figures?.isIdle, null, { timeout: STUCK_MILLISECONDS });

/** Turns the light of the figures, and counts the objects. */
export async function turnFigures(page: Page, times: number): Promise<Lap> {
  for (let i = 0; i < times; i++) {
    await page.locator('#turn').fill(String(((i * 35) % 360) - 180));
    await settleFigures(page);
  }
  return countsOf(page);
}

/** A count or a measurement, for the report. */
export const format = (value: number | undefined): string =>
  value === undefined ? '–' : Number.isInteger(value) ? String(value) : value.toFixed(1);

/** The size of the JavaScript heap in megabytes. */
async function heapOf(page: Page): Promise<number> {
  const session = await page.context().newCDPSession(page);
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  return usedSize / 1e6;
}

/** The memory of the browser's processes for pages and graphics in megabytes; 0 where it is not known. */
async function memoryOf(browser: Browser): Promise<number> {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const held = processInfo.filter(({ type }) => /renderer|GPU/i.test(type)).map(({ id }) => residentMegabytes(id));
  return held.reduce((sum, one) => sum + one, 0);
}

function residentMegabytes(process: number): number {
  try {
    return Number(/VmRSS:\s*(\d+)/.exec(readFileSync(`/proc/${process}/status`, 'utf8'))?.[1] ?? 0) / 1000;
  } catch {
    return residentByPs(process);
  }
}

function residentByPs(process: number): number {
  try {
    return Number(execFileSync('ps', ['-o', 'rss=', '-p', String(process)], { encoding: 'utf8' })) / 1000;
  } catch {
    return 0;
  }
}
