/**
 * `npm run support`: measures every feature with every technique, and scenes of nodes beside GLSL, and writes the tables in docs/support.md.
 * `npm run support -- nodes`: scenes of nodes alone.
 */
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const playwright = join(dirname(createRequire(import.meta.url).resolve('@playwright/test/package.json')), 'cli.js');
const run = (...args) =>
  spawnSync(process.execPath, [playwright, 'test', ...args], {
    stdio: 'inherit',
    env: { ...process.env, UPDATE_SUPPORT: '1' },
  }).status ?? 1;

const isWhole = process.argv[2] !== 'nodes';
process.exitCode =
  (isWhole && run('--project=gpu', 'besideLambert')) ||
  run('--project=webgpu', '--grep=nodes draw what GLSL draws') ||
  writeNodes();

/** Writes the table of nodes from what the tests have noted. */
function writeNodes() {
  const BEGIN = '<!-- Nodes: written by npm run support -->\n';
  const END = '<!-- End of nodes -->';
  const suites = JSON.parse(readFileSync('tests/output/playwright.json', 'utf8')).suites;
  const rows = new Map();
  for (const { title, tests } of suites.flatMap(specsIn)) {
    const [, group, drawn] = /^(\w+): nodes draw what GLSL draws, (\w+)$/.exec(title) ?? [];
    if (!drawn || group === 'three') continue;
    for (const { type, description } of tests[0].annotations.filter(({ description = '' }) =>
      description.includes('% of pixels'),
    )) {
      const name = `${group} | ${type}`;
      const row = rows.get(name) ?? {};
      row[drawn] = description.slice(0, description.indexOf(' of pixels'));
      rows.set(name, row);
    }
  }
  const lines = [...rows].map(([name, { forceWebGL, webgpu = '–' }]) => `| ${name} | ${forceWebGL} | ${webgpu} |\n`);
  const table = `\n| group | scene | \`forceWebGL\` | WebGPU |\n| --- | --- | ---: | ---: |\n${lines.join('')}\n`;
  const text = readFileSync('docs/support.md', 'utf8');
  const [before, rest] = text.split(BEGIN);
  writeFileSync('docs/support.md', `${before}${BEGIN}${table}${END}${rest.split(END)[1]}`);
  return 0;
}

function specsIn({ specs = [], suites = [] }) {
  return [...specs, ...suites.flatMap(specsIn)];
}
