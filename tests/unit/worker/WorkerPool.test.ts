import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { MapRequest } from '../../../src/strokes/tamImages/generateHatchImages.js';
import { bakingTasks } from '../../../src/worker/runTask.js';
import { maxWorkers } from '../../../src/worker/TaskOptions.js';
import type { BakingTasks } from '../../../src/worker/tasks.js';
import { WorkerPool } from '../../../src/worker/WorkerPool.js';
import { FakeWorker } from './FakeWorker.js';

/** Small requests; `seed` tells them apart. */
const request = (seed = 0): MapRequest => ({ size: 64, tones: 4, levels: 1, seed });
const result = (id: number) => ({ id }) as never;

let workers: FakeWorker[];
let pool: WorkerPool<BakingTasks>;
const onIdle = vi.fn();
const run = (seed?: number, signal?: AbortSignal) => {
  const promise = pool.run('generateHatchImages', request(seed), { signal });
  promise.catch(() => {});
  return promise;
};
const create = (): Worker => {
  const worker = new FakeWorker();
  workers.push(worker);
  return FakeWorker.asWorker(worker);
};

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  vi.stubGlobal('navigator', { hardwareConcurrency: 3 });
  workers = [];
  onIdle.mockReset();
  pool = new WorkerPool(bakingTasks, create, onIdle);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

test.each([
  [1, 1],
  [2, 2],
  [4, 4],
  [64, 4],
  [undefined, 1],
])('of %s cores it uses %s', (hardwareConcurrency, count) => {
  vi.stubGlobal('navigator', { hardwareConcurrency });
  expect(maxWorkers()).toBe(count);
});

describe('the pool', () => {
  test('starts a worker only while all others are busy, and no more than there are cores', () => {
    run();
    expect(workers).toHaveLength(1);
    workers[0].say({ type: 'ready' });
    workers[0].say({ type: 'done', id: 0, result: result(0) });
    run();
    expect(workers).toHaveLength(1);
    for (let i = 0; i < 8; i++) run();
    expect(workers).toHaveLength(3);
    for (const worker of workers.slice(1)) worker.say({ type: 'ready' });
    expect(workers.map(({ ids }) => ids.length)).toEqual([4, 3, 3]);
  });

  test('starts a worker ahead of the first request, once, which uses it', () => {
    pool.start();
    pool.start();
    expect(workers).toHaveLength(1);
    run();
    expect(workers).toHaveLength(1);
    workers[0].say({ type: 'ready' });
    expect(workers[0].ids).toEqual([0]);
    pool.start();
    expect(workers).toHaveLength(1);
  });

  test('terminates a worker that gets no request', () => {
    pool.start();
    workers[0].say({ type: 'ready' });
    vi.advanceTimersByTime(10_000);
    expect(workers[0].isTerminated).toBe(true);
    expect(onIdle).toHaveBeenCalledOnce();
  });

  test('gives a request to the worker with the fewest requests', () => {
    for (let i = 0; i < 6; i++) run();
    for (const worker of workers) worker.say({ type: 'ready' });
    workers[1].say({ type: 'done', id: 0, result: result(0) });
    run(7);
    expect(workers.map(({ ids }) => ids.length)).toEqual([2, 3, 2]);
    expect(workers[1].received.at(-1)).toMatchObject({ type: 'run', request: { seed: 7 } });
  });

  test('resolves each promise with its own result and aborts the right request', async () => {
    const controller = new AbortController();
    const promises = [run(0), run(1, controller.signal), run(2)];
    for (const worker of workers) worker.say({ type: 'ready' });
    controller.abort(new Error('stop'));
    await expect(promises[1]).rejects.toThrow('stop');
    expect(workers.map(({ received }) => received.at(-1)!.type)).toEqual(['run', 'abort', 'run']);
    for (const i of [0, 2]) workers[i].say({ type: 'done', id: 0, result: result(i) });
    expect(await promises[0]).toEqual({ id: 0 });
    expect(await promises[2]).toEqual({ id: 2 });
  });

  test('continues with the others when one dies', async () => {
    const promises = [run(), run()];
    for (const worker of workers) worker.say({ type: 'ready' });
    workers[0].onerror!({ message: 'out of memory' });
    await expect(promises[0]).rejects.toThrow(/out of memory/);
    workers[1].say({ type: 'done', id: 0, result: result(1) });
    expect(await promises[1]).toEqual({ id: 1 });
  });

  test('is idle once the last worker has terminated', () => {
    run();
    run();
    for (const worker of workers) worker.say({ type: 'ready' });
    workers[0].say({ type: 'done', id: 0, result: result(0) });
    vi.advanceTimersByTime(10_000);
    expect(workers.map(({ isTerminated }) => isTerminated)).toEqual([true, false]);
    expect(onIdle).not.toHaveBeenCalled();
    workers[1].say({ type: 'done', id: 0, result: result(1) });
    vi.advanceTimersByTime(10_000);
    expect(onIdle).toHaveBeenCalledOnce();
  });

  test('terminates all workers on dispose', async () => {
    const promises = [run(), run()];
    pool.dispose();
    for (const promise of promises) await expect(promise).rejects.toThrow(/disposed/);
    expect(workers.every(({ isTerminated }) => isTerminated)).toBe(true);
  });

  test('starts no other worker after one failed to start', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const failing = vi.fn(() => {
      throw new Error('blocked by the policy');
    });
    pool = new WorkerPool(bakingTasks, failing);
    vi.useRealTimers();
    const all = await Promise.all([run(1), run(2), run(3)]);
    expect(all.map(({ images }) => images.length)).toEqual([4, 4, 4]);
    expect(failing).toHaveBeenCalledOnce();
    expect(warn).toHaveBeenCalledOnce();
  });

  test('warns once for all workers that were starting when the first was refused', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const both = [run(1), run(2)];
    expect(workers).toHaveLength(2);
    for (const worker of workers) worker.onerror!({});
    vi.useRealTimers();
    for (const { images } of await Promise.all(both)) expect(images).toHaveLength(4);
    expect(warn).toHaveBeenCalledOnce();
  });

  test('warns once when several workers die, and lets each start again', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const both = [1, 2].map((seed) => pool.run('generateHatchImages', request(seed), {}, () => request(seed)));
    for (const worker of workers) worker.say({ type: 'ready' });
    for (const worker of workers) worker.onerror!({ message: 'out of memory' });
    for (let i = 0; i < 5; i++) await Promise.resolve();
    expect(workers).toHaveLength(4);
    for (const i of [2, 3]) {
      workers[i].say({ type: 'ready' });
      workers[i].say({ type: 'done', id: 0, result: result(i) });
    }
    expect(await Promise.all(both)).toEqual([{ id: 2 }, { id: 3 }]);
    expect(warn).toHaveBeenCalledOnce();
  });
});
