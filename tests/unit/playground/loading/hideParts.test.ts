import { Group } from 'three';
import { beforeEach, describe, expect, test, vi } from 'vitest';
import { ModelLoader } from '../../../../src/playground/loading/ModelLoader.js';
import { TaskRunner } from '../../../../src/playground/tasks/TaskRunner.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { NO_CHOICE } from '../../../../src/viewer/settings/shareLink.js';
import { fakeStatus } from '../tasks/fakeStatus.js';

const NAMES = ['Top', 'Leg', 'Box'];
const joined = {
  ...{ kind: 'mesh', name: 'a.obj', upAxis: 'y', notes: [], details: [], changes: [], missing: [], pictures: [] },
  mesh: { positions: new Float32Array(9), indices: new Uint32Array(3), parts: { names: NAMES } },
  plainNormals: null,
};

/** Each build that was started, and how it ends. */
const builds = vi.hoisted(() => [] as { hidden: readonly number[]; end(): void }[]);
vi.hoisted(() => Object.assign(globalThis, { document: { title: '', documentElement: { dataset: {} } } }));
vi.mock('../../../../src/playground/page/page.js', () => ({ page: { lamp: { hidden: true } } }));
vi.mock('../../../../src/playground/loading/ModelCaption.js', () => ({
  ModelCaption: class {
    show(): void {}
  },
}));
vi.mock('../../../../src/playground/reading/loadModelFiles.js', () => ({ loadModelFiles: async () => joined }));
vi.mock('../../../../src/playground/loading/lightModel.js', () => ({
  FileLights: class {
    light(): void {}
    lookThroughCamera(): void {}
    viewsOf = () => ({ views: [], notes: [] });
  },
}));
vi.mock('../../../../src/viewer/drawing/buildModel.js', () => ({
  buildModel: (_: unknown, __: unknown, signal: AbortSignal, ___: unknown, choose: (names: string[]) => number[]) =>
    new Promise((resolve, reject) => {
      const hidden = choose(NAMES);
      signal.addEventListener('abort', () => reject(signal.reason));
      const model = {
        ...{ root: new Group(), extras: { variants: [], cameras: [] }, statistics: { triangles: 1, borderEdges: 0 } },
        ...{ parts: { names: NAMES, hidden }, dispose: vi.fn() },
      };
      builds.push({ hidden, end: () => resolve({ model, notes: [] }) });
    }),
}));

function createLoader() {
  const viewport = {
    model: undefined as unknown,
    shown: {
      isPlaceholder: false,
      drawn: {},
      dress: async () => {},
      set: (model: unknown) => {
        viewport.model = model;
      },
      replace: (model: unknown) => {
        viewport.model = model;
      },
    },
    frames: { fadeIntoNext() {}, invalidate() {} },
    view: { ownPlace: undefined, frame() {} },
    partsChanged: vi.fn(),
  };
  const events: string[] = [];
  const status = fakeStatus();
  const tasks = new TaskRunner(status.status, { hasDrawing: () => true, onIdle() {} });
  const loader = new ModelLoader(viewport as never, defaultSettings(), tasks, (end) => void events.push(end));
  return { loader, viewport, tasks, events };
}

/** Longer than the code of the techniques takes to load. */
const STUCK_MILLISECONDS = 30_000;

const until = (holds: () => void) => vi.waitFor(holds, STUCK_MILLISECONDS);
const started = (count: number) => until(() => expect(builds).toHaveLength(count));

async function shown() {
  const made = createLoader();
  const loaded = made.loader.showFiles([{ name: 'a.obj', content: new Blob() }]);
  await started(1);
  builds[0].end();
  await loaded;
  return made;
}

beforeEach(() => {
  builds.length = 0;
});

describe('parts of a joined mesh', () => {
  test('are hidden by building it anew; they count as hidden from the request on', async () => {
    const { loader, events } = await shown();
    expect(loader.hide([0, 2])).toBe(true);
    expect([loader.hidden, loader.choice.hidden]).toEqual([
      [0, 2],
      [0, 2],
    ]);
    await started(2);
    expect(builds[1].hidden).toEqual([0, 2]);
    builds[1].end();
    await until(() => expect(events).toEqual(['opened', 'hidden']));
    expect(loader.hidden).toEqual([0, 2]);
    expect(loader.hide([0, 2])).toBe(false);
    expect(loader.hide([0, 2, 9])).toBe(false);
  });

  test('the latest request counts', async () => {
    const { loader, events } = await shown();
    loader.hide([0]);
    await started(2);
    loader.hide([1]);
    await started(3);
    builds[1].end();
    builds[2].end();
    await until(() => expect(events).toEqual(['opened', 'hidden']));
    expect(loader.hidden).toEqual([1]);
  });

  test('are shown again if the user cancels', async () => {
    const { loader, tasks, events } = await shown();
    loader.hide([0]);
    await started(2);
    tasks.stop('model');
    await until(() => expect(tasks.isIdle).toBe(true));
    loader.hide([1]);
    await started(3);
    (tasks as unknown as { cancel(): void }).cancel();
    await until(() => expect(events).toEqual(['opened', 'hidden']));
    expect([loader.hidden, loader.choice.hidden]).toEqual([[], undefined]);
  });

  test('stay as they are while another model is read', async () => {
    const { loader } = await shown();
    void loader.showFiles([{ name: 'b.obj', content: new Blob() }]);
    await started(2);
    expect(loader.hide([0])).toBe(false);
  });

  test('are hidden as soon as the model is shown, if they are asked for while it is read', async () => {
    const { loader, events } = createLoader();
    const files = [{ name: 'a.obj', content: new Blob() }];
    const loaded = loader.showFiles(files);
    await started(1);
    loader.restore({ model: 'file', files, choice: { ...NO_CHOICE, hidden: [1] } }, true);
    builds[0].end();
    await loaded;
    await started(2);
    builds[1].end();
    await until(() => expect(events.at(-1)).toBe('hidden'));
    expect(loader.hidden).toEqual([1]);
  });
});
