import { afterEach, expect, test, vi } from 'vitest';
import { isTimeUp, leftOut, TIME_IS_UP } from '../timeLimit.mjs';

afterEach(() => vi.unstubAllEnvs());

test.each([
  ['', false],
  [String(Date.now() - 1000), true],
  [String(Date.now() + 3_600_000), false],
])('with HATCH_UNTIL=%s the time is up: %s', (until, isUp) => {
  vi.stubEnv('HATCH_UNTIL', until);
  expect(isTimeUp()).toBe(isUp);
});

test('tests that were not begun are counted at every depth of a report', () => {
  const spec = (description: string) => ({ tests: [{ annotations: [{ type: 'skip', description }] }] });
  const inner = { specs: [spec(TIME_IS_UP), spec('There are no shared models here.')] };
  expect(leftOut({ suites: [{ specs: [spec(TIME_IS_UP)], suites: [inner] }] })).toBe(2);
  expect(leftOut(undefined)).toBe(0);
});
