import type { Page } from '@playwright/test';
import type { Random } from '../../src/viewer/settings/Random.js';
import { idle } from '../browser/playground.js';
import { octahedronPly } from '../modelFiles/modelFiles.js';

const SITES = ['https://models.test', 'https://trusted.test:8443', 'https://xn--80ak6aa92e.test'];
const FILES = [
  'octahedron.ply',
  // The characters of this name turn its text round.
  '%E2%80%AEylp.elpmaxe%20morf.ply',
  `${'very%20'.repeat(150)}long.ply`,
  'in%0Atwo%09lines.ply',
  // The address is not that of a model.
  'page.html',
];
const ADDRESSES = SITES.flatMap((site) => FILES.map((file) => `${site}/${file}`));
const ANSWERS = ['yes', 'no', 'Escape'] as const;

/** Characters that a question must not show: those that turn text round, and those that cannot be seen. */
const HIDDEN = /[\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]/;
/** The most characters that a question may have. Longer names are cut. */
const LONGEST = 600;

/**
 * Follows links to models of other sites, each of them while the question about the previous one is open, and answers the last question.
 *
 * @returns the addresses that it agreed to
 * @throws Error if a question is not plain, or if anything was fetched without consent
 */
export async function askForModel(page: Page, random: Random): Promise<string[]> {
  // A link to the model that is shown leads to no question.
  const shown = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('model'));
  const others = ADDRESSES.filter((address) => address !== shown);
  const wanted = Array.from({ length: 1 + random.below(3) }, () => random.pick(others));
  const answer = random.pick(ANSWERS);
  const asked: string[] = [];
  const isOther = (url: URL): boolean => url.hostname.endsWith('.test');
  await page.route(isOther, (route) => {
    asked.push(route.request().url());
    return route.fulfill({ body: octahedronPly, headers: { 'Access-Control-Allow-Origin': '*' } });
  });
  try {
    for (const address of wanted) await followTo(page, address);
    const question = await page.locator('#ask').innerText();
    if (HIDDEN.test(question) || question.length > LONGEST) throw new Error(`The question is not plain: ${question}`);
    if (answer === 'Escape') await page.keyboard.press('Escape');
    else await page.locator(`#ask [value=${answer}]`).click();
    await page.locator('#ask').waitFor({ state: 'hidden' });
    await idle(page);
    // Other links are made from the page's address, which returns to that of the shown model.
    await page.waitForFunction(
      (refused) => new URLSearchParams(location.hash.slice(1)).get('model') !== refused,
      answer === 'yes' ? undefined : wanted.at(-1),
    );
  } finally {
    await page.unroute(isOther);
  }
  const agreed = answer === 'yes' ? wanted.slice(-1) : [];
  if (asked.join() !== agreed.join()) {
    throw new Error(
      `Asked about ${wanted.join(', then ')} and answered ${answer}, the page fetched ${asked.join() || 'nothing'}.`,
    );
  }
  return agreed;
}

/** Follows a link to a model, and waits until the page asks about it. */
async function followTo(page: Page, address: string): Promise<void> {
  await page.evaluate((model) => {
    const link = new URLSearchParams(location.hash.slice(1));
    link.set('model', model);
    location.hash = link.toString();
  }, address);
  // Several questions about one site look the same.
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve)));
  await page.locator('#ask', { hasText: new URL(address).host }).waitFor();
}
