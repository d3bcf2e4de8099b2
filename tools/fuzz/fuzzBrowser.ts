import type { Browser } from '@playwright/test';
import { watchProblems } from '../browser/watchProblems.js';
import { LACKS } from '../soak/poorBrowsers.js';
import { type FuzzOutcome, fuzzPage, QUESTIONS } from './fuzzPage.js';
import { PAGE_KINDS } from './goodFiles.js';
import { watchPage } from './watchPage.js';

/** The outcomes of the cases of one kind of file. */
interface Sums {
  cases: number;
  good: number;
  refused: number;
  blank: number;
  failed: number;
  'longest block, ms': number;
  'its seed': number | undefined;
}

const KINDS = [...PAGE_KINDS, QUESTIONS];
/** Number of cases after which another browser opens the page, so that cases do not accumulate; the soak finds what does. */
const CASES_PER_PAGE = 50;
const BROWSERS = [undefined, ...Object.keys(LACKS)];
/** Tasks of the main thread that take longer are reported at once. */
const MAX_BLOCK_MILLISECONDS = 2000;

/**
 * Drops damaged files on the playground in a browser.
 *
 * @param options.first the first seed
 * @returns counts by kind, and what went wrong
 */
export async function fuzzBrowser(
  browser: Browser,
  { address, count, first, say }: { address: string; count: number; first: number; say: (line: string) => void },
): Promise<{ report: Record<string, Sums>; failures: string[] }> {
  const report: Record<string, Sums> = {};
  const failures: string[] = [];
  const cases = Array.from({ length: count }, (_, i) => ({
    seed: first + i,
    kind: KINDS[(first + i) % KINDS.length],
  }));
  const onCase = ({ kind, seed, outcome, isBlank, longest, failures: wrong }: FuzzOutcome): void => {
    report[kind] ??= {
      cases: 0,
      good: 0,
      refused: 0,
      blank: 0,
      failed: 0,
      'longest block, ms': 0,
      'its seed': undefined,
    };
    const sums = report[kind];
    sums.cases++;
    sums[outcome]++;
    if (isBlank) {
      sums.blank++;
      say(`${kind}, seed ${seed}: the model cannot be seen.`);
    }
    if (longest > sums['longest block, ms']) Object.assign(sums, { 'longest block, ms': longest, 'its seed': seed });
    // Not a failure: a busy machine takes longer to compile the programs of the first frame.
    if (longest > MAX_BLOCK_MILLISECONDS) say(`${kind}, seed ${seed}: the page stood still for ${longest} ms.`);
    if (wrong.length > 0) sums.failed++;
    for (const one of wrong) failures.push(`${kind}, seed ${seed}: ${one}`);
    if (wrong.length > 0) say(failures.at(-1)!);
  };
  for (let i = 0; i < cases.length; i += CASES_PER_PAGE) {
    // Ends clips, which would play for ever.
    const page = await browser.newPage({ viewport: { width: 480, height: 360 }, reducedMotion: 'reduce' });
    const lack = BROWSERS[(i / CASES_PER_PAGE) % BROWSERS.length];
    if (lack) await page.addInitScript(LACKS[lack]);
    const watched = [watchProblems(page), await watchPage(page, address)];
    await fuzzPage(page, cases.slice(i, i + CASES_PER_PAGE), { address, watched, onCase });
    await page.close();
    say(`${Math.min(i + CASES_PER_PAGE, cases.length)} of ${cases.length} cases${lack ? `, the latest ${lack}` : ''}`);
  }
  return { report, failures };
}
