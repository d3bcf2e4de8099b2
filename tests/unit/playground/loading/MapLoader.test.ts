import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { MapLoader } from '../../../../src/playground/loading/MapLoader.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('a map that is drawn after a pause is awaited until then, and drawn once however often it is asked for', () => {
  const run = vi.fn(async () => 'done');
  const nothing = (): void => {};
  const settings = { ...defaultSettings(), technique: 'hatching' as const };
  const maps = new MapLoader({} as never, settings, { run } as never, nothing, nothing, nothing);
  expect(maps.isAwaited).toBe(false);
  maps.showChosenAfter(150);
  vi.advanceTimersByTime(100);
  maps.showChosenAfter(150);
  vi.advanceTimersByTime(100);
  expect([maps.isAwaited, run.mock.calls.length]).toEqual([true, 0]);
  vi.advanceTimersByTime(50);
  expect([maps.isAwaited, run.mock.calls.length]).toEqual([false, 1]);
});
