/**
 * `npm run instructions`: counts the instructions of the fragment shader of every look as `applyHatching` makes it, as multiples of three's
 * Phong: all that are compiled, and those that run on average over the picture. Keeps the figures in tools/instructions/results.json and writes their
 * part of docs/research/gpu-cost.md.
 *
 * `npm run instructions -- pen engraving` prints some looks, `--branches` also how often each of their branches runs, `--shadow` looks in their own
 * shadow, and `--model=dragon11k --size=1024` another picture; these write nothing.
 *
 * HATCH_MESA names the folder of compilers that tools/instructions/compilers/build.sh has built.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { describeEnvironment } from '../bench/describeEnvironment.mjs';
import { launchOptions } from '../browser/launchOptions.mjs';
import { CHIPS, compile } from './compilers/compile.mjs';
import { describeInstructions, withInstructions } from './describeInstructions.mjs';
import { executed } from './executed.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const { values, positionals } = parseArgs({
  options: {
    branches: { type: 'boolean', default: false },
    shadow: { type: 'boolean', default: false },
    model: { type: 'string' },
    size: { type: 'string' },
  },
  allowPositionals: true,
});
const folder = process.env.HATCH_MESA;
if (!folder)
  throw new Error(
    'tools/instructions/run.mjs: set HATCH_MESA to a folder that tools/instructions/compilers/build.sh has built.',
  );
const { model = 'dragon202k', size = '512' } = values;
const isWhole = positionals.length === 0 && !values.shadow && !values.model && !values.size;

const server = await createServer({
  root,
  mode: 'test',
  logLevel: 'error',
  server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
});
await server.listen();
const browser = await chromium.launch(await launchOptions('swiftshader'));
const cases = {};
try {
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.error(error));
  page.on('console', (message) => message.type() === 'error' && console.error(message.text()));
  page.setDefaultTimeout(0);
  await page.goto(`${server.resolvedUrls.local[0]}tools/instructions/instructions.html`);
  await page.waitForFunction(() => typeof window.findCase === 'function');
  const looks = ['phong', ...(positionals.length > 0 ? positionals : await page.evaluate(() => window.lookNames()))];
  for (const look of looks) {
    const wanted = { look, isInShadow: values.shadow, model, size: Number(size) };
    const found = await page.evaluate((wanted) => window.findCase(wanted), wanted);
    cases[look] = countOf(found);
    if (values.branches) printBranches(look, found);
    console.error(look);
  }
} finally {
  await browser.close();
  await server.close();
}

const { commit } = await describeEnvironment();
const results = { commit, date: new Date().toISOString().slice(0, 10), model, size: Number(size), cases };
console.log(describeInstructions(results));
if (isWhole) {
  writeFileSync(new URL('results.json', import.meta.url), `${JSON.stringify(results, rounded, 2)}\n`);
  const document = `${root}docs/research/gpu-cost.md`;
  writeFileSync(document, withInstructions(readFileSync(document, 'utf8'), results));
}

/** Counts on every chip: per 16 pixels on Intel, of a group of pixels on AMD. */
function countOf({ vertex, fragment, traced, branches, runs }) {
  const bits = branches.map((branch) => branch.bits);
  return Object.fromEntries(
    Object.keys(CHIPS).map((chip) => {
      const plain = compile(folder, chip, { vertex, fragment });
      const marked = compile(folder, chip, { vertex, fragment: traced }, bits);
      const block = CHIPS[chip].blocks[marked.width];
      const { means } = runs.find((found) => String(found.block) === String(block));
      const times = new Map(bits.map((number, branch) => [number, means[branch]]));
      // What marks cost beside themselves, such as copies of their sum, is not the shader's.
      const overhead = busiest(executed(plain), plain.width) / busiest(executed(marked), marked.width);
      return [
        chip,
        {
          compiled: busiest(executed(plain), plain.width),
          executed: overhead * busiest(executed(marked, times), marked.width),
          width: plain.width,
          registers: plain.registers,
        },
      ];
    }),
  );
}

/** The clocks of the busier pipe for 16 pixels on Intel; AMD has one count, whatever the width. */
function busiest({ cost, math }, width) {
  return math > 0 ? (Math.max(cost, math) * 16) / width : cost;
}

function printBranches(look, { branches, runs }) {
  const ofPixels = runs.find(({ block }) => String(block) === '1,1').means;
  const rows = branches.flatMap(({ name }, i) => (ofPixels[i] > 0 ? [`  ${ofPixels[i].toFixed(3)}  ${name}`] : []));
  console.log(`${look}: runs a pixel\n${rows.join('\n')}\n`);
}

function rounded(_, value) {
  return typeof value === 'number' ? Number(value.toPrecision(5)) : value;
}
