/**
 * `npm run soak`: uses the playground for 20 minutes as people do, in random order: drags the light, turns models, chooses techniques,
 * presets and maps, drops files, good and broken, saves pictures. Prints a table, and ends with 1 if anything grows, hangs or fails.
 *
 * `npm run soak -- --minutes=3` takes less time, `--seed=7` takes another order. `npm run soak -- --repeats=40` does each action forty times
 * instead: model, technique, preset, map, comparison, file, page of the figures; and prints the counts before and after.
 */
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { launchOptions } from '../browser/launchOptions.mjs';

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '20' },
    seed: { type: 'string', default: '1' },
    repeats: { type: 'string', default: '0' },
  },
});
const minutes = Number(values.minutes);
const [seed, times] = [Number(values.seed), Number(values.repeats)];
if (!(minutes > 0) || !Number.isInteger(seed) || !Number.isInteger(times) || times < 0) {
  throw new Error('tools/soak/run.mjs: --minutes takes a positive number, --seed and --repeats a whole one.');
}

const root = fileURLToPath(new URL('../..', import.meta.url));
const server = await createServer({ root, mode: 'test', logLevel: 'error', server: { host: '127.0.0.1', port: 0 } });
await server.listen();
const browser = await chromium.launch(await launchOptions());
try {
  const address = server.resolvedUrls.local[0];
  const say = (line) => console.log(line);
  const { soak } = await server.ssrLoadModule('/tools/soak/soak.ts');
  const { repeat } = await server.ssrLoadModule('/tools/soak/repeats.ts');
  const complaints = await (times > 0
    ? repeat(browser, { address, times, say })
    : soak(browser, { address, minutes, seed, say }));
  for (const complaint of complaints) console.error(complaint);
  console.log(complaints.length === 0 ? 'Nothing grows.' : `${complaints.length} complaints.`);
  process.exitCode = complaints.length === 0 ? 0 : 1;
} finally {
  await browser.close();
  await server.close();
}
