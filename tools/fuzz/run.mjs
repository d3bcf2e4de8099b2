/**
 * `npm run fuzz`: 10,000 damaged files and calls, from seeds. `npm run fuzz -- 50000 20001` tries as many as are asked for, from that seed
 * on. What goes wrong is listed with its seed; the counts are left in tests/output/fuzz.
 *
 * `npm run fuzz -- --browser` drops 300 of the files on the built playground, in Chromium, and watches it: the console, other hosts, how
 * long it stands still, what it gives to WebGL, whether it still draws. `npm run fuzz -- --browser 1000 301`: how many, from which seed.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const root = fileURLToPath(new URL('../..', import.meta.url));
const output = `${root}/tests/output/fuzz`;
const { values, positionals } = parseArgs({ options: { browser: { type: 'boolean' } }, allowPositionals: true });
const [count = values.browser ? 300 : 10_000, first = 1] = positionals.map(Number);
if (!(count > 0) || !(first >= 0)) {
  throw new Error(
    'tools/fuzz/run.mjs: expected a number of cases and the first seed, as in "npm run fuzz -- 50000 20001".',
  );
}
process.exitCode = await (values.browser ? fuzzInBrowser() : fuzzInNode());

async function fuzzInNode() {
  const { status } = spawnSync('npx', ['vitest', 'run', 'tests/unit/tools/fuzz'], {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, FUZZ_CASES: String(count), FUZZ_FIRST: String(first) },
  });
  const report = ['files', 'library', 'drawings', 'scans'].map((name) =>
    JSON.parse(readFileSync(`${output}/${name}.json`, 'utf8')),
  );
  console.table(
    Object.fromEntries(
      Object.entries(Object.assign({}, ...report)).map(([kind, { slowest, ...sums }]) => [
        kind,
        { ...sums, 'slowest, ms': slowest.milliseconds, 'its seed': slowest.seed },
      ]),
    ),
  );
  return status ?? 1;
}

async function fuzzInBrowser() {
  const { chromium } = await import('@playwright/test');
  const { createServer } = await import('vite');
  const { launchOptions } = await import('../browser/launchOptions.mjs');
  const { serveBuilt } = await import('../browser/serveBuilt.mjs');
  const site = await serveBuilt(root, `${output}/site`);
  const modules = await createServer({ root, mode: 'test', logLevel: 'error', server: { middlewareMode: true } });
  const browser = await chromium.launch(await launchOptions());
  try {
    const { fuzzBrowser } = await modules.ssrLoadModule('/tools/fuzz/fuzzBrowser.ts');
    const { address } = site;
    const { report, failures } = await fuzzBrowser(browser, {
      address,
      count,
      first,
      say: (line) => console.log(line),
    });
    mkdirSync(output, { recursive: true });
    writeFileSync(`${output}/browser.json`, `${JSON.stringify(report, undefined, 2)}\n`);
    console.table(report);
    console.log(failures.length === 0 ? 'Nothing went wrong.' : `${failures.length} failures.`);
    return failures.length === 0 ? 0 : 1;
  } finally {
    await browser.close();
    await site.close();
    await modules.close();
  }
}
