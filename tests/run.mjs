/**
 * `npm test`: a selection of every layer. `npm run test:all`: every test but those of `three-middle`. `npm run test:rest`: what `npm test` leaves
 * out. Each ends with what every layer took, and one plain last line, `N passed, N failed`.
 *
 * The first word is the selection (see selection.mjs). Names of layers (unit, gpu, three-oldest, three-middle, visual, e2e, consumers, webgpu) run
 * these alone; any other word goes to the runners as a filter of file names. The numbers are summed from the runners' own JSON reports; a runner
 * that crashes, leaves no report or finds no test at all counts as a failure.
 */
import { spawn } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findChromium } from '../tools/browser/findChromium.mjs';
import { layerTimes } from './layerTimes.mjs';
import { PLAYWRIGHT, VITEST } from './runners.mjs';
import { argumentsOf, readSelection } from './selection.mjs';
import { summariseReports } from './summariseReports.mjs';
import { leftOut } from './timeLimit.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
const output = join(root, 'tests', 'output');

const [chosenSelection, ...words] = process.argv.slice(2);
const selection = readSelection(chosenSelection);
// The tests themselves ask it how many cases to try.
process.env.HATCH_TESTS = selection;

const browserLayers = ['gpu', 'three-oldest', 'three-middle', 'visual', 'e2e', 'consumers', 'webgpu'];
/** Runs only where it is named: it repeats the tests of `three-oldest`. */
const onRequest = ['three-middle'];
const layers = words.filter((word) => ['unit', ...browserLayers].includes(word));
const filters = words.filter((word) => !layers.includes(word));
const chosen = (names) =>
  names.filter((name) => (layers.length === 0 ? !onRequest.includes(name) : layers.includes(name)));

const runners = [];
if (chosen(['unit']).length > 0) {
  const report = join(output, 'vitest.json');
  runners.push({
    name: 'vitest',
    report,
    args: [VITEST, 'run', '--reporter=default', '--reporter=json', '--passWithNoTests'],
    rest: [`--outputFile.json=${report}`, ...argumentsOf('vitest', selection), ...filters, ...taggedFiles()],
  });
}
if (chosen(browserLayers).length > 0) {
  runners.push({
    name: 'playwright',
    report: join(output, 'playwright.json'),
    args: [PLAYWRIGHT, 'test', '--pass-with-no-tests'],
    rest: [
      ...chosen(browserLayers).map((project) => `--project=${project}`),
      ...argumentsOf('playwright', selection),
      ...filters,
    ],
  });
}

mkdirSync(output, { recursive: true });
for (const { report } of runners) rmSync(report, { force: true });

const finished = [];
try {
  if (runners.some(({ name }) => name === 'playwright')) {
    const { executablePath, route, version } = await findChromium();
    process.env.HATCH_CHROMIUM = executablePath;
    console.log(`Browser: ${version}, ${executablePath} (${route})`);
  }
  for (const { name, report, args, rest } of runners) {
    const begin = performance.now();
    const exitCode = await run(process.execPath, [...args, ...rest]);
    finished.push({ name, exitCode, report: readReport(report), seconds: (performance.now() - begin) / 1000 });
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  finished.push({ name: 'The search for a browser', exitCode: 1, report: undefined, seconds: 0 });
}

// A filter of files, or the selection `rest`, may leave a runner without any test.
const filtered = filters.length > 0 || selection === 'rest';
const { passed, failed, skipped, remarks } = summariseReports(finished, { filtered });
const times = layerTimes(finished);
for (const { layer, tests, seconds } of times) console.log(`${layer}: ${tests} tests, ${Math.round(seconds)} s`);
console.log(`On the clock: ${Math.round(performance.now() / 1000)} s`);
// Whole runs are what the table in CONTRIBUTING.md is written from.
if (words.length === 0) {
  mkdirSync(join(output, 'times'), { recursive: true });
  const text = JSON.stringify({ seconds: performance.now() / 1000, layers: times });
  writeFileSync(join(output, 'times', `${selection}.json`), text);
}
for (const remark of remarks) console.error(remark);
process.exitCode = failed > 0 ? 1 : 0;
const late = finished.reduce((sum, { name, report }) => sum + (name === 'playwright' ? leftOut(report) : 0), 0);
if (late > 0) console.log(`${late} tests were not begun, since the time of this run was up (HATCH_UNTIL)`);
if (skipped > 0) console.log(`${skipped} skipped`);
console.log(`${passed} passed, ${failed} failed`);

function run(command, args) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: root, stdio: ['ignore', 'inherit', 'inherit'] });
    child.on('error', reject);
    child.on('close', (code, signal) => resolve(signal ? 1 : code));
  });
}

/** The files of unit tests with tags, for a selection that takes no others: loading a file takes longer than skipping its tests. */
function taggedFiles() {
  if (selection !== 'rest' || filters.length > 0) return [];
  return readdirSync(join(root, 'tests', 'unit'), { recursive: true })
    .filter((name) => name.endsWith('.test.ts'))
    .map((name) => join('tests', 'unit', name))
    .filter((path) => /\btags: \[/.test(readFileSync(join(root, path), 'utf8')));
}

/** @returns {unknown} the report, or undefined where the runner left none that can be read. */
function readReport(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return undefined;
  }
}
