import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { BakeCornersResult, BakeRequest } from '../../../src/mesh/bake/bakeCorners.js';
import { bakingTasks } from '../../../src/worker/runTask.js';
import { TaskClient } from '../../../src/worker/TaskClient.js';
import type { BakingTasks } from '../../../src/worker/tasks.js';
import { FakeWorker } from './FakeWorker.js';

/** One triangle. `label` tells requests apart. */
const request = (label = 'test', positions = [0, 0, 0, 1, 0, 0, 0, 1, 0]): BakeRequest => ({
  label,
  mesh: { positions: new Float32Array(positions), indices: new Uint32Array([0, 1, 2]) },
  creaseAngle: Math.PI / 2,
  wantsNormals: false,
  attributes: [{ words: new Uint8Array([1, 2, 3]), wordsPerVertex: 1 }],
});

/** Stands for the result of request `id`; the client looks at nothing in it. */
const result = (id: number) => ({ id }) as unknown as BakeCornersResult;

/** The state of the promise, without waiting for it. */
const outcomeOf = async (promise: Promise<unknown>) => {
  let outcome: unknown = 'pending';
  promise.then(
    (value) => (outcome = value),
    (reason) => (outcome = reason),
  );
  for (let i = 0; i < 5; i++) await Promise.resolve();
  return outcome;
};

let workers: FakeWorker[];
let client: TaskClient<BakingTasks>;
const create = () => {
  const worker = new FakeWorker();
  workers.push(worker);
  return FakeWorker.asWorker(worker);
};
const onIdle = vi.fn();

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  workers = [];
  client = new TaskClient(bakingTasks, create, onIdle);
  onIdle.mockReset();
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

/** A client whose worker is ready. */
function started(): FakeWorker {
  client.run('bakeCorners', request()).catch(() => {});
  const worker = workers[0];
  worker.say({ type: 'ready' });
  worker.say({ type: 'done', id: 0, result: result(0) });
  worker.received.length = 0;
  worker.transferred.length = 0;
  return worker;
}

describe('one worker', () => {
  test('starts with the first request, is shared, and gets requests once it is ready', async () => {
    expect(workers).toHaveLength(0);
    const first = client.run('bakeCorners', request('first'));
    const second = client.run('bakeCorners', request('second'));
    expect(workers).toHaveLength(1);
    const [worker] = workers as [FakeWorker];
    expect(worker.received).toEqual([]);
    worker.say({ type: 'ready' });
    expect(worker.received).toMatchObject([
      { type: 'run', id: 0, task: 'bakeCorners', request: { label: 'first' } },
      { type: 'run', id: 1, task: 'bakeCorners', request: { label: 'second' } },
    ]);
    const third = client.run('bakeCorners', request('third'));
    expect(worker.ids).toEqual([0, 1, 2]);
    // Answers come in any order.
    worker.say({ type: 'done', id: 2, result: result(2) });
    worker.say({ type: 'done', id: 0, result: result(0) });
    expect(await third).toEqual({ id: 2 });
    expect(await first).toEqual({ id: 0 });
    expect(await outcomeOf(second)).toBe('pending');
    worker.say({ type: 'done', id: 1, result: result(1) });
    expect(await second).toEqual({ id: 1 });
  });

  test('transfers the buffers of a request, each once', () => {
    const worker = started();
    const sent = request();
    client.run('bakeCorners', sent);
    expect(worker.transferred).toHaveLength(1);
    expect(worker.transferred[0]).toHaveLength(3);
    expect(sent.mesh.positions.byteLength).toBe(0);
    expect((worker.received[0] as { request: BakeRequest }).request).toEqual(request());
  });

  test('reports rising progress to the right request, then 1', async () => {
    const worker = started();
    const seen: Record<string, number[]> = { a: [], b: [] };
    const a = client.run('bakeCorners', request(), { onProgress: (value) => seen.a!.push(value) });
    client.run('bakeCorners', request(), { onProgress: (value) => seen.b!.push(value) });
    worker.say({ type: 'progress', id: 1, progress: 0.25 });
    worker.say({ type: 'progress', id: 2, progress: 0.5 });
    worker.say({ type: 'progress', id: 1, progress: 0.2 });
    worker.say({ type: 'progress', id: 1, progress: 0.75 });
    worker.say({ type: 'done', id: 1, result: result(1) });
    worker.say({ type: 'progress', id: 1, progress: 0.9 });
    await a;
    expect(seen).toEqual({ a: [0.25, 0.75, 1], b: [0.5] });
  });

  test('a callback that throws rejects its own request and stops it', async () => {
    const worker = started();
    const failure = new Error('in the callback');
    const promise = client.run('bakeCorners', request(), {
      onProgress: () => {
        throw failure;
      },
    });
    worker.say({ type: 'progress', id: 1, progress: 0.5 });
    await expect(promise).rejects.toBe(failure);
    expect(worker.received.at(-1)).toEqual({ type: 'abort', id: 1 });
  });

  test('rebuilds the error of a task', async () => {
    const worker = started();
    const promise = client.run('bakeCorners', request());
    worker.say({ type: 'failed', id: 1, error: { name: 'RangeError', message: 'no triangles' } });
    const error = await promise.catch((reason) => reason);
    expect(error).toBeInstanceOf(RangeError);
    expect(error.message).toBe('no triangles');
  });

  test('terminates when idle, and a new one starts with the next request', async () => {
    const worker = started();
    vi.advanceTimersByTime(9_999);
    expect(worker.isTerminated).toBe(false);
    // A request in between restarts the timer.
    client.run('bakeCorners', request());
    vi.advanceTimersByTime(60_000);
    expect(worker.isTerminated).toBe(false);
    worker.say({ type: 'done', id: 1, result: result(1) });
    vi.advanceTimersByTime(10_000);
    expect(worker.isTerminated).toBe(true);
    expect(onIdle).toHaveBeenCalledOnce();
    client.run('bakeCorners', request());
    expect(workers).toHaveLength(2);
    expect(vi.getTimerCount()).toBe(1);
  });
});

describe('abort', () => {
  test('before the request: no worker is started', async () => {
    const reason = new Error('stop');
    await expect(client.run('bakeCorners', request(), { signal: AbortSignal.abort(reason) })).rejects.toBe(reason);
    expect(workers).toHaveLength(0);
  });

  test('while the worker starts: the request is never sent', async () => {
    const controller = new AbortController();
    const promise = client.run('bakeCorners', request(), { signal: controller.signal });
    controller.abort(new Error('stop'));
    await expect(promise).rejects.toThrow('stop');
    workers[0].say({ type: 'ready' });
    expect(workers[0].received).toEqual([]);
  });

  test('while it runs: rejects at once, notifies the worker, and does not affect others', async () => {
    const worker = started();
    const controller = new AbortController();
    const aborted = client.run('bakeCorners', request(), { signal: controller.signal });
    const other = client.run('bakeCorners', request());
    controller.abort();
    await expect(aborted).rejects.toHaveProperty('name', 'AbortError');
    expect(worker.received.at(-1)).toEqual({ type: 'abort', id: 1 });
    // An answer that was already on its way changes nothing.
    worker.say({ type: 'done', id: 1, result: result(1) });
    worker.say({ type: 'done', id: 2, result: result(2) });
    expect(await other).toEqual({ id: 2 });
  });

  test('after the result: does nothing, and no listener is left on the signal', async () => {
    const worker = started();
    const controller = new AbortController();
    const remove = vi.spyOn(controller.signal, 'removeEventListener');
    const promise = client.run('bakeCorners', request(), { signal: controller.signal });
    worker.say({ type: 'done', id: 1, result: result(1) });
    await promise;
    expect(remove).toHaveBeenCalledOnce();
    controller.abort();
    expect(worker.received.map(({ type }) => type)).toEqual(['run']);
  });
});

describe('dispose', () => {
  test('rejects pending requests, terminates the worker, and leaves no timer; the client can be used again', async () => {
    const worker = started();
    const promises = [client.run('bakeCorners', request()), client.run('bakeCorners', request())];
    client.dispose();
    for (const promise of promises)
      await expect(promise).rejects.toThrow(/disposed of before this request was finished/);
    expect(worker.isTerminated).toBe(true);
    expect(vi.getTimerCount()).toBe(0);
    const again = client.run('bakeCorners', request());
    workers[1].say({ type: 'ready' });
    workers[1].say({ type: 'done', id: 3, result: result(3) });
    expect(await again).toEqual({ id: 3 });
  });

  test('while the worker starts', async () => {
    const promise = client.run('bakeCorners', request());
    client.dispose();
    await expect(promise).rejects.toThrow(/disposed/);
    expect(workers[0].isTerminated).toBe(true);
    expect(vi.getTimerCount()).toBe(0);
  });

  test('of a client on the main thread', async () => {
    client = new TaskClient(bakingTasks, () => null);
    const promise = client.run('bakeCorners', request());
    client.dispose();
    await expect(promise).rejects.toThrow(/disposed/);
  });
});

describe('death of the worker', () => {
  test('rejects pending requests with a warning; the next request gets a new worker', async () => {
    const worker = started();
    const promises = [client.run('bakeCorners', request()), client.run('bakeCorners', request())];
    worker.onerror!({ message: 'out of memory' });
    for (const promise of promises) await expect(promise).rejects.toThrow(/worker died \(out of memory\).*Ask again/);
    expect(worker.isTerminated).toBe(true);
    const again = client.run('bakeCorners', request());
    expect(workers).toHaveLength(2);
    // Messages of the dead worker may still arrive.
    worker.say({ type: 'done', id: 3, result: result(-1) });
    workers[1].say({ type: 'ready' });
    workers[1].say({ type: 'done', id: 3, result: result(3) });
    expect(await again).toEqual({ id: 3 });
  });

  test('a message that cannot be read counts as death', async () => {
    const worker = started();
    const promise = client.run('bakeCorners', request());
    worker.onmessageerror!();
    await expect(promise).rejects.toThrow(/a message could not be read/);
  });

  test('an idle worker is replaced', () => {
    started().onerror!({ message: 'boom' });
    client.run('bakeCorners', request());
    expect(workers).toHaveLength(2);
  });
});

describe('a request that can be made again', () => {
  let warn: ReturnType<typeof vi.spyOn>;
  beforeEach(() => {
    warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  });
  const warnings = () => warn.mock.calls.map(([sentence]: unknown[]) => sentence);
  const settled = async () => {
    for (let i = 0; i < 5; i++) await Promise.resolve();
  };
  const remake = (label = 'again') => vi.fn(() => request(label));

  test('starts once more in a new worker when its own dies', async () => {
    const worker = started();
    const makeAgain = remake();
    const promise = client.run('bakeCorners', request('first'), {}, makeAgain);
    expect(makeAgain).not.toHaveBeenCalled();
    worker.onerror!({ message: 'out of memory' });
    await settled();
    expect(workers).toHaveLength(2);
    workers[1].say({ type: 'ready' });
    expect(workers[1].received).toMatchObject([{ type: 'run', id: 1, request: { label: 'again' } }]);
    workers[1].say({ type: 'done', id: 1, result: result(1) });
    expect(await promise).toEqual({ id: 1 });
    expect(warnings()).toEqual([
      'three-hatching: the worker died (out of memory). Its tasks start over in a new worker.',
    ]);
  });

  test('runs on the main thread when the second worker dies too, and its progress goes on rising', async () => {
    const progress: number[] = [];
    const onProgress = (value: number) => void progress.push(value);
    const promise = client.run('bakeCorners', request('first'), { onProgress }, remake());
    for (const i of [0, 1]) {
      workers[i].say({ type: 'ready' });
      workers[i].say({ type: 'progress', id: 0, progress: 0.3 + 0.1 * i });
      workers[i].onerror!({ message: 'out of memory' });
      await settled();
    }
    expect([...(await promise).positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    expect(workers).toHaveLength(2);
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(warnings()).toEqual([
      'three-hatching: the worker died (out of memory). Its tasks start over in a new worker.',
      'three-hatching: the worker died (out of memory). Its tasks start over on the main thread, in slices.',
    ]);
    // The next request has a worker again.
    client.run('bakeCorners', request());
    expect(workers).toHaveLength(3);
  });

  test('runs on the main thread when no second worker starts', async () => {
    const worker = started();
    const promise = client.run('bakeCorners', request('first'), {}, remake());
    worker.onerror!({ message: 'out of memory' });
    await settled();
    workers[1].onerror!({});
    expect([...(await promise).positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  });

  test('is rejected with the death and the cause if it cannot be made again', async () => {
    const worker = started();
    const cause = new Error('changed');
    const promise = client.run('bakeCorners', request(), {}, () => Promise.reject(cause));
    worker.onerror!({ message: 'out of memory' });
    const error = await promise.catch((reason) => reason);
    expect(error.message).toMatch(/worker died \(out of memory\)/);
    expect(error.cause).toBe(cause);
  });

  test('can be aborted while it is made again, and then needs no worker', async () => {
    const worker = started();
    const controller = new AbortController();
    let made: (value: BakeRequest) => void = () => {};
    const makeAgain = () => new Promise<BakeRequest>((resolve) => (made = resolve));
    const promise = client.run('bakeCorners', request(), { signal: controller.signal }, makeAgain);
    worker.onerror!({ message: 'out of memory' });
    controller.abort(new Error('stop'));
    await expect(promise).rejects.toThrow('stop');
    made(request());
    await settled();
    expect(workers).toHaveLength(1);
  });

  test('starts again although another one, which cannot be made again, is rejected', async () => {
    const worker = started();
    const both = [client.run('bakeCorners', request(), {}, remake()), client.run('bakeCorners', request())];
    worker.onerror!({ message: 'out of memory' });
    await expect(both[1]).rejects.toThrow(/worker died/);
    workers[1].say({ type: 'ready' });
    await settled();
    workers[1].say({ type: 'done', id: 1, result: result(1) });
    expect(await both[0]).toEqual({ id: 1 });
  });
});

describe('a worker that holds a lock', () => {
  /** The locks of a page, with the callback that waits for each. */
  let waiting: Map<string, () => void>;
  beforeEach(() => {
    waiting = new Map();
    vi.stubGlobal('navigator', {
      locks: {
        request: (name: string, { signal }: { signal: AbortSignal }, onGranted: () => void) =>
          new Promise((_, reject) => {
            waiting.set(name, onGranted);
            signal.addEventListener('abort', () => {
              waiting.delete(name);
              reject(signal.reason);
            });
          }),
      },
    });
  });
  afterEach(() => vi.unstubAllGlobals());

  test('counts as dead as soon as the lock is free', async () => {
    const promise = client.run('bakeCorners', request());
    workers[0].say({ type: 'ready', lock: 'of worker 0' });
    workers[0].isAlive = false;
    waiting.get('of worker 0')!();
    await expect(promise).rejects.toThrow(/The hatching worker died \(it has ended\)/);
    expect(vi.getTimerCount()).toBe(0);
  });

  test('is no longer watched after it was terminated', async () => {
    client.run('bakeCorners', request()).catch(() => {});
    workers[0].say({ type: 'ready', lock: 'of worker 0' });
    expect([...waiting.keys()]).toEqual(['of worker 0']);
    client.dispose();
    expect(waiting.size).toBe(0);
  });
});

describe('a worker that ends without an event', () => {
  const silent = (): FakeWorker => {
    const worker = started();
    worker.isAlive = false;
    return worker;
  };
  const seconds = (count: number) => vi.advanceTimersByTime(1000 * count);
  afterEach(() => vi.unstubAllGlobals());

  test('rejects pending requests after 30 silent seconds; the next request gets a new worker', async () => {
    const worker = silent();
    const promises = [client.run('bakeCorners', request()), client.run('bakeCorners', request())];
    seconds(29);
    expect(await outcomeOf(promises[0])).toBe('pending');
    seconds(1);
    for (const promise of promises) {
      await expect(promise).rejects.toThrow(/The hatching worker died \(it gave no sign of life for 30 s\).*Ask again/);
    }
    expect(worker.isTerminated).toBe(true);
    expect(vi.getTimerCount()).toBe(0);
    const again = client.run('bakeCorners', request());
    workers[1].say({ type: 'ready' });
    workers[1].say({ type: 'done', id: 3, result: result(3) });
    expect(await again).toEqual({ id: 3 });
  });

  test('work may take any time while it answers pings or reports progress', async () => {
    const worker = started();
    const promise = client.run('bakeCorners', request());
    seconds(300);
    expect(worker.pings).toBe(300);
    worker.isAlive = false;
    for (let i = 0; i < 10; i++) {
      seconds(20);
      worker.say({ type: 'progress', id: 1, progress: i / 10 });
    }
    expect(await outcomeOf(promise)).toBe('pending');
    worker.say({ type: 'done', id: 1, result: result(1) });
    expect(await promise).toEqual({ id: 1 });
  });

  test('an idle worker is not pinged', () => {
    const worker = silent();
    seconds(9);
    expect(worker.pings).toBe(0);
    client.run('bakeCorners', request()).catch(() => {});
    seconds(5);
    worker.say({ type: 'done', id: 1, result: result(1) });
    seconds(9);
    expect(worker.pings).toBe(5);
  });

  test('seconds in which the page is hidden do not count, and the count restarts afterwards', async () => {
    const page = { visibilityState: 'visible' };
    vi.stubGlobal('document', page);
    silent();
    const promise = client.run('bakeCorners', request());
    promise.catch(() => {});
    seconds(29);
    page.visibilityState = 'hidden';
    seconds(100);
    page.visibilityState = 'visible';
    seconds(29);
    expect(await outcomeOf(promise)).toBe('pending');
    seconds(1);
    expect(await outcomeOf(promise)).toBeInstanceOf(Error);
  });

  test('seconds with late timers do not count either, as of a page that sleeps or is busy', async () => {
    silent();
    const promise = client.run('bakeCorners', request());
    promise.catch(() => {});
    let slept = 0;
    const clock = performance.now.bind(performance);
    vi.spyOn(performance, 'now').mockImplementation(() => clock() + slept);
    for (let i = 0; i < 10; i++) {
      seconds(20);
      slept += 60_000;
      seconds(1);
    }
    expect(await outcomeOf(promise)).toBe('pending');
    seconds(30);
    expect(await outcomeOf(promise)).toBeInstanceOf(Error);
  });
});

describe('a function that makes no worker', () => {
  test.each<[string, () => unknown, RegExp]>([
    ['an object', () => ({}), /must return a Worker, but returned something else; pass a plain function such as/],
    ['a promise', async () => FakeWorker.asWorker(new FakeWorker()), /but returned a Promise/],
    ['nothing', () => {}, /but returned nothing/],
  ])('is refused at once: %s', async (_what, make, says) => {
    client = new TaskClient(bakingTasks, make as () => Worker);
    for (let i = 0; i < 2; i++) {
      const error = await client.run('bakeCorners', request()).catch((reason) => reason);
      expect(error).toBeInstanceOf(TypeError);
      expect(error.message).toMatch(says);
    }
    expect(vi.getTimerCount()).toBe(0);
  });
});

describe('without a worker the main thread computes', () => {
  let warn: ReturnType<typeof vi.spyOn>;
  beforeEach(() => {
    warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  });

  const isBaked = (value: BakeCornersResult) => expect([...value.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);

  test('when there are no workers: silently', async () => {
    client = new TaskClient(bakingTasks, () => null);
    const progress: number[] = [];
    isBaked(await client.run('bakeCorners', request(), { onProgress: (value) => progress.push(value) }));
    expect(progress.at(-1)).toBe(1);
    expect(warn).not.toHaveBeenCalled();
  });

  test('when the constructor throws: with one warning, for all later requests too', async () => {
    const create = vi.fn(() => {
      throw new Error('blocked by the policy');
    });
    client = new TaskClient(bakingTasks, create);
    const both = [client.run('bakeCorners', request()), client.run('bakeCorners', request())];
    for (const promise of both) isBaked(await promise);
    expect(create).toHaveBeenCalledOnce();
    expect(warn).toHaveBeenCalledOnce();
    expect(warn.mock.calls[0][0]).toMatch(/could not be started \(blocked by the policy\).*createWorker/);
  });

  test('when the script cannot be loaded: with the requests that were waiting', async () => {
    const both = [client.run('bakeCorners', request()), client.run('bakeCorners', request())];
    workers[0].onerror!({});
    for (const promise of both) isBaked(await promise);
    isBaked(await client.run('bakeCorners', request()));
    expect(workers).toHaveLength(1);
    expect(warn.mock.calls[0][0]).toMatch(/its script could not be loaded/);
  });

  test('when the worker does not report in time; a second request does not restart the timer', async () => {
    const promise = client.run('bakeCorners', request());
    vi.advanceTimersByTime(10_000);
    const second = client.run('bakeCorners', request());
    vi.advanceTimersByTime(5_000);
    isBaked(await promise);
    isBaked(await second);
    expect(warn.mock.calls[0][0]).toMatch(/did not report within 15 s/);
  });

  test('errors of the task and aborts reject the request', async () => {
    client = new TaskClient(bakingTasks, () => null);
    await expect(client.run('bakeCorners', request('bad', [Number.NaN, 0, 0, 1, 0, 0, 0, 1, 0]))).rejects.toThrow(
      /^bad: the position/,
    );
    const controller = new AbortController();
    const promise = client.run('bakeCorners', request(), { signal: controller.signal });
    controller.abort(new Error('stop'));
    await expect(promise).rejects.toThrow('stop');
  });
});
