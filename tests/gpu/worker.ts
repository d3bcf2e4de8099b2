import bunny from 'bunny';
import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  DirectionalLight,
  Float32BufferAttribute,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  TorusGeometry,
  WebGLRenderer,
} from 'three';
import {
  applyHatching,
  HatchingMaterial,
  learnHand,
  learnHandAsync,
  type PrepareHatchingGeometryOptions,
  prepareHatchingGeometry,
  traceStrokes,
} from 'three-hatching';
import BakeWorker from '../../src/worker/bake.worker.js?worker';
import HandWorker from '../../src/worker/hand.worker.js?worker';
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

/** Counts the workers that the page creates, and can disable workers on the page. */
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

function bunnyGeometry(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(bunny.positions.flat(), 3));
  geometry.setIndex(bunny.cells.flat());
  return geometry;
}

async function prepareAndDigest(options?: PrepareHatchingGeometryOptions, geometry = bunnyGeometry()) {
  const prepared = await prepareHatchingGeometry(geometry, options);
  return { digest: await digest(prepared), statistics: prepared.userData.hatching, bounds: prepared.boundingSphere };
}

// Pictures do not matter here, so warnings about missing maps and light are off.
HatchingMaterial.silent = true;

const largeTorus = () => new TorusGeometry(1, 0.4, 300, 300);

/** Sets the number of cores that the page sees. */
const pretendCores = (count: number) =>
  Object.defineProperty(navigator, 'hardwareConcurrency', { value: count, configurable: true });

/** 300 houses of 12 colours, each a geometry of its own; 600,000 triangles. */
function city(): Scene {
  const scene = new Scene();
  const materials = Array.from({ length: 12 }, (_, i) => new MeshStandardMaterial({ color: 0x202020 + 0x0a0b0c * i }));
  for (let i = 0; i < 300; i++) {
    const height = 1 + (i % 7) / 3;
    const house = new BoxGeometry(0.8, height, 0.8, 13, 12 + (i % 3), 13);
    const mesh = new Mesh(house, materials[i % materials.length]);
    mesh.position.set((i % 20) - 10, height / 2, Math.floor(i / 20) - 7);
    scene.add(mesh);
  }
  return scene.add(new DirectionalLight());
}

const digestsOf = (scene: Scene) =>
  Promise.all(scene.children.flatMap((child) => (child instanceof Mesh ? [digest(child.geometry)] : [])));

const workerTests = {
  async city() {
    pretendCores(3);
    const [whole, cancelled, alone] = [city(), city(), city()];
    const counts: string[] = [];
    await applyHatching(whole, { tonalArtMap: null, onGeometry: (done, total) => counts.push(`${done} of ${total}`) });
    const workersOfCity = workersMade;
    const renderer = new WebGLRenderer();
    renderer.setSize(64, 64, false);
    const camera = new PerspectiveCamera(60, 1, 0.1, 100);
    camera.position.set(0, 14, 30);
    camera.lookAt(0, 0, 0);
    renderer.render(whole, camera);
    const { programs, render } = renderer.info;
    const drawn = { programs: programs!.length, calls: render.calls };
    renderer.dispose();

    const controller = new AbortController();
    const error = await applyHatching(cancelled, {
      tonalArtMap: null,
      signal: controller.signal,
      onGeometry: (done) => done === 20 && controller.abort(),
    }).then(
      () => 'resolved',
      (reason: Error) => reason.name,
    );
    const isUntouched = cancelled.children.every(
      (child) => !(child instanceof Mesh) || child.geometry.userData.hatching === undefined,
    );
    pretendCores(1);
    disposeHatchingWorkers();
    await applyHatching(alone, { tonalArtMap: null });
    const [inSeveral, inOne] = [await digestsOf(whole), await digestsOf(alone)];
    return {
      counts: [counts.length, counts[0], counts.at(-1)],
      workersOfCity,
      drawn,
      error,
      isUntouched,
      areEqual: JSON.stringify(inSeveral) === JSON.stringify(inOne),
    };
  },

  async bunny() {
    const inWorker = await prepareAndDigest({ adjacency: true });
    const workersForWorker = workersMade;
    const inOwnWorker = await prepareAndDigest({ createWorker: () => new BakeWorker(), adjacency: true });
    const onMainThread = await withoutWorkers(() => prepareAndDigest({ adjacency: true }));
    return { inWorker, workersForWorker, inOwnWorker, onMainThread, workersMade };
  },

  async bunnyIndexed() {
    const inWorker = await prepareAndDigest({ layout: 'indexed' });
    return { inWorker, onMainThread: await withoutWorkers(() => prepareAndDigest({ layout: 'indexed' })) };
  },

  async capsule() {
    const prepare = () => prepareAndDigest({ weldTolerance: 1e-5 }, new CapsuleGeometry(1, 1, 16, 64));
    return { inWorker: await prepare(), onMainThread: await withoutWorkers(prepare) };
  },

  async hatchImages() {
    const options = { size: 64, tones: 5, seed: 3 };
    const hashes = async () => {
      const { images } = await runTask('generateHatchImages', options);
      return Promise.all(images.flat().map((image) => hashOf(image as Uint8Array<ArrayBuffer>)));
    };
    return { inWorker: await hashes(), onMainThread: await withoutWorkers(hashes) };
  },

  /** Strokes that a canvas has drawn, a photograph of which was read back, and the hand that has drawn them. */
  async tracing() {
    const sheet = Object.assign(document.createElement('canvas'), { width: 360, height: 240 });
    const context = sheet.getContext('2d', { willReadFrequently: true })!;
    context.fillStyle = '#e8e2d0';
    context.fillRect(0, 0, 360, 240);
    context.lineWidth = 6;
    context.lineCap = 'round';
    for (const [x, y] of [...Array(9).keys()].map((i) => [30 + 30 * i, 200])) {
      context.moveTo(x, y);
      context.lineTo(x + 60, y - 160);
    }
    context.moveTo(40, 120);
    context.lineTo(330, 100);
    context.stroke();
    const photograph = await createImageBitmap(
      await new Promise<Blob>((resolve) => sheet.toBlob((blob) => resolve(blob!))),
    );
    context.drawImage(photograph, 0, 0);
    const trace = () => traceStrokes(context.getImageData(0, 0, 360, 240), { millimetresPerPixel: 1 });
    const workersBefore = workersMade;
    const inWorker = await trace();
    const workers = workersMade - workersBefore;
    const createWorker = () => new HandWorker();
    const inOwnWorker = await traceStrokes(context.getImageData(0, 0, 360, 240), {
      millimetresPerPixel: 1,
      createWorker,
    });
    return {
      workers,
      inWorker,
      inOwnWorker,
      onMainThread: await withoutWorkers(trace),
      learnt: learnHand(inWorker),
      learntInWorker: await learnHandAsync(inWorker),
      learntOnMainThread: await withoutWorkers(() => learnHandAsync(inWorker)),
    };
  },

  async death() {
    const torus = largeTorus();
    const before = await digest(torus);
    const expected = await prepareAndDigest({}, torus);
    const died = await prepareAndDigest({ createWorker: () => new DyingWorker() }, torus);
    return { before, after: await digest(torus), expected, died };
  },

  /** Sends a request to a worker that closes itself while it works, then another to the worker that replaces it. */
  async closing() {
    let workers = 0;
    const createWorker = () => (workers++ === 0 ? new ClosingWorker() : new BakeWorker());
    const prepared = await prepareHatchingGeometry(largeTorus(), { createWorker });
    const next = await prepareHatchingGeometry(new BoxGeometry(), { createWorker });
    return { triangles: [prepared, next].map(({ userData }) => userData.hatching.triangles as number), workers };
  },

  async turns() {
    pretendCores(1);
    const order: string[] = [];
    const torus = prepareHatchingGeometry(largeTorus(), { adjacency: true }).then(() => order.push('torus'));
    const box = prepareHatchingGeometry(new BoxGeometry(), { adjacency: true }).then(() => order.push('box'));
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
    return prepareHatchingGeometry(geometry, { adjacency: true }).then(
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
