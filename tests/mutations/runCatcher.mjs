import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PLAYWRIGHT, VITEST } from '../runners.mjs';
import { argumentsOf } from '../selection.mjs';
import { titlePattern } from './titleParts.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const output = join(root, 'tests', 'output', 'mutations');
const report = join(output, 'report.json');

/** Many times what the slowest single test takes: a break may keep a loop from ending. */
const LIMIT = 15 * 60_000;

/** The runner that is at work. */
let running;

/** Ends the runner that is at work, with what it has started. */
export function stopCatcher() {
  try {
    if (running?.pid) process.kill(-running.pid, 'SIGTERM');
  } catch {
    // The process has ended already.
  }
}

/**
 * Runs the test that a break must fail.
 *
 * @param {import('./Mutation.js').Mutation['caughtBy']} caughtBy
 * @param {import('../selection.mjs').Selection} selection
 * @returns {Promise<{ tried: number, failed: number, complaint: string }>} how many tests were tried and failed; the complaint says why none
 *   could be tried, and is empty where there is none in the selection
 */
export async function runCatcher({ layer, file, title }, selection) {
  mkdirSync(output, { recursive: true });
  rmSync(report, { force: true });
  const pattern = titlePattern(title);
  const printed =
    layer === 'unit'
      ? await run([
          ...[VITEST, 'run', '--reporter=json', `--outputFile.json=${report}`],
          ...['--passWithNoTests', ...argumentsOf('vitest', selection), ...(pattern ? ['-t', pattern] : []), file],
        ])
      : await run(
          [
            ...[PLAYWRIGHT, 'test', `--project=${layer}`, '--reporter=json'],
            ...['--pass-with-no-tests', ...argumentsOf('playwright', selection), ...(pattern ? ['-g', pattern] : [])],
            file,
          ],
          { PLAYWRIGHT_JSON_OUTPUT_FILE: report },
        );
  const found = readReport();
  if (!found) return { tried: 0, failed: 0, complaint: printed.trim().split('\n').slice(-5).join('\n') || 'no report' };
  return layer === 'unit' ? countVitest(found) : countPlaywright(found);

  function run(args, env = {}) {
    const variables = { ...process.env, ...env, HATCH_TESTS: selection };
    return new Promise((resolve, reject) => {
      // A group of its own: whatever a runner has started ends with it.
      running = spawn(process.execPath, args, { cwd: root, env: variables, detached: true });
      const limit = setTimeout(stopCatcher, LIMIT);
      let text = '';
      const keep = (part) => {
        text = (text + part).slice(-4000);
      };
      running.stdout.on('data', keep);
      running.stderr.on('data', keep);
      running.on('error', reject);
      running.on('close', () => {
        clearTimeout(limit);
        resolve(text);
      });
    });
  }
}

function readReport() {
  try {
    return JSON.parse(readFileSync(report, 'utf8'));
  } catch {
    return undefined;
  }
}

function countVitest({ testResults }) {
  const tests = testResults.flatMap(({ assertionResults }) => assertionResults);
  const failed = tests.filter(({ status }) => status === 'failed').length;
  const tried = failed + tests.filter(({ status }) => status === 'passed').length;
  const unloaded = testResults.filter(({ status, message }) => status === 'failed' && message);
  return { tried, failed, complaint: failed > 0 ? '' : unloaded.map(({ message }) => message).join('\n') };
}

function countPlaywright({ stats, errors }) {
  return {
    tried: stats.expected + stats.unexpected,
    failed: stats.unexpected,
    complaint: errors.map(({ message }) => message).join('\n'),
  };
}
