import { expect, test } from '../browser/test.js';
import { type ReactServer, startReactServer } from './reactServer.js';

/** A page of drei's helpers inside `<Hatched>`. */
let server: ReactServer;

test.beforeAll(async () => {
  server = await startReactServer('drei.html', ['@react-three/drei', '@pmndrs/assets/fonts/inter_regular.woff']);
});

test.afterAll(() => server.close());

/** Waits until the page has been hatched and has drawn some more frames. */
async function open(page: import('@playwright/test').Page, hash: string): Promise<void> {
  await page.goto(`${server.address}drei.html${hash}`);
  await page.waitForFunction(() => window.dreiPage?.hatchings > 0);
  await drawFrames(page);
}

async function drawFrames(page: import('@playwright/test').Page): Promise<void> {
  const before = await page.evaluate(() => window.dreiPage.frames);
  await page.waitForFunction((n) => window.dreiPage.frames > n + 8, before);
}

test('of the twelve most used helpers those with shaders of their own are left alone, and the rest is hatched', {
  tag: '@all',
}, async ({ page }) => {
  await open(page, '');
  await page.waitForFunction(() => window.dreiPage.materials().text);
  const materials = () => page.evaluate(() => window.dreiPage.materials());
  await expect.poll(materials).toMatchObject({
    'model ball': 'HatchingMaterial',
    'model box': 'HatchingMaterial',
    'model instances': 'HatchingMaterial',
    mirror: 'MeshStandardMaterial',
  });
  const reasons = await page.evaluate(() => window.dreiPage.last!.skipped.map(({ reason }) => reason));
  const says = (words: RegExp) =>
    expect(
      reasons.some((reason) => words.test(reason)),
      String(words),
    ).toBe(true);
  says(/"grid" .* is left alone: its material has a shader of its own/);
  says(/"mirror" .* is left alone: its material changes its shader in onBeforeCompile/);
  says(/ is left alone: its material shows a render target/);
  // The colour of a material follows, and nothing is hatched again.
  const hatchings = await page.evaluate(() => window.dreiPage.hatchings);
  await page.evaluate(() => window.dreiPage.setColor('#0000ff'));
  await expect.poll(() => page.evaluate(() => window.dreiPage.colorOf('model ball'))).toBe('0000ff');
  await drawFrames(page);
  expect(await page.evaluate(() => [window.dreiPage.hatchings, window.dreiPage.errors])).toEqual([hatchings, []]);
  expect(await page.evaluate(() => window.dreiPage.flashes)).toBe(0);
  expect(await page.evaluate(() => window.dreiPage.ink())).toBeGreaterThan(0.01);
});

test('a stage with accumulative shadows is hatched once, and is drawn in every frame', { tag: '@all' }, async ({
  page,
}) => {
  await open(page, '#stage');
  const hatchings = await page.evaluate(() => window.dreiPage.hatchings);
  for (let i = 0; i < 3; i++) {
    await drawFrames(page);
    expect(await page.evaluate(() => window.dreiPage.ink())).toBeGreaterThan(0.005);
  }
  expect(await page.evaluate(() => window.dreiPage.materials())).toEqual({ 'model ball': 'HatchingMaterial' });
  expect(
    await page.evaluate(() => [window.dreiPage.hatchings, window.dreiPage.flashes, window.dreiPage.errors]),
  ).toEqual([hatchings, 0, []]);
});
