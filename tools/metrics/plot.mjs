import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const others = join(root, '../shared/models');

/** Files of the examples, and of other people if they lie beside the repository. */
const FILES = {
  fish: [join(root, 'examples/models'), 'fish.glb'],
  stillLife: [join(root, 'examples/models'), 'still-life.glb'],
  spot: [others, 'spot.obj'],
  nefertiti: [others, 'nefertiti_lowres.obj'],
  hand: [others, 'hand_lowres.obj'],
  Fox: [others, 'Fox.glb'],
  CesiumMan: [others, 'CesiumMan.glb'],
};

const percent = (share) => `${(100 * share).toFixed(1)} %`;

/**
 * Measures drawings for one pen, and prints a table. No browser is needed.
 *
 * @param server a Vite server, which loads the modules
 * @param names of models, and a preset; all in `engraving` if empty
 */
export async function printPlot(server, names) {
  const { measurePlot } = await server.ssrLoadModule('/tools/metrics/measurePlot.ts');
  const { plotModels } = await server.ssrLoadModule('/tools/metrics/plotModels.ts');
  const { presets } = await server.ssrLoadModule('/src/index.ts');
  const preset = names.find((name) => name in presets) ?? 'engraving';
  const wanted = names.filter((name) => name !== preset);
  const sources = { ...plotModels() };
  for (const [name, [folder, file]] of Object.entries(FILES)) {
    if (existsSync(join(folder, file))) sources[name] = { file, content: async () => readFileSync(join(folder, file)) };
    else console.log(`${name}: skipped, ${file} is not there`);
  }
  const heads = ['model', 'lines', 'uneven', 'p75', 'uneven 2', 'p75 2', 'tone off', 'bias', 'lifts', 'under 1.5 mm'];
  console.log(`| ${[...heads, 'median mm', '3 passes', 'ink m', 'times'].join(' | ')} |`);
  console.log(`| --- | --- |${' ---: |'.repeat(12)}`);
  for (const [name, { file, content }] of Object.entries(sources)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const source = { name, file, content: await content(), preset };
    const rows = await measurePlot(source, join(root, 'tests/output/plot'));
    const before = rows.find(({ lines }) => lines === 'canvas').seconds;
    for (const row of rows) {
      const families = [0, 1].flatMap((k) => {
        const family = row.families[k];
        return family ? [percent(family.uneven), family.p75.toFixed(2)] : ['', ''];
      });
      const tone = [row.toneError.toFixed(3), row.toneBias.toFixed(3)];
      const strokes = [row.lifts, percent(row.short), row.median.toFixed(1), percent(row.soaked), row.ink.toFixed(2)];
      console.log(
        `| ${[name, row.lines, ...families, ...tone, ...strokes, (row.seconds / before).toFixed(1)].join(' | ')} |`,
      );
    }
  }
}
