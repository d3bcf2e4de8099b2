/**
 * `npm run bench`: runs bench/*.bench.* one after the other, each in a process of its own, prints a table of each and writes
 * all of it to tests/output/bench.json. `npm run bench -- bake frame` runs some of them; `--rasteriser=llvmpipe` draws frames
 * with Mesa's llvmpipe instead of SwiftShader.
 *
 * A benchmark is a module with `name` and `run(): Promise<Record<string, Record<string, number | string>>>`: rows of figures.
 */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));
const output = join(root, 'tests/output/bench');
const words = process.argv.slice(2);
const rasteriser = words.find((word) => word.startsWith('--rasteriser='))?.split('=')[1];
const names = words.filter((word) => !word.startsWith('--'));
if (rasteriser) process.env.HATCH_RASTERISER = rasteriser;

const files = readdirSync(join(root, 'bench'))
  .filter((file) => /\.bench\.(ts|mjs)$/.test(file))
  .filter((file) => names.length === 0 || names.some((name) => file.startsWith(`${name}.`)))
  .sort();
if (files.length === 0) throw new Error(`bench/run.mjs: no benchmark is called ${names.join(' or ')}.`);

mkdirSync(output, { recursive: true });
const results = {};
for (const file of files) {
  const { name, rows } = measure(file.endsWith('.ts') ? await bundle(file) : join(root, 'bench', file));
  console.log(`\n${name}\n${table(rows)}`);
  results[name] = rows;
}
const report = { node: process.version, cpu: cpus()[0]?.model, cores: cpus().length, results };
writeFileSync(join(root, 'tests/output/bench.json'), `${JSON.stringify(report, null, 2)}\n`);

/** TypeScript as one plain file, so that what is measured is what a bundler makes of it. */
async function bundle(file) {
  await build({
    configFile: false,
    root,
    logLevel: 'error',
    build: { ssr: join('bench', file), outDir: output, emptyOutDir: false, target: 'es2022', minify: false },
  });
  return join(output, file.replace(/\.ts$/, '.js'));
}

/** A process of its own for each: what one benchmark leaves in the heap or teaches the compiler is no other's affair. */
function measure(module) {
  const result = join(output, 'result.json');
  rmSync(result, { force: true });
  const script = `
    const { name, run } = await import(${JSON.stringify(pathToFileURL(module).href)});
    const { writeFileSync } = await import('node:fs');
    writeFileSync(${JSON.stringify(result)}, JSON.stringify({ name, rows: await run() }));`;
  execFileSync(process.execPath, ['--input-type=module', '--eval', script], {
    cwd: root,
    stdio: ['ignore', 'inherit', 'inherit'],
  });
  return JSON.parse(readFileSync(result, 'utf8'));
}

function table(rows) {
  const columns = [...new Set(Object.values(rows).flatMap((row) => Object.keys(row)))];
  const lines = [['', ...columns]];
  for (const [key, row] of Object.entries(rows)) lines.push([key, ...columns.map((column) => `${row[column] ?? ''}`)]);
  const widths = lines[0].map((_, i) => Math.max(...lines.map((line) => line[i].length)));
  return lines
    .map((line) => line.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '))
    .join('\n');
}
