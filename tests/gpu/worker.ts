import bunny from 'bunny';
import { BoxGeometry, BufferGeometry, Float32BufferAttribute, TorusGeometry } from 'three';
import { type PrepareHatchingGeometryOptions, prepareHatchingGeometry } from 'three-hatching';
import BakeWorker from '../../src/worker/bake.worker.js?worker';
import { disposeHatchingWorkers, runTask } from '../../src/worker/runTask.js';
import ClosingWorker from './workerClosing.js?worker';
import DyingWorker from './workerDying.js?worker';

/** SHA-256 of every array of a geometry, by name. */
async function digest(geometry: BufferGeometry): Promise<Record<string, string>> {
  const hashes: Record<string, string> = {};
  const arrays = Object.entries(geometry.attributes).map(([name, { array }]) => [name, array] as const);
  if (geometry.index) arrays.push(['index', geometry.index.array]);
  for (const [name, array] of arrays) hashes[name] = await hashOf(array as Uint8Array<ArrayBuffer>);
  return hashes;
}

async function hashOf(array: ArrayBufferView<ArrayBuffer>): Promise<string> {
  const bytes = new Uint8Array(await crypto.subtle.digest('SHA-256', array));
  return `${array.byteLength} bytes ${Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('')}`;
}

/** Counts the workers that the page makes, and can make the page one that has no workers. */
const NativeWorker = globalThis.Worker;
let workersMade = 0;
class CountingWorker extends NativeWorker {
  constructor(url: string | URL, options?: WorkerOptions) {
    super(url, options);
    workersMade++;
  }
}
globalThis.Worker = CountingWorker;

async function withoutWorkers<Result>(body: () => Promise<Result>): Promise<Result> {
  disposeHatchingWorkers();
  Reflect.set(globalThis, 'Worker', undefined);
  try {
    return await body();
  } finally {
    Reflect.set(globalThis, 'Worker', CountingWorker);
    disposeHatchingWorkers();
  }
}

async function prepareAndDigest(options?: PrepareHatchingGeometryOptions) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(bunny.positions.flat(), 3));
  geometry.setIndex(bunny.cells.flat());
  const prepared = await prepareHatchingGeometry(geometry, options);
  return { digest: await digest(prepared), statistics: prepared.userData.hatching, bounds: prepared.boundingSphere };
}

const largeTorus = () => new TorusGeometry(1, 0.4, 300, 300);

const workerTests = {
  async bunny() {
    const inWorker = await prepareAndDigest();
    const workersForWorker = workersMade;
    const inOwnWorker = await prepareAndDigest({ createWorker: () => new BakeWorker() });
    const onMainThread = await withoutWorkers(() => prepareAndDigest());
    return { inWorker, workersForWorker, inOwnWorker, onMainThread, workersMade };
  },

  async bunnyIndexed() {
    const inWorker = await prepareAndDigest({ layout: 'indexed' });
    return { inWorker, onMainThread: await withoutWorkers(() => prepareAndDigest({ layout: 'indexed' })) };
  },

  async hatchImages() {
    const options = { size: 64, tones: 5, seed: 3 };
    const hashes = async () => {
      const { images } = await runTask('generateHatchImages', options);
      return Promise.all(images.flat().map((image) => hashOf(image as Uint8Array<ArrayBuffer>)));
    };
    return { inWorker: await hashes(), onMainThread: await withoutWorkers(hashes) };
  },

  async death() {
    const torus = largeTorus();
    const before = await digest(torus);
    const error = await prepareHatchingGeometry(torus, { createWorker: () => new DyingWorker() }).then(
      () => 'resolved',
      (reason: Error) => reason.message,
    );
    const after = await digest(torus);
    const again = await prepareHatchingGeometry(torus);
    return { before, error, after, triangles: again.userData.hatching.triangles };
  },

  /** Begins a request in a worker that closes itself while it works. */
  async closing() {
    const workers: Worker[] = [];
    let onClosing: () => void = () => {};
    const closing = new Promise<void>((resolve) => {
      onClosing = resolve;
    });
    const createWorker = () => {
      const worker = workers.length === 0 ? new ClosingWorker() : new BakeWorker();
      workers.push(worker);
      worker.addEventListener('message', ({ data }) => data.type === 'alive' && onClosing());
      return worker;
    };
    const silenced = prepareHatchingGeometry(largeTorus(), { createWorker }).then(
      () => 'resolved',
      (reason: Error) => reason.message,
    );
    await closing;
    Object.assign(workerTests, {
      async closed() {
        const error = await silenced;
        const next = await prepareHatchingGeometry(new BoxGeometry(), { createWorker });
        return { error, triangles: next.userData.hatching.triangles as number, workers: workers.length };
      },
    });
  },

  async closed(): Promise<{ error: string; triangles: number; workers: number }> {
    throw new Error('call closing() first');
  },

  async turns() {
    const order: string[] = [];
    const torus = prepareHatchingGeometry(largeTorus()).then(() => order.push('torus'));
    const box = prepareHatchingGeometry(new BoxGeometry()).then(() => order.push('box'));
    await Promise.all([torus, box]);
    return { order, workersMade };
  },

  async abort() {
    const controller = new AbortController();
    const progress: number[] = [];
    const error = await prepareHatchingGeometry(largeTorus(), {
      signal: controller.signal,
      onProgress: (value) => {
        progress.push(value);
        controller.abort();
      },
    }).then(
      () => 'resolved',
      (reason: Error) => reason.name,
    );
    const next = await prepareHatchingGeometry(new BoxGeometry());
    return { error, progress, triangles: next.userData.hatching.triangles, workersMade };
  },

  async badInput() {
    const geometry = new BoxGeometry();
    geometry.attributes.position.setX(3, Number.NaN);
    return prepareHatchingGeometry(geometry).then(
      () => 'resolved',
      (reason: Error) => `${reason instanceof RangeError} ${reason.message}`,
    );
  },
};

declare global {
  interface Window {
    workerTests: typeof workerTests;
  }
}
window.workerTests = workerTests;
