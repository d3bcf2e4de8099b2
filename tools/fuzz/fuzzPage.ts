import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { Random } from '../../src/viewer/settings/Random.js';
import { follow, idle, ready } from '../browser/playground.js';
import { askForModel } from '../soak/askForModel.js';
import { checkSentence, checkWords } from './checkWords.js';
import { goodDrop } from './goodFiles.js';
import { mutate } from './mutate.js';
import { takeWatch } from './watchPage.js';

/** The kind whose cases are not dropped, but asked about: models of other sites. */
export const QUESTIONS = 'questions';

/** One drop of damaged files, or some questions. */
export interface FuzzCase {
  kind: string;
  seed: number;
}

/** The outcome of a case. */
export interface FuzzOutcome extends FuzzCase {
  outcome: 'good' | 'refused';
  /** Whether a model was read but cannot be seen. The damage may be the reason, for instance an opacity of 0. */
  isBlank: boolean;
  /** Milliseconds of the longest task on the main thread. */
  longest: number;
  /** The problem. */
  failures: string[];
}

interface FuzzOptions {
  address: string;
  settings?: string;
  watched: readonly string[][];
  onCase: (outcome: FuzzOutcome) => void;
}

/** The page between cases. Its map is small, since a large one only takes time. */
const REST = 'model=cube&mapSize=64&mapTones=4';
/** Number of cases between checks that the page still draws its first picture. */
const CASES_BETWEEN_LOOKS = 10;

/**
 * Drops damaged files on the playground, as `goodDrop` and `mutate` make them of seeds, and looks at what comes of it.
 *
 * @param options.address where the playground lies
 * @param options.settings more of a link, such as `occlusion=0`
 * @param options.watched what the page complains of, and what it asks for elsewhere; both are emptied
 * @param options.onCase told of each case when it has ended
 */
export async function fuzzPage(
  page: Page,
  cases: readonly FuzzCase[],
  { address, settings = '', watched, onCase }: FuzzOptions,
): Promise<void> {
  const rest = `${REST}&${settings}`;
  await page.goto(`${address}#${rest}`);
  await ready(page);
  // Elements over the drawing are hidden.
  await page.evaluate(() => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync('#viewport > :not(canvas) { visibility: hidden !important }');
    // The page's policy forbids inline styles.
    document.adoptedStyleSheets.push(sheet);
  });
  const first = await picture(page);
  if (isOneColour(first)) throw new Error('fuzzPage: the page draws nothing.');
  for (const [i, { kind, seed }] of cases.entries()) {
    await takeWatch(page);
    const failures: string[] = [];
    const fail = (error: unknown) => void failures.push(error instanceof Error ? error.message : String(error));
    let outcome: FuzzOutcome['outcome'] = 'refused';
    let isBlank = false;
    let agreed: string[] = [];
    try {
      if (kind === QUESTIONS) agreed = await askForModel(page, new Random(seed));
      else await dropFiles(page, kind, seed);
      outcome = await outcomeOn(page);
      isBlank = outcome === 'good' && isOneColour(await picture(page));
    } catch (error) {
      fail(error);
    }
    const { longest, complaints } = await takeWatch(page);
    for (const complaint of [...complaints, ...watched.flatMap((list) => list.splice(0))])
      if (!agreed.includes(complaint)) fail(complaint);
    const isLooked = i === cases.length - 1 || i % CASES_BETWEEN_LOOKS === CASES_BETWEEN_LOOKS - 1;
    if (isLooked && !(await returns(page, rest, first))) fail('The page does not draw any more as it did.');
    onCase({ kind, seed, outcome, isBlank, longest, failures });
  }
}

async function dropFiles(page: Page, kind: string, seed: number): Promise<void> {
  const random = new Random(seed);
  const files = mutate(await goodDrop(kind, random), random);
  const payload = await Promise.all(
    files.map(async ({ name, content }) => ({
      name,
      mimeType: 'application/octet-stream',
      buffer: Buffer.from(await content.arrayBuffer()),
    })),
  );
  await page.locator('#file-input').setInputFiles(payload);
  if (kind === 'strokes') await page.locator('#ask [value=yes]').click();
  await idle(page);
}

/** The outcome of a case. @throws Error if the message to the user is not plain */
async function outcomeOn(page: Page): Promise<FuzzOutcome['outcome']> {
  const { status, isRefused, caption } = await page.evaluate(() => {
    const line = document.querySelector('#status')!;
    return {
      status: line.textContent ?? '',
      isRefused: line.classList.contains('is-error'),
      caption: ['#model-caption', '#about-model'].map((part) => document.querySelector(part)!.textContent).join(' '),
    };
  });
  if (isRefused) checkSentence(status);
  else checkWords(caption);
  return isRefused ? 'refused' : 'good';
}

/** Whether the page draws again what it drew at first. */
async function returns(page: Page, rest: string, first: PNG): Promise<boolean> {
  await follow(page, rest.replace('cube', 'sphere'));
  await follow(page, rest);
  await ready(page);
  return (await picture(page)).data.equals(first.data);
}

const picture = async (page: Page): Promise<PNG> => PNG.sync.read(await page.locator('#viewport').screenshot());

function isOneColour({ data }: PNG): boolean {
  for (let i = 4; i < data.length; i++) if (data[i] !== data[i % 4]) return false;
  return true;
}
