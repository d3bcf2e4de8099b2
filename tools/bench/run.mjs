/**
 * `npm run bench`: runs every benchmark, those that draw once per rasteriser, each in a browser of its own; prints tables,
 * keeps the figures in tools/bench/results and writes docs/research/benchmarks.md from them.
 *
 * `npm run bench -- bake frame` runs some of them, `--rasteriser=llvmpipe` draws with one rasteriser alone. `--quick` runs a
 * small version of everything, in one browser, and writes to tests/output/bench.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { benchmarks } from './benchmarks.mjs';
import { describeBenchmarks } from './describeBenchmarks.mjs';
import { describeEnvironment } from './describeEnvironment.mjs';
import { openBrowser } from './openBrowser.mjs';

const { values, positionals } = parseArgs({
  options: { quick: { type: 'boolean' }, rasteriser: { type: 'string' } },
  allowPositionals: true,
});
const unknown = positionals.find((word) => !benchmarks.some(({ name }) => name === word));
if (unknown) {
  const known = benchmarks.map(({ name }) => name).join(', ');
  throw new Error(`tools/bench/run.mjs: no benchmark is called ${unknown}; there are ${known}.`);
}
const rasterisers = values.rasteriser ? [values.rasteriser] : ['swiftshader', 'llvmpipe'];
const folder = fileURLToPath(new URL(values.quick ? '../../tests/output/bench/' : './results/', import.meta.url));
mkdirSync(folder, { recursive: true });

// With --quick the numbers are discarded, so one browser serves all benchmarks. Otherwise each has a new one.
const shared = new Map();
const open = async (rasteriser) => ({
  environment: await describeEnvironment(),
  browser: await openBrowser(rasteriser),
});

try {
  for (const benchmark of benchmarks) {
    if (positionals.length > 0 && !positionals.includes(benchmark.name)) continue;
    for (const rasteriser of benchmark.perRasteriser ? rasterisers : rasterisers.slice(0, 1)) {
      process.env.HATCH_RASTERISER = rasteriser;
      const start = performance.now();
      const opened = shared.get(rasteriser) ?? (await open(rasteriser));
      if (values.quick) shared.set(rasteriser, opened);
      const { environment, browser } = opened;
      try {
        const result = await benchmark.run(browser, values.quick);
        const seconds = Math.round((performance.now() - start) / 1000);
        const name = benchmark.perRasteriser ? `${benchmark.name}.${rasteriser}` : benchmark.name;
        writeFileSync(`${folder}${name}.json`, `${JSON.stringify({ environment, seconds, result }, rounded, 2)}\n`);
        console.log(`\n${name}, ${seconds} s, ${environment.renderer}\n\n${benchmark.describe(result)}`);
      } finally {
        if (!values.quick) await browser.close();
      }
    }
  }
} finally {
  for (const { browser } of shared.values()) await browser.close();
}
if (!values.quick) describeBenchmarks();

/** Rounds numbers to five digits; more are noise. */
function rounded(_, value) {
  return typeof value === 'number' ? Number(value.toPrecision(5)) : value;
}
