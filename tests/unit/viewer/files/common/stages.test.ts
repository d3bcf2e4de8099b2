import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { reportStage, runStage } from '../../../../../src/viewer/files/common/stages.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('a step is reported at once, and how far it is twice a second at most', () => {
  const said: string[] = [];
  const onProgress = reportStage('sorting', (stage) => void said.push(stage));
  for (let i = 1; i <= 15; i++) {
    vi.advanceTimersByTime(100);
    onProgress(i / 16);
  }
  expect(said).toEqual(['sorting', 'sorting: 31 %', 'sorting: 62 %', 'sorting: 93 %']);
});

test('a long task is reported while it runs, and its result returned', () => {
  const said: string[] = [];
  function* task(): Generator<number, string, void> {
    for (let i = 0; i < 4; i++) {
      vi.advanceTimersByTime(600);
      yield i / 4;
    }
    return 'sorted';
  }
  expect(runStage('sorting', (stage) => void said.push(stage), task())).toBe('sorted');
  expect(said).toEqual(['sorting', 'sorting: 0 %', 'sorting: 25 %', 'sorting: 50 %', 'sorting: 75 %']);
});
