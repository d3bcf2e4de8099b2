/**
 * `npm run test:firefox`: the core of the playground in Firefox, built as users meet it. Takes a Firefox (Debian: `firefox-esr`, or the
 * path in HATCH_FIREFOX) and Xvfb, and skips with a message where one is missing. `npm test` does not run it: it takes half a minute more.
 */
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';
import { serveBuilt } from '../../tools/browser/serveBuilt.mjs';
import { checks } from './checks.mjs';
import { findFirefox, findProgram, startDisplay } from './findFirefox.mjs';
import { installDriver } from './installDriver.mjs';

const firefox = findFirefox();
const xvfb = findProgram('Xvfb');
if (firefox && xvfb) process.exitCode = (await run()) > 0 ? 1 : 0;
else console.log(`Skipped: there is no ${firefox ? 'Xvfb' : 'Firefox'} here. On Debian: apt install firefox-esr xvfb`);

/** @returns {Promise<number>} how many checks failed */
async function run() {
  const root = fileURLToPath(new URL('../..', import.meta.url));
  const output = join(root, 'tests', 'output', 'firefox');
  mkdirSync(output, { recursive: true });
  const downloads = mkdtempSync(join(tmpdir(), 'hatching-'));
  const files = mkdtempSync(join(tmpdir(), 'hatching-'));
  const driver = await installDriver();
  const site = await serveBuilt(root, join(output, 'site'));
  const modules = await createServer({ root, mode: 'test', logLevel: 'error', server: { middlewareMode: true } });
  const screen = await startDisplay(xvfb);
  let browser;
  try {
    browser = await driver.launch({
      browser: 'firefox',
      executablePath: firefox,
      headless: false,
      // Mesa's llvmpipe draws, on the processor.
      env: { ...process.env, DISPLAY: screen.display, LIBGL_ALWAYS_SOFTWARE: '1' },
      defaultViewport: { width: 1100, height: 700 },
      extraPrefsFirefox: {
        'browser.download.folderList': 2,
        'browser.download.dir': downloads,
        'browser.download.useDownloadDir': true,
        'browser.download.always_ask_before_handling_new_types': false,
      },
    });
    const page = await browser.newPage();
    console.log(`${await browser.version()}, ${firefox}`);
    return await runChecks({ page, address: site.address, downloads, files, output, modules });
  } finally {
    await browser?.close();
    screen.close();
    await modules.close();
    await site.close();
    for (const folder of [downloads, files]) rmSync(folder, { recursive: true, force: true });
  }
}

async function runChecks({ page, output, ...rest }) {
  const problems = [];
  page.on('console', (message) => {
    if (['warn', 'warning', 'error'].includes(message.type())) problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.stack ?? error.message));
  let failed = 0;
  for (const [name, check] of Object.entries(checks)) {
    try {
      await check({ page, ...rest });
      if (problems.length > 0) throw new Error(`The page complains: ${problems.splice(0).join('\n')}`);
      console.log(`  ✓ ${name}`);
    } catch (error) {
      failed++;
      console.log(`  ✘ ${name}\n${error.stack}`);
      await page.screenshot({ path: join(output, `failed-${failed}.png`) });
    }
  }
  console.log(`${Object.keys(checks).length - failed} passed, ${failed} failed`);
  return failed;
}
