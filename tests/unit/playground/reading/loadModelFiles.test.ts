import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { loadModelFiles } from '../../../../src/playground/reading/loadModelFiles.js';
import type { ModelWorkerMessage } from '../../../../src/playground/reading/model.worker.js';
import type { ReadModel } from '../../../../src/viewer/files/readModel.js';

/** A worker that says what the test lets it say. */
class FakeWorker extends EventTarget {
  static started: FakeWorker[] = [];
  isAlive = true;

  constructor() {
    super();
    FakeWorker.started.push(this);
  }

  postMessage(): void {}

  terminate(): void {
    this.isAlive = false;
  }

  say(data: ModelWorkerMessage): void {
    this.dispatchEvent(new MessageEvent('message', { data }));
  }
}

const MEGABYTE = 2 ** 20;
const files = (bytes: number) => [{ name: 'a.obj', content: { size: bytes } as Blob }];

/** Starts to read, and says how it ended. */
const start = (bytes = 1) => {
  const stages: string[] = [];
  const controller = new AbortController();
  const { signal } = controller;
  const state = { end: 'reading', stages, controller, worker: undefined as unknown as FakeWorker };
  loadModelFiles(files(bytes), { signal, onStage: (viewport) => stages.push(viewport) }).then(
    () => Object.assign(state, { end: 'read' }),
    (error: Error) => Object.assign(state, { end: error.message }),
  );
  state.worker = FakeWorker.started.at(-1)!;
  return state;
};

describe('reading in a worker', () => {
  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal('Worker', FakeWorker);
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  test('takes over a worker that is reading the files already, with its messages', async () => {
    const post = vi.spyOn(FakeWorker.prototype, 'postMessage');
    const worker = new FakeWorker();
    const read = { kind: 'mesh', name: 'a' } as ReadModel;
    const stages: string[] = [];
    const loading = loadModelFiles(
      Promise.resolve(files(1)),
      { signal: new AbortController().signal, onStage: (viewport) => stages.push(viewport) },
      {
        url: 'a',
        files: Promise.resolve(files(1)),
        worker: worker as unknown as Worker,
        messages: [{ kind: 'stage', stage: 'unpacking', bytes: 1 }],
        hasFailed: false,
      },
    );
    await vi.advanceTimersByTimeAsync(0);
    expect(stages).toEqual(['unpacking']);
    worker.say({ kind: 'done', model: read });
    expect(await loading).toBe(read);
    expect([post.mock.calls.length, FakeWorker.started.at(-1), worker.isAlive]).toEqual([0, worker, false]);
    post.mockRestore();
  });

  test('asks for as many triangles as are wanted', async () => {
    const post = vi.spyOn(FakeWorker.prototype, 'postMessage') as unknown as ReturnType<typeof vi.fn>;
    const given = files(1);
    const { signal } = new AbortController();
    void loadModelFiles(given, { signal, onStage: () => {} });
    void loadModelFiles(given, { signal, onStage: () => {}, most: 4_000_000 });
    expect(post.mock.calls).toEqual([[given], [{ files: given, most: 4_000_000 }]]);
    post.mockRestore();
  });

  test('starts before the files are there, and has time for them from then on', async () => {
    let give: (given: ReturnType<typeof files>) => void = () => {};
    const given = new Promise<ReturnType<typeof files>>((resolve) => {
      give = resolve;
    });
    const post = vi.spyOn(FakeWorker.prototype, 'postMessage');
    const { signal } = new AbortController();
    const end = loadModelFiles(given, { signal, onStage: () => {} }).catch(({ message }) => message);
    const worker = FakeWorker.started.at(-1)!;
    await vi.advanceTimersByTimeAsync(60_000);
    expect([worker.isAlive, post.mock.calls.length]).toEqual([true, 0]);
    give(files(1));
    await vi.advanceTimersByTimeAsync(1000);
    expect([worker.isAlive, post.mock.calls.length]).toEqual([true, 1]);
    await vi.advanceTimersByTimeAsync(30_000);
    expect(await end).toContain('put aside');
    post.mockRestore();
  });

  test('files that never come end the worker, with the reason', async () => {
    const { signal } = new AbortController();
    const reason = new Error('no connection');
    await expect(loadModelFiles(Promise.reject(reason), { signal, onStage: () => {} })).rejects.toBe(reason);
    expect(FakeWorker.started.at(-1)!.isAlive).toBe(false);
  });

  test('fails after twenty seconds without a message, and terminates its worker', async () => {
    const state = start();
    await vi.advanceTimersByTimeAsync(20_500);
    expect(state.end).toBe('reading');
    await vi.advanceTimersByTimeAsync(1000);
    expect(state.end).toBe('The file was put aside, because its reader made no progress for 21 seconds.');
    expect(state.worker.isAlive).toBe(false);
    expect(start().worker).not.toBe(state.worker);
  });

  test('may take any time while messages arrive', async () => {
    const state = start();
    for (let i = 0; i < 10; i++) {
      await vi.advanceTimersByTimeAsync(20_000);
      state.worker.say({ kind: 'stage', stage: `picture ${i}`, bytes: undefined });
    }
    expect(state.stages).toHaveLength(10);
    state.worker.say({ kind: 'done', model: {} as ReadModel });
    await vi.advanceTimersByTimeAsync(0);
    expect(state.end).toBe('read');
    expect(state.worker.isAlive).toBe(false);
  });

  test('may take longer for large files, also once they are unpacked', async () => {
    const large = start(100 * MEGABYTE);
    const packed = start(MEGABYTE);
    packed.worker.say({ kind: 'stage', stage: 'reading', bytes: 100 * MEGABYTE });
    await vi.advanceTimersByTimeAsync(219_000);
    expect([large.end, packed.end]).toEqual(['reading', 'reading']);
    await vi.advanceTimersByTimeAsync(2000);
    expect(large.end).toMatch(/no progress for 220 seconds/);
    expect(packed.end).toMatch(/no progress for 220 seconds/);
  });

  test('rejects with the worker’s sentence if it fails or does not start', async () => {
    const failed = start();
    failed.worker.say({ kind: 'failed', sentence: 'It is empty.' });
    const broken = start();
    broken.worker.say({ kind: 'stage', stage: 'reading', bytes: undefined });
    broken.worker.dispatchEvent(new Event('error', { cancelable: true }));
    const large = start(9 * MEGABYTE);
    large.worker.dispatchEvent(new Event('error', { cancelable: true }));
    await vi.advanceTimersByTimeAsync(0);
    expect(failed.end).toBe('It is empty.');
    expect(broken.end).toBe('The file could not be read: the reader stopped.');
    expect(large.end).toMatch(/^The file has 9 MB\. It takes a reader in the background, which did not start/);
  });

  test('ends at once when it is cancelled', async () => {
    const state = start();
    state.controller.abort(new Error('cancelled'));
    await vi.advanceTimersByTimeAsync(0);
    expect(state).toMatchObject({ end: 'cancelled', worker: { isAlive: false } });
  });
});

describe('where no worker starts', () => {
  afterEach(() => void vi.unstubAllGlobals());

  const triangle = new Blob(['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n']);
  const read = () =>
    loadModelFiles([{ name: 'a.obj', content: triangle }], {
      signal: new AbortController().signal,
      onStage: () => {},
    });

  test.each([
    ['there are none', undefined],
    [
      'they may not be made',
      class {
        constructor() {
          throw new Error('SecurityError');
        }
      },
    ],
    [
      'their script is missing or may not run',
      class extends FakeWorker {
        override postMessage(): void {
          queueMicrotask(() => this.dispatchEvent(new Event('error', { cancelable: true })));
        }
      },
    ],
  ])('because %s, a small file is read on the main thread', async (_, worker) => {
    vi.stubGlobal('Worker', worker);
    const model = await read();
    expect(model).toMatchObject({ kind: 'mesh', name: 'a.obj' });
  });
});
