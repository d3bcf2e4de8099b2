import { TorusGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { runSliced } from '../../../../src/mesh/runSliced.js';
import { lineTasks } from '../../../../src/vector/drawLines.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import type { ToWorker } from '../../../../src/worker/protocol.js';
import { disposeHatchingWorkers } from '../../../../src/worker/runTask.js';
import { FakeWorker } from '../../worker/FakeWorker.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';

/** A worker that draws, with a copy of its input as in a real worker. */
class DrawingWorker extends FakeWorker {
  /** @param isDeadly whether it dies when it gets a request */
  constructor(private readonly isDeadly: () => boolean) {
    super();
    queueMicrotask(() => this.say({ type: 'ready' }));
  }

  override postMessage(message: ToWorker, transfer: Transferable[]): void {
    super.postMessage(message, transfer);
    if (message.type !== 'run') return;
    if (this.isDeadly()) queueMicrotask(() => this.onerror?.({ message: 'of a drawing' }));
    else void this.draw(message.id);
  }

  private async draw(id: number): Promise<void> {
    const { request } = this.received.at(-1) as { request: Parameters<typeof lineTasks.drawLines.run>[0] };
    const result = await runSliced(lineTasks.drawLines.run(request), {
      onProgress: (progress) => this.say({ type: 'progress', id, progress }),
    });
    this.say({ type: 'done', id, result: structuredClone(result) });
  }
}

const torusScene = async () =>
  sceneOf(await hatchedMesh(new TorusGeometry(0.7, 0.3, 24, 48), { material: { direction: 'light' } }));

describe('a worker draws', () => {
  test('the same bytes as the main thread, with progress from the reading of the scene to the end', async () => {
    const scene = await torusScene();
    const camera = cameraAt(0.4, 1, 2.8);
    const here = await drawSVG(scene, camera);
    let worker: DrawingWorker | undefined;
    const shown: number[] = [];
    const there = await drawSVG(scene, camera, {
      createWorker: () => {
        worker = new DrawingWorker(() => false);
        return FakeWorker.asWorker(worker);
      },
      onProgress: (progress) => shown.push(progress),
    });
    expect(there.svg).toBe(here.svg);
    expect(there.paths).toBe(here.paths);
    expect(worker!.received.length).toBe(1);
    expect(worker!.transferred[0].length).toBeGreaterThan(5);
    expect(shown.some((progress) => progress > 0.1 && progress < 0.9)).toBe(true);
    expect([...shown].sort((a, b) => a - b)).toEqual(shown);
    expect(shown.at(-1)).toBe(1);
  });

  test('again where the first worker dies', async () => {
    const scene = await torusScene();
    let started = 0;
    const drawing = await drawSVG(scene, cameraAt(0.4, 1, 2.8), {
      createWorker: () => {
        started++;
        return FakeWorker.asWorker(new DrawingWorker(() => started === 1));
      },
    });
    expect(started).toBe(2);
    expect(drawing.paths).toBeGreaterThan(50);
  });

  test('and is told of an abort', async () => {
    const controller = new AbortController();
    const worker = new FakeWorker();
    const createWorker = () => {
      setTimeout(() => worker.say({ type: 'ready' }));
      return FakeWorker.asWorker(worker);
    };
    const drawing = drawSVG(await torusScene(), cameraAt(0.4, 1, 2.8), { createWorker, signal: controller.signal });
    while (worker.received.length === 0) await new Promise((resolve) => setTimeout(resolve, 1));
    controller.abort(new Error('enough'));
    await expect(drawing).rejects.toThrow('enough');
    expect(worker.received.map(({ type }) => type)).toEqual(['run', 'abort']);
    disposeHatchingWorkers();
  });
});
