import type { Page } from '@playwright/test';
import { expect, test } from '../browser/test.js';
import { file, octahedronPly } from './modelFiles.js';
import { changedShare } from './pictures.js';
import { openPlayground, readDrawing, ready } from './playground.js';

test.use({ viewport: { width: 900, height: 420 } });

const LOOK = 'mapSize=64&mapTones=4&lines=off&upAxis=z';
/** Pastes a link into the open page. */
async function follow(page: Page, hash: string): Promise<void> {
  await page.evaluate((link) => {
    location.hash = link;
  }, hash);
}

const modelAt = (path: string): string => encodeURIComponent(`https://models.test/${path}`);

test('a model by its address is fetched when the user has agreed, by the one page that may', async ({
  page,
  pageProblems,
}) => {
  const asked: string[] = [];
  await page.route('https://models.test/**', (route) => {
    const { pathname } = new URL(route.request().url());
    asked.push(pathname);
    const headers = { 'Access-Control-Allow-Origin': pathname === '/closed.ply' ? 'https://other.test' : '*' };
    if (pathname === '/missing.ply') return route.fulfill({ status: 404, headers });
    return route.fulfill({ body: file('octahedron.ply', octahedronPly).buffer, headers });
  });
  const name = page.locator('#model-name');
  const status = page.locator('#status');
  const question = page.getByRole('dialog', { name: /another site: octahedron\.ply, from models\.test/ });
  const [yes, no] = [page.getByRole('button', { name: 'Fetch it' }), page.getByRole('button', { name: 'Leave it' })];

  await page.goto(`./#model=${modelAt('octahedron.ply')}&${LOOK}`);
  await expect(question).toBeVisible();
  await no.click();
  await expect(name).toHaveText('Stanford dragon');
  expect(asked).toEqual([]);
  await openPlayground(page, `model=cube&${LOOK}`);

  await follow(page, `model=${modelAt('octahedron.ply')}&${LOOK}`);
  await yes.click();
  await expect(name).toHaveText('octahedron.ply');
  expect(asked).toEqual(['/octahedron.ply']);
  const drawn = await readDrawing(page);
  // The link goes on naming it, and the browser keeps it: it is not fetched again.
  await expect.poll(() => page.evaluate(() => history.state?.drawing)).toBeTruthy();
  expect(page.url()).toContain(`model=${modelAt('octahedron.ply')}`);
  expect(page.url()).toContain('upAxis=z');
  await page.reload();
  await expect(name).toHaveText('octahedron.ply');
  expect(changedShare(drawn, await readDrawing(page))).toBe(0);
  expect(asked).toHaveLength(1);

  for (const [path, sentence] of [
    ['closed.ply', /does not let other pages fetch its files \(CORS\)\. Download it there, and drop it here\.$/],
    ['missing.ply', /^models\.test has no such file: it answered 404 for missing\.ply\.$/],
  ] as const) {
    await follow(page, `model=${modelAt(path)}&${LOOK}`);
    await yes.click();
    await expect(status).toHaveText(sentence);
    await expect(name).toHaveText('octahedron.ply');
  }
  // The browser says so, too.
  expect(pageProblems.splice(0).filter((problem) => !/CORS|ERR_FAILED|404/.test(problem))).toEqual([]);
  // The page itself may not: its policy is as it was.
  const isForbidden = await page.evaluate(() =>
    fetch('https://models.test/octahedron.ply').then(
      () => false,
      () => true,
    ),
  );
  expect(isForbidden).toBe(true);
  expect(asked).toHaveLength(3);
  expect(pageProblems.splice(0).join()).toMatch(/Content Security Policy/);
});

test('what was asked for and did not come leaves nothing behind: no style, no axis, no picture', async ({ page }) => {
  let release = (): void => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/dragon_vrip_res4\.ply.*\.gz$/, async (route) => {
    await held;
    await route.continue();
  });
  const status = page.locator('#status');
  await page.addInitScript(() => {
    Object.defineProperty(navigator, 'share', {
      value: async (data: ShareData) => void Object.assign(window, { shared: data }),
      configurable: true,
    });
  });
  // Nothing is there to be saved.
  await page.goto(`./#model=dragon4&${LOOK}`);
  await expect(status).toHaveText(/^Fetching the dragon/);
  // Until the map is there too, its progress may take the place of the sentence.
  await expect(async () => {
    await page.locator('#save-png').click();
    await expect(status).toHaveText('There is no drawing to save yet.', { timeout: 1000 });
  }).toPass();
  release();
  await ready(page);

  // A style whose drawing is cancelled is not the style of the page.
  const style = page.getByRole('combobox', { name: 'Style' });
  await page.getByRole('button', { name: 'More', exact: true }).click();
  await page.getByRole('combobox', { name: 'Tile size' }).selectOption('512 px');
  await page.locator('#cancel').click();
  await expect(status).toHaveText('Cancelled; the drawing is as it was.');
  await expect(page.getByRole('combobox', { name: 'Tile size' })).toHaveValue('64 px');
  await expect(style).toHaveValue('Hatching');
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('mapSize=64');

  // A link that is pasted brings its own axis, also to another model.
  await follow(page, `model=cube&${LOOK}`);
  await expect(page.locator('#model-name')).toHaveText('Cube');
  await ready(page);
  expect(await page.evaluate(() => location.hash)).toContain('upAxis=z');

  // The system's sheet gets what the address would be.
  await page.getByRole('button', { name: 'Picture', exact: true }).click();
  await page.getByRole('button', { name: 'Share this drawing' }).click();
  // What shares is fetched with the first click.
  await expect
    .poll(() => page.evaluate(() => (window as unknown as { shared?: ShareData }).shared))
    .toEqual({ title: 'Cube, hatched', url: expect.stringContaining('#model=cube&') });
});
