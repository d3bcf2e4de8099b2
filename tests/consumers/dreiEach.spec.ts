import { expect, test } from '../browser/test.js';
import { type ReactServer, startReactServer } from './reactServer.js';

/** A page that mounts, changes and unmounts components of drei inside of `<Hatched>`, one at a time. */
let server: ReactServer;

test.beforeAll(async () => {
  server = await startReactServer('dreiEach.html', ['@react-three/drei', '@pmndrs/assets/fonts/inter_regular.woff']);
});

test.afterAll(() => server.close());

const SHARES = 6;
for (let share = 0; share < SHARES; share++) {
  test(`components of drei mount, change and unmount with the right picture, and leave nothing behind: share ${share + 1} of ${SHARES}`, {
    tag: '@all',
  }, async ({ page, pageProblems }) => {
    test.slow();
    await page.goto(`${server.address}dreiEach.html`);
    await page.waitForFunction(() => window.dreiEach?.isReady);
    const all = await page.evaluate(() => window.dreiEach.names);
    expect(all.length).toBeGreaterThan(60);
    const wrong: Record<string, string[]> = {};
    for (const name of all.filter((_, i) => i % SHARES === share)) {
      const found = await page.evaluate((part) => window.dreiEach.wrongWith(part), name);
      found.push(...pageProblems.splice(0));
      if (found.length > 0) wrong[name] = found;
    }
    expect(wrong).toEqual({});
  });
}
