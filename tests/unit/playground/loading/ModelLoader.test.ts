import { BufferAttribute, BufferGeometry, Group } from 'three';
import { beforeEach, expect, test, vi } from 'vitest';
import { type ModelEnd, ModelLoader } from '../../../../src/playground/loading/ModelLoader.js';
import type { LoadOptions } from '../../../../src/playground/reading/loadModelFiles.js';
import { TaskRunner } from '../../../../src/playground/tasks/TaskRunner.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { NO_CHOICE } from '../../../../src/viewer/settings/shareLink.js';
import { fakeStatus } from '../tasks/fakeStatus.js';

/** How each started load ends, in order. */
const loads = vi.hoisted(() => [] as { options: LoadOptions; end(read: unknown): void; fail(error: Error): void }[]);
vi.hoisted(() => Object.assign(globalThis, { document: { title: 'at first', documentElement: { dataset: {} } } }));
vi.mock('../../../../src/playground/page/page.js', () => ({ page: { lamp: { hidden: true } } }));
vi.mock('../../../../src/playground/loading/ModelCaption.js', () => ({
  ModelCaption: class {
    content: unknown;
    show(content: unknown): void {
      this.content = content;
    }
  },
}));
vi.mock('../../../../src/playground/reading/loadModelFiles.js', () => ({
  loadModelFiles: (_files: unknown, options: LoadOptions) =>
    new Promise((end, fail) => {
      options.signal.addEventListener('abort', () => fail(options.signal.reason));
      loads.push({ options, end, fail });
    }),
}));
vi.mock('../../../../src/playground/loading/lightModel.js', () => ({
  FileLights: class {
    light(): void {}
    lookThroughCamera(): void {}
    viewsOf = () => ({ views: [], notes: [] });
  },
}));
vi.mock('../../../../src/playground/viewport/graphicsCard.js', () => ({ afterFrame: async () => {} }));
vi.mock('../../../../src/viewer/drawing/buildModel.js', () => ({
  buildModel: async () => ({ model: built(), notes: [] }),
}));

const statistics = { triangles: 1, borderEdges: 0 };
const built = () => ({ root: new Group(), extras: { variants: [], cameras: [] }, statistics, dispose: vi.fn() });

/** A mesh as a reader returns it, large enough for a placeholder. */
const read = (name: string) => ({
  ...{ kind: 'mesh', name, upAxis: 'z', notes: [], details: [], missing: [], pictures: [], isClosed: true },
  mesh: { positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), normals: null, colors: null, indices: null },
  plainNormals: new Float32Array(9),
});

function createLoader() {
  const shown = {
    isPlaceholder: false,
    drawn: new BufferGeometry().setIndex(new BufferAttribute(new Uint8Array(3), 1)),
  };
  const events: string[] = [];
  const viewport = {
    shown: Object.assign(shown, {
      dress: async () => {},
      set: (_: unknown, __: unknown, hadPlaceholder: boolean) => {
        events.push(`shown${hadPlaceholder ? ' in place of its placeholder' : ''}`);
        shown.isPlaceholder = false;
      },
      setPlaceholder: () => {
        events.push('placeholder');
        shown.isPlaceholder = true;
      },
      removePlaceholder: () => {
        events.push('placeholder removed');
        shown.isPlaceholder = false;
      },
    }),
    frames: { fadeIntoNext() {}, invalidate() {} },
    view: { ownPlace: undefined, frame() {} },
  };
  const settings = defaultSettings();
  const tasks = new TaskRunner(fakeStatus().status, { hasDrawing: () => true, onIdle() {} });
  const loader = new ModelLoader(viewport as never, settings, tasks, (end: ModelEnd) => void events.push(end));
  return { loader, settings, tasks, events };
}

const file = (name: string) => ({ name, content: new Blob() });
const started = (count: number) => vi.waitFor(() => expect(loads).toHaveLength(count));

beforeEach(() => {
  loads.length = 0;
  document.title = 'at first';
});

test('a large mesh is shown as a placeholder first, which the model replaces', async () => {
  const { loader, settings, events } = createLoader();
  const shown = loader.showFiles([file('a.obj')]);
  await started(1);
  loads[0].end(read('a.obj'));
  await shown;
  expect(events).toEqual(['placeholder', 'shown in place of its placeholder', 'opened']);
  expect([settings.model, settings.upAxis, loader.shown.title, document.title]).toEqual([
    ...['file', 'z', 'a.obj', 'a.obj, hatched'],
  ]);
});

test('a load that fails brings back the page before the first placeholder, also of a load that was given up', async () => {
  const { loader, settings, events } = createLoader();
  const first = loader.showFiles([file('a.obj')]);
  await started(1);
  await loads[0].options.onCoarse!(read('a.obj') as never);
  const second = loader.showFiles([file('b.obj')]);
  await started(2);
  await loads[1].options.onCoarse!(read('b.obj') as never);
  expect(document.title).toBe('b.obj, hatched');
  loads[1].fail(new Error('damaged'));
  await Promise.all([first, second]);
  expect(events).toEqual(['placeholder', 'placeholder', 'placeholder removed', 'failed']);
  expect([document.title, settings.upAxis, settings.model, loader.shown.files]).toEqual([
    ...['at first', defaultSettings().upAxis, defaultSettings().model, []],
  ]);
});

test('a model that comes after another was asked for is not shown, nor its placeholder', async () => {
  const { loader, events } = createLoader();
  const first = loader.showFiles([file('a.obj')]);
  await started(1);
  const second = loader.showFiles([file('b.obj')]);
  await started(2);
  await loads[0].options.onCoarse!(read('a.obj') as never);
  loads[0].end(read('a.obj'));
  loads[1].end(read('b.obj'));
  await Promise.all([first, second]);
  expect(events).toEqual(['placeholder', 'shown in place of its placeholder', 'opened']);
  expect(loader.shown.title).toBe('b.obj');
});

test('the model that is shown or being loaded is not loaded again', async () => {
  const { loader } = createLoader();
  const files = [file('a.obj')];
  const shown = loader.showFiles(files);
  await started(1);
  loader.restore({ model: 'file', files, choice: NO_CHOICE }, true);
  loads[0].end(read('a.obj'));
  await shown;
  loader.restore({ model: 'file', files: loader.ownFiles, choice: NO_CHOICE }, true);
  expect(loads).toHaveLength(1);
});
