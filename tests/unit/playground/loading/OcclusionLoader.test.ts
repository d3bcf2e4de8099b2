import { BoxGeometry, Group, InstancedMesh, Mesh } from 'three';
import { expect, test, vi } from 'vitest';
import { OcclusionLoader } from '../../../../src/playground/loading/bakeLoaders.js';
import { TaskRunner } from '../../../../src/playground/tasks/TaskRunner.js';
import { bakeOcclusion } from '../../../../src/viewer/drawing/bakeOcclusion.js';
import { eventually } from '../../patience.js';
import { fakeStatus } from '../tasks/fakeStatus.js';

vi.mock('../../../../src/viewer/drawing/bakeOcclusion.js', () => ({
  bakeOcclusion: vi.fn(() => new Promise(() => {})),
}));

/** How many bakes are begun for a model of these meshes, however often the settings change. */
function bakesOf(...meshes: Mesh[]): number {
  const run = vi.fn();
  const quality = { isOnPage: false };
  const viewport = { model: { root: new Group().add(...meshes) }, shown: { isPlaceholder: false }, quality };
  const loader = new OcclusionLoader(viewport as never, { occlusion: 50 } as never, { run, stop: vi.fn() } as never);
  loader.update();
  expect(run, 'before the model was drawn').not.toHaveBeenCalled();
  quality.isOnPage = true;
  loader.update();
  loader.update();
  return run.mock.calls.length;
}

const box = new BoxGeometry();

test('occlusion is baked once, and not for models of instances alone, which cannot store it', () => {
  expect(bakesOf(new Mesh(box))).toBe(1);
  expect(bakesOf(new InstancedMesh(box, undefined, 2), new Mesh(box))).toBe(1);
  expect(bakesOf(new InstancedMesh(box, undefined, 2))).toBe(0);
});

test('the occlusion bake waits for tasks that were started later', async () => {
  const tasks = new TaskRunner(fakeStatus().status, { hasDrawing: () => true, onIdle: () => {} });
  const model = { root: new Group().add(new Mesh(box)) };
  const viewport = { model, shown: { isPlaceholder: false }, quality: { isOnPage: true } };
  new OcclusionLoader(viewport as never, { occlusion: 50 } as never, tasks).update();
  await eventually(() => expect(bakeOcclusion).toHaveBeenCalled());
  const { pause } = vi.mocked(bakeOcclusion).mock.lastCall![1]!;
  expect(pause!()).toBeUndefined();
  void tasks.run('map', () => new Promise(() => {}));
  const waiting = pause!();
  expect(waiting).toBeInstanceOf(Promise);
  tasks.stop('map');
  await waiting;
  expect(pause!()).toBeUndefined();
});

test('finer occlusion is drawn step by step with quick frames, and once at the end with slow ones', async () => {
  const framesOf = async (isSlow: boolean): Promise<number[]> => {
    const refine = vi.fn();
    const viewport = {
      model: { root: new Group().add(new Mesh(box)) },
      shown: { isPlaceholder: false },
      quality: { isOnPage: true, isSlow },
      frames: { refine },
    };
    const drawn: number[] = [];
    vi.mocked(bakeOcclusion).mockImplementationOnce(async (_root, options) => {
      for (let pass = 0; pass < 3; pass++) {
        options!.onPass!({} as never);
        drawn.push(refine.mock.calls.length);
      }
      return { dispose: vi.fn() } as never;
    });
    const tasks = new TaskRunner(fakeStatus().status, { hasDrawing: () => true, onIdle: () => {} });
    new OcclusionLoader(viewport as never, { occlusion: 50 } as never, tasks).update();
    await eventually(() => expect(tasks.isIdle).toBe(true));
    return [...drawn, refine.mock.calls.length];
  };
  expect(await framesOf(false)).toEqual([1, 2, 3, 4]);
  expect(await framesOf(true)).toEqual([0, 0, 0, 1]);
});
