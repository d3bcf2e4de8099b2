import { expect, test } from 'vitest';
import { layerTimes } from '../layerTimes.mjs';

const run = (projectName: string, seconds: number, status = 'expected') => ({
  projectName,
  status,
  results: [{ duration: seconds * 1000 }],
});

test('sums the times of browser tests by layer, in suites within suites, and leaves out what was skipped', () => {
  const report = {
    suites: [
      { specs: [{ tests: [run('gpu', 1)] }, { tests: [run('gpu', 2), run('gpu', 9, 'skipped')] }] },
      { suites: [{ specs: [{ tests: [run('e2e', 4), run('gpu', 0.5)] }] }] },
    ],
  };
  const unit = { numPassedTests: 5, numFailedTests: 1 };
  const runs = [
    { name: 'vitest', report: unit, seconds: 7 },
    { name: 'playwright', report, seconds: 5 },
  ];
  expect(layerTimes(runs)).toEqual([
    { layer: 'unit', tests: 6, seconds: 7 },
    { layer: 'e2e', tests: 1, seconds: 4 },
    { layer: 'gpu', tests: 3, seconds: 3.5 },
  ]);
});

test('has nothing to say of a runner that left no report', () => {
  expect(layerTimes([{ name: 'playwright', report: undefined, seconds: 3 }])).toEqual([]);
});
