import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { launchOptions } from '../browser/launchOptions.mjs';

/** A page that is isolated from others gets a clock of 5 instead of 100 microseconds. */
const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

/**
 * A browser and a server of the benchmark page.
 *
 * `measure` runs a measurement in a page of its own, where nothing is compiled or cached yet, and closes it; `openMeasuring` leaves
 * the page open for several that belong together.
 *
 * @param {'swiftshader' | 'llvmpipe' | 'gpu'} [rasteriser]
 */
export async function openBrowser(rasteriser) {
  const server = await createServer({
    root: fileURLToPath(new URL('../..', import.meta.url)),
    mode: 'test',
    logLevel: 'error',
    server: { host: '127.0.0.1', port: 0, headers: isolation },
  });
  await server.listen();
  const browser = await chromium.launch(await launchOptions(rasteriser, { webgpu: true }));
  const clock = rasteriser === 'gpu' ? '?clock=gpu' : '';
  const openPage = async (address) => {
    const page = await browser.newPage();
    page.on('pageerror', (error) => console.error(error));
    await page.goto(address);
    return page;
  };
  const openMeasuring = async () => {
    const page = await openPage(`${server.resolvedUrls.local[0]}tools/bench/bench.html${clock}`);
    await page.waitForFunction(() => typeof window.measure === 'function');
    const measure = (name, ...args) => page.evaluate(([name, args]) => window.measure(name, ...args), [name, args]);
    return { page, measure };
  };
  return {
    openPage,
    openMeasuring,
    async measure(name, ...args) {
      const { page, measure } = await openMeasuring();
      try {
        return await measure(name, ...args);
      } finally {
        await page.close();
      }
    },
    /** The process ids of the pages. */
    async rendererPids() {
      const session = await browser.newBrowserCDPSession();
      const { processInfo } = await session.send('SystemInfo.getProcessInfo');
      await session.detach();
      return processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id);
    },
    async close() {
      await browser.close();
      await server.close();
    },
  };
}
