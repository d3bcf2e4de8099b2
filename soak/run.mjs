/**
 * `npm run soak`: uses the playground for 20 minutes as people do, by chance: drags the light, turns models, chooses techniques,
 * presets and maps, drops files, good and broken, saves pictures. Prints a table, and ends with 1 if anything grows, hangs or fails.
 *
 * `npm run soak -- --minutes=3` takes less time, `--seed=7` does other things.
 */
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { launchOptions } from '../tests/browser/launchOptions.mjs';

const { values } = parseArgs({
  options: { minutes: { type: 'string', default: '20' }, seed: { type: 'string', default: '1' } },
});
const minutes = Number(values.minutes);
const seed = Number(values.seed);
if (!(minutes > 0) || !Number.isInteger(seed)) {
  throw new Error('soak/run.mjs: --minutes takes a positive number, --seed a whole one.');
}

const root = fileURLToPath(new URL('..', import.meta.url));
const server = await createServer({ root, mode: 'test', logLevel: 'error', server: { host: '127.0.0.1', port: 0 } });
await server.listen();
const browser = await chromium.launch(await launchOptions());
try {
  const { soak } = await server.ssrLoadModule('/soak/soak.ts');
  const address = server.resolvedUrls.local[0];
  const complaints = await soak(browser, { address, minutes, seed, say: (line) => console.log(line) });
  for (const complaint of complaints) console.error(complaint);
  console.log(complaints.length === 0 ? 'Nothing grows.' : `${complaints.length} complaints.`);
  process.exitCode = complaints.length === 0 ? 0 : 1;
} finally {
  await browser.close();
  await server.close();
}
