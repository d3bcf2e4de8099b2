import { appendFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { type Expect, test } from '@playwright/test';

/** The matchers that compare a number with a limit. */
const MATCHERS = ['toBeLessThan', 'toBeLessThanOrEqual', 'toBeGreaterThan', 'toBeGreaterThanOrEqual', 'toBeCloseTo'];

/** One comparison of a number with its limit, as a line of the record. */
export interface LimitRecord {
  /** The project, the file and the titles of the test, and which of its comparisons it is. */
  key: string;
  matcher: string;
  value: number;
  limit: number;
  /** Number of decimals that must agree, for `toBeCloseTo`. */
  digits?: number;
}

/**
 * Playwright's `expect` that also writes every number that is compared with a limit into tests/output/limits, if the environment variable
 * HATCH_LIMITS names a record. `npm run test:limits` sets two records side by side, of two browsers for instance.
 */
export function recordLimits(expect: Expect, record: string | undefined): Expect {
  if (!record) return expect;
  const folder = join(import.meta.dirname, '../output/limits', record);
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `${process.pid}.jsonl`);
  const counts = new Map<string, number>();

  const note = (matcher: string, value: unknown, [limit, digits]: unknown[]): void => {
    if (typeof value !== 'number' || typeof limit !== 'number') return;
    const { project, titlePath } = test.info();
    const place = [project.name, ...titlePath].join(' › ');
    const count = (counts.get(place) ?? 0) + 1;
    counts.set(place, count);
    const line: LimitRecord = {
      key: `${place} #${count}`,
      matcher,
      value,
      limit,
      digits: digits as number | undefined,
    };
    appendFileSync(file, `${JSON.stringify(line)}\n`);
  };
  const recording = (call: (value: unknown, message?: string) => object) => (value: unknown, message?: string) =>
    new Proxy(call(value, message), {
      get(matchers, name, receiver) {
        const matcher = Reflect.get(matchers, name, receiver);
        if (!MATCHERS.includes(name as string)) return matcher;
        return (...limits: unknown[]) => {
          note(name as string, value, limits);
          return matcher(...limits);
        };
      },
    });
  const [recordingExpect, recordingSoft] = [recording(expect), recording(expect.soft)];
  return new Proxy(expect, {
    apply: (_target, _this, [value, message]) => recordingExpect(value, message),
    get: (target, name, receiver) => (name === 'soft' ? recordingSoft : Reflect.get(target, name, receiver)),
  });
}
