import { afterEach, describe, expect, test, vi } from 'vitest';
import { runSliced } from '../../../src/mesh/runSliced.js';

/** A clock that only the tasks below advance. */
let now = 0;
vi.spyOn(performance, 'now').mockImplementation(() => now);
afterEach(() => {
  now = 0;
});

/** Takes `steps` steps of `milliseconds` each, and logs its name at every step. */
function* work(name: string, steps: number, milliseconds: number, log: string[] = []): Generator<number, string, void> {
  try {
    for (let step = 1; step <= steps; step++) {
      now += milliseconds;
      log.push(name);
      yield step / steps;
    }
    return name;
  } finally {
    log.push(`${name} ends`);
  }
}

describe('runSliced', () => {
  test('several tasks take turns, a slice of at most 12 ms each', async () => {
    const log: string[] = [];
    const tasks = [runSliced(work('a', 30, 2, log)), runSliced(work('b', 30, 2, log))];
    expect(await Promise.all(tasks)).toEqual(['a', 'b']);
    const turns = log
      .filter((entry) => entry.length === 1)
      .join('')
      .match(/a+|b+/g)!;
    expect(turns.length).toBeGreaterThan(12);
    for (const turn of turns) expect(turn.length * 2).toBeLessThanOrEqual(12);
  });

  test('events run in between', async () => {
    let hasHappened = false;
    function* waiting() {
      while (!hasHappened) {
        now += 4;
        yield 0;
      }
      return 'heard';
    }
    setTimeout(() => {
      hasHappened = true;
    }, 0);
    expect(await runSliced(waiting())).toBe('heard');
  });

  test('progress is reported once per slice and rises strictly', async () => {
    const seen: number[] = [];
    function* stalling() {
      for (const value of [0.1, 0.1, 0.05, 0.2, 0.2]) {
        now += 20;
        yield value;
      }
    }
    await runSliced(stalling(), { onProgress: (value) => seen.push(value) });
    expect(seen).toEqual([0.1, 0.2]);
    const perSlice: number[] = [];
    now = 0;
    await runSliced(work('a', 100, 2), { onProgress: (value) => perSlice.push(value) });
    expect(perSlice).toHaveLength(25);
  });

  test('an abort is heard between slices, with its reason; the task is closed', async () => {
    const log: string[] = [];
    const controller = new AbortController();
    const reason = new Error('stop');
    const onProgress = () => controller.abort(reason);
    await expect(runSliced(work('a', 1000, 20, log), { signal: controller.signal, onProgress })).rejects.toBe(reason);
    expect(log).toEqual(['a', 'a ends']);
  });

  test('an aborted signal: the task does not begin', async () => {
    const log: string[] = [];
    await expect(runSliced(work('a', 3, 1, log), { signal: AbortSignal.abort() })).rejects.toThrow();
    expect(log).toEqual([]);
  });

  test('errors of the task and of the callback reject', async () => {
    // biome-ignore lint/correctness/useYield: it fails before it would
    function* failing(): Generator<number, void, void> {
      throw new RangeError('no');
    }
    await expect(runSliced(failing())).rejects.toThrow(RangeError);
    const log: string[] = [];
    const onProgress = () => {
      throw new Error('callback');
    };
    await expect(runSliced(work('a', 5, 20, log), { onProgress })).rejects.toThrow('callback');
    expect(log.at(-1)).toBe('a ends');
  });
});
