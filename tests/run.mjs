/**
 * `npm test`: every test there is but those of `three-middle`, and one plain last line, `N passed, N failed`.
 *
 * `npm test -- unit` runs one layer (unit, gpu, three-oldest, visual, e2e, consumers, webgpu), `npm test -- gpu visual` several, and any other
 * word goes to the runners as a filter of file names. `npm test -- three-middle` repeats what `three-oldest` runs with a version in between. The
 * numbers are summed from the runners' own JSON reports; a runner that crashes, leaves no report or finds no test at all counts as a failure.
 */
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findChromium } from '../tools/browser/findChromium.mjs';
import { summariseReports } from './summariseReports.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
const output = join(root, 'tests', 'output');
const require = createRequire(import.meta.url);
/** A package's command line program, run by this same Node. */
const program = (name, file) => join(dirname(require.resolve(`${name}/package.json`)), file);

const words = process.argv.slice(2);
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
    args: [program('vitest', 'vitest.mjs'), 'run', '--reporter=default', '--reporter=json', '--passWithNoTests'],
    rest: [`--outputFile.json=${report}`, ...filters],
  });
}
if (chosen(browserLayers).length > 0) {
  runners.push({
    name: 'playwright',
    report: join(output, 'playwright.json'),
    args: [program('@playwright/test', 'cli.js'), 'test', '--pass-with-no-tests'],
    rest: [...chosen(browserLayers).map((project) => `--project=${project}`), ...filters],
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
    const exitCode = await run(process.execPath, [...args, ...rest]);
    finished.push({ name, exitCode, report: readReport(report) });
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  finished.push({ name: 'The search for a browser', exitCode: 1, report: undefined });
}

const { passed, failed, skipped, remarks } = summariseReports(finished, { filtered: filters.length > 0 });
for (const remark of remarks) console.error(remark);
process.exitCode = failed > 0 ? 1 : 0;
if (skipped > 0) console.log(`${skipped} skipped`);
console.log(`${passed} passed, ${failed} failed`);

function run(command, args) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: root, stdio: ['ignore', 'inherit', 'inherit'] });
    child.on('error', reject);
    child.on('close', (code, signal) => resolve(signal ? 1 : code));
  });
}

/** @returns {unknown} the report, or undefined where the runner left none that can be read. */
function readReport(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return undefined;
  }
}
