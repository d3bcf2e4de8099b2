import { afterEach, expect, test, vi } from 'vitest';
import { disposeHatchingWorkers, runTask, startWorker } from '../../../src/worker/runTask.js';
import { eventually } from '../patience.js';
import { FakeWorker } from './FakeWorker.js';

const request = () => ({
  label: 'test',
  mesh: { positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), indices: new Uint32Array([0, 1, 2]) },
  creaseAngle: 1,
  wantsNormals: false,
  attributes: [],
});

afterEach(() => {
  disposeHatchingWorkers();
  vi.unstubAllGlobals();
});

test('where there is no Worker the main thread computes every task', async () => {
  expect(typeof Worker).toBe('undefined');
  expect((await runTask('bakeCorners', request())).borderEdges).toBe(3);
  const { size, images } = await runTask('generateHatchImages', { size: 64, tones: 4, levels: 1 });
  expect([size, images.length]).toEqual([64, 4]);
});

test('requests with the same createWorker share a worker for each core; others have their own', async () => {
  vi.stubGlobal('navigator', { hardwareConcurrency: 2 });
  const create = vi.fn(() => FakeWorker.asWorker(new FakeWorker()));
  const other = vi.fn(() => FakeWorker.asWorker(new FakeWorker()));
  for (const createWorker of [create, create, create, other])
    runTask('bakeCorners', request(), { createWorker }).catch(() => {});
  await eventually(() => expect(other).toHaveBeenCalledOnce());
  expect(create).toHaveBeenCalledTimes(2);
});

test('disposeHatchingWorkers ends every worker and rejects what is pending', async () => {
  const workers = [new FakeWorker(), new FakeWorker()];
  const creators = workers.map((worker) => vi.fn(() => FakeWorker.asWorker(worker)));
  const promises = creators.map((createWorker) => runTask('bakeCorners', request(), { createWorker }));
  await eventually(() => {
    for (const createWorker of creators) expect(createWorker).toHaveBeenCalledOnce();
  });
  disposeHatchingWorkers();
  for (const promise of promises) await expect(promise).rejects.toThrow(/disposed/);
  expect(workers.map(({ isTerminated }) => isTerminated)).toEqual([true, true]);
});

test('disposeHatchingWorkers rejects what waits for the code of workers, and starts none', async () => {
  const createWorker = vi.fn(() => FakeWorker.asWorker(new FakeWorker()));
  const promise = runTask('bakeCorners', request(), { createWorker });
  disposeHatchingWorkers();
  await expect(promise).rejects.toThrow(/disposed/);
  expect(createWorker).not.toHaveBeenCalled();
});

test('a worker that was started ahead takes the first task', async () => {
  const worker = new FakeWorker();
  const createWorker = vi.fn(() => FakeWorker.asWorker(worker));
  await startWorker({ createWorker });
  expect(createWorker).toHaveBeenCalledOnce();
  runTask('bakeCorners', request(), { createWorker }).catch(() => {});
  worker.say({ type: 'ready' });
  await eventually(() => expect(worker.ids).toEqual([0]));
  expect(createWorker).toHaveBeenCalledOnce();
});

test('whoever starts a worker ahead hears of no fault; the first task does', async () => {
  const createWorker = vi.fn(() => undefined as never);
  await startWorker({ createWorker });
  await expect(runTask('bakeCorners', request(), { createWorker })).rejects.toThrow(
    /createWorker must return a Worker/,
  );
  const ended = startWorker({ createWorker });
  disposeHatchingWorkers();
  await ended;
});
