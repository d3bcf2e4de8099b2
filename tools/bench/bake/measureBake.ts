import { PhaseClock } from '../PhaseClock.js';
import { bakeByPhase } from './bakeByPhase.js';
import { loadMesh } from './loadMesh.js';
import SwapWorker from './swap.worker.js?worker';

/**
 * Bakes as often as `repeats` says, by phase, on the page's main thread; the first bake includes the time of compiling. Then hands the
 * request to a worker and takes the result of the `corner` layout from it, which is the phase `transfer`.
 */
export async function measureBake(model: string, repeats: number) {
  const mesh = await loadMesh(model);
  const triangles = mesh.indices.length / 3;
  const worker = new SwapWorker();
  const clocks: PhaseClock[] = [];
  let stepsPerTriangle = 0;
  for (let repeat = 0; repeat < repeats; repeat++) {
    const clock = new PhaseClock();
    const { corner, steps } = bakeByPhase(mesh, clock.run);
    const request = [mesh.positions.slice().buffer, mesh.indices.slice().buffer];
    await swap(worker, buffersOf(corner));
    const start = performance.now();
    await swap(worker, request);
    clock.times.transfer = performance.now() - start;
    clocks.push(clock);
    stepsPerTriangle = steps / triangles;
  }
  worker.terminate();
  return {
    triangles,
    times: clocks.map(({ times }) => times),
    longestSteps: clocks.map(({ longestStep }) => longestStep),
    /** Visits of hash slots and half-edges. */
    stepsPerTriangle,
  };
}

function swap(worker: Worker, buffers: ArrayBuffer[]): Promise<void> {
  return new Promise((resolve) => {
    worker.onmessage = () => resolve();
    worker.postMessage(buffers, buffers);
  });
}

const buffersOf = (result: object): ArrayBuffer[] =>
  Object.values(result)
    .filter((value) => ArrayBuffer.isView(value))
    .map(({ buffer }) => buffer as ArrayBuffer);
