/**
 * What the layers of tests took.
 *
 * @typedef {{ layer: string, tests: number, seconds: number }} LayerTime - of `unit` the time on the clock; of a layer of browser tests the sum of
 *   its tests' times, which run two at a time
 *
 * @param {{ name: string, report: any, seconds: number }[]} runs - the runners that ended, with the JSON report each wrote
 * @returns {LayerTime[]} in the order of the runners, the slowest layer of browser tests first
 */
export function layerTimes(runs) {
  return runs.flatMap(({ name, report, seconds }) => {
    if (!report) return [];
    if (name === 'vitest') return [{ layer: 'unit', tests: report.numPassedTests + report.numFailedTests, seconds }];
    return browserLayers(report);
  });
}

/** @returns {LayerTime[]} */
function browserLayers(report) {
  /** @type {Map<string, LayerTime>} */
  const layers = new Map();
  const visit = ({ specs = [], suites = [] }) => {
    for (const { projectName, results, status } of specs.flatMap(({ tests }) => tests)) {
      if (status === 'skipped') continue;
      const layer = layers.get(projectName) ?? { layer: projectName, tests: 0, seconds: 0 };
      layers.set(projectName, layer);
      layer.tests += 1;
      for (const { duration } of results) layer.seconds += duration / 1000;
    }
    suites.forEach(visit);
  };
  visit(report);
  return [...layers.values()].sort((a, b) => b.seconds - a.seconds);
}
