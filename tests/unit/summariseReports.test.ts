import { describe, expect, test } from 'vitest';
import { summariseReports } from '../summariseReports.mjs';

const vitest = (numPassedTests: number, numFailedTests = 0, emptyFailedFiles = 0) => ({
  numPassedTests,
  numFailedTests,
  numPendingTests: 0,
  numTodoTests: 0,
  testResults: Array.from({ length: emptyFailedFiles }, () => ({ status: 'failed', assertionResults: [] })),
});
const playwright = (expected: number, unexpected = 0, skipped = 0, errors: unknown[] = []) => ({
  stats: { expected, unexpected, skipped },
  errors,
});
const summarise = (name: string, report: unknown, exitCode = 0, filtered = false) => {
  const { passed, failed, skipped } = summariseReports([{ name, exitCode, report }], { filtered });
  return { passed, failed, skipped };
};

describe('summariseReports', () => {
  test.each([
    ['all passed', 'vitest', vitest(3), 0, { passed: 3, failed: 0, skipped: 0 }],
    ['one failed', 'vitest', vitest(3, 1), 1, { passed: 3, failed: 1, skipped: 0 }],
    ['a file that cannot be loaded', 'vitest', vitest(3, 0, 1), 1, { passed: 3, failed: 1, skipped: 0 }],
    ['green, but a bad end', 'vitest', vitest(3), 1, { passed: 3, failed: 1, skipped: 0 }],
    ['no report', 'vitest', undefined, 1, { passed: 0, failed: 1, skipped: 0 }],
    ['no report and a good end', 'playwright', undefined, 0, { passed: 0, failed: 1, skipped: 0 }],
    ['an unknown runner', 'browser', undefined, 1, { passed: 0, failed: 1, skipped: 0 }],
    ['one failed on a page', 'playwright', playwright(3, 1, 2), 1, { passed: 3, failed: 1, skipped: 2 }],
    ['errors outside of tests', 'playwright', playwright(0, 0, 0, ['no']), 1, { passed: 0, failed: 1, skipped: 0 }],
    ['only skipped', 'playwright', playwright(0, 0, 4), 0, { passed: 0, failed: 1, skipped: 4 }],
  ])('%s', (_, name, report, exitCode, expected) => {
    expect(summarise(name, report, exitCode)).toEqual(expected);
  });

  test('a runner without tests is a failure, unless a filter was given and the other one has some', () => {
    const runs = [
      { name: 'vitest', exitCode: 0, report: vitest(2) },
      { name: 'playwright', exitCode: 0, report: playwright(0) },
    ];
    expect(summariseReports(runs, { filtered: false }).failed).toBe(1);
    expect(summariseReports(runs, { filtered: true }).failed).toBe(0);
    expect(summarise('vitest', vitest(0), 0, true).failed).toBe(1);
  });
});
