/**
 * What every layer of tests took, as lines of text: the wall time of a runner, and of each layer of browser tests the sum of its tests' times,
 * which run two at a time.
 *
 * @param {{ name: string, report: any, seconds: number }[]} runs - the runners that ended, with the JSON report each wrote
 * @returns {string[]}
 */
export function describeLayers(runs) {
  return runs.flatMap(({ name, report, seconds }) => {
    const lines = [`${name}: ${Math.round(seconds)} s`];
    if (name !== 'playwright' || !report) return lines;
    for (const [layer, { tests, sum }] of sumsByProject(report)) {
      lines.push(`  ${layer}: ${tests} tests, ${Math.round(sum)} s in all`);
    }
    return lines;
  });
}

/** The number of tests of each project in a report of Playwright's, and the sum of their times in seconds; the slowest layer first. */
export function sumsByProject(report) {
  /** @type {Map<string, { tests: number, sum: number }>} */
  const sums = new Map();
  const visit = ({ specs = [], suites = [] }) => {
    for (const { tests } of specs) {
      for (const { projectName, results, status } of tests) {
        if (status === 'skipped') continue;
        const entry = sums.get(projectName) ?? { tests: 0, sum: 0 };
        entry.tests += 1;
        for (const { duration } of results) entry.sum += duration / 1000;
        sums.set(projectName, entry);
      }
    }
    suites.forEach(visit);
  };
  visit(report);
  return [...sums].sort(([, a], [, b]) => b.sum - a.sum);
}
