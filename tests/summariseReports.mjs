/**
 * Sums what the runners say of themselves.
 *
 * @param {{ name: string, exitCode: number, report: any }[]} runs - one per runner, with the JSON report it wrote.
 * @param {{ filtered: boolean }} options - whether a filter was given; then one of several runners may find nothing.
 * @returns {{ passed: number, failed: number, skipped: number, remarks: string[] }} `failed` counts at least one for every
 *   runner that ended badly, even if its report is all green.
 */
export function summariseReports(runs, { filtered }) {
  const total = { passed: 0, failed: 0, skipped: 0, remarks: /** @type {string[]} */ ([]) };
  const fail = (remark) => {
    total.failed += 1;
    total.remarks.push(remark);
  };
  for (const { name, exitCode, report } of runs) {
    const counts = readers[name]?.(report);
    if (!counts) {
      fail(`${name} ended with code ${exitCode} and left no report.`);
      continue;
    }
    total.passed += counts.passed;
    total.failed += counts.failed;
    total.skipped += counts.skipped;
    if (exitCode !== 0 && counts.failed === 0) fail(`${name} ended with code ${exitCode} although no test failed.`);
    if (counts.passed + counts.failed + counts.skipped === 0 && !filtered && exitCode === 0)
      fail(`${name} ran no test.`);
  }
  if (total.passed + total.failed === 0) fail('No test ran.');
  return total;
}

const readers = {
  vitest: (report) =>
    report && {
      passed: report.numPassedTests,
      // A file that cannot be loaded has no tests to count, but is a failure all the same.
      failed:
        report.numFailedTests +
        report.testResults.filter(
          ({ status, assertionResults }) => status === 'failed' && assertionResults.length === 0,
        ).length,
      skipped: report.numPendingTests + report.numTodoTests,
    },
  playwright: (report) =>
    report && {
      // Errors outside of tests stop the run.
      passed: report.stats.expected,
      failed: report.stats.unexpected + report.errors.length,
      skipped: report.stats.skipped,
    },
};
