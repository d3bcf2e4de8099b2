/**
 * `npm run bench:compare -- OLD [NEW]`: builds the libraries of two commits (NEW is the working tree if not given) and
 * measures both in one page, in turn. Prints the ratios new/old with their 95 % intervals and writes them to
 * tests/output/bench/compare.json; ends with 1 if anything has become slower.
 *
 * `--models=dragon48k,torus500k`, `--turns=31`, `--rasteriser=llvmpipe`, `--looks` for frames of presets alone; `--quick` for a first look.
 * Only what the libraries export by their public names is used, so any two commits that have these can be compared.
 */
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { buildLibrary } from './compare/buildLibrary.mjs';
import { describeEnvironment } from './describeEnvironment.mjs';
import { openBrowser } from './openBrowser.mjs';
import { median, medianInterval, ratios, verdict } from './statistics.mjs';
import { figure, table, withInterval } from './table.mjs';

const TECHNIQUES = {
  corner: ['triangle', 'adjacency', 'hatching'],
  pull: ['triangle', 'adjacency', 'hatching'],
  indexed: ['hatching', 'engraving'],
};
/** Drawn as a scene: with outlines, shadows, occlusion and a ground that shows the shadow. */
const LOOKS = ['engraving', 'pen', 'stipple', 'charcoal'];
const MAPS = ['hatching', 'stippling'];

const { values, positionals } = parseArgs({
  options: {
    models: { type: 'string' },
    turns: { type: 'string' },
    rasteriser: { type: 'string' },
    looks: { type: 'boolean', default: false },
    quick: { type: 'boolean', default: false },
  },
  allowPositionals: true,
});
const [oldCommit, newCommit] = positionals;
if (!oldCommit)
  throw new Error('tools/bench/compare.mjs: name the commit to compare with: npm run bench:compare -- OLD [NEW].');
const models = values.models?.split(',') ?? (values.quick ? ['dragon11k'] : ['dragon11k', 'dragon202k', 'torus500k']);
const usual = values.quick ? { turns: 7, milliseconds: 0 } : { turns: 15, milliseconds: 12_000 };
const effort = values.turns ? { turns: Number(values.turns), milliseconds: 0 } : usual;
const size = values.quick ? 512 : 1024;
const rasterisers = values.rasteriser ? [values.rasteriser] : ['swiftshader', 'llvmpipe'];

const output = fileURLToPath(new URL('../../tests/output/bench/', import.meta.url));
console.log(`Building ${oldCommit} and ${newCommit ?? 'the working tree'} ...`);
buildLibrary(oldCommit, `${output}compare/old`);
buildLibrary(newCommit, `${output}compare/new`);

const rows = [];
for (const rasteriser of rasterisers) {
  process.env.HATCH_RASTERISER = rasteriser;
  const browser = await openBrowser(rasteriser);
  try {
    await compareAll(browser, rasteriser, await describeEnvironment());
  } finally {
    await browser.close();
  }
}
writeFileSync(`${output}compare.json`, `${JSON.stringify({ old: oldCommit, new: newCommit, rows }, null, 2)}\n`);
const slower = rows.filter((row) => row.verdict === 'slower');
console.log(`\n${rows.length} compared, ${slower.length} slower`);
process.exitCode = slower.length > 0 ? 1 : 0;

/** Frames with every rasteriser; what the processor does anyway with the first alone. */
async function compareAll({ measure }, rasteriser, { renderer }) {
  const first = rows.length;
  for (const model of models) {
    for (const [layout, techniques] of values.looks ? [] : Object.entries(TECHNIQUES)) {
      const times = await measure('comparedFrames', model, layout, techniques, effort, size);
      for (const technique of techniques) add(`${model}, ${technique} ${layout}`, times[technique]);
    }
    const looks = await measure('comparedLooks', model, LOOKS, effort, size);
    for (const look of LOOKS) add(`${model}, preset ${look}`, looks[look]);
  }
  if (rasteriser === rasterisers[0] && !values.looks) {
    for (const model of models) {
      for (const layout of Object.keys(TECHNIQUES)) {
        add(`${model}, prepared as ${layout}`, await measure('comparedBakes', model, layout, effort));
      }
    }
    const mapSize = values.quick ? 64 : 256;
    for (const style of MAPS) {
      add(`map ${style} ${mapSize}`, await measure('comparedMaps', { style, size: mapSize }, effort));
    }
  }
  const found = rows
    .slice(first)
    .map(({ name, ms, ratio, verdict }) => [name, ...ms.map(figure), withInterval(ratio), verdict]);
  console.log(`\n${renderer}\n\n${table([['', 'old, ms', 'new, ms', 'new/old', ''], ...found])}`);

  function add(name, times) {
    const ratio = medianInterval(ratios(times.new, times.old));
    rows.push({
      name,
      rasteriser,
      turns: times.old.length,
      ms: [median(times.old), median(times.new)],
      ratio,
      verdict: verdict(ratio),
    });
  }
}
