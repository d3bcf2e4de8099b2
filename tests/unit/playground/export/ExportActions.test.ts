import { Group } from 'three';
import { beforeEach, expect, test, vi } from 'vitest';
import { ExportActions } from '../../../../src/playground/export/ExportActions.js';
import { saveFiner } from '../../../../src/playground/export/saveFiner.js';
import { drawForClipboard } from '../../../../src/playground/export/savePicture.js';
import { GeometryLoader } from '../../../../src/playground/loading/bakeLoaders.js';
import { TaskRunner } from '../../../../src/playground/tasks/TaskRunner.js';
import { bakeFurther } from '../../../../src/viewer/drawing/bakeFurther.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { eventually } from '../../patience.js';
import { fakeStatus } from '../tasks/fakeStatus.js';

vi.mock('../../../../src/viewer/drawing/bakeFurther.js', () => ({ bakeFurther: vi.fn() }));
vi.mock('../../../../src/playground/export/savePicture.js', () => ({
  drawForClipboard: vi.fn(async () => new Blob()),
  savePicture: vi.fn(async () => ({ kind: 'PNG', size: '10 × 20 px', pixelsPerRadius: 1000 })),
}));
vi.mock('../../../../src/playground/export/saveFiner.js', () => ({
  saveFiner: vi.fn(() => async () => 'Saved finer.'),
}));

/** The bakes that were begun, each with a function that ends it. */
const bakes: { end: () => void; report: (progress: number) => void }[] = [];

beforeEach(() => {
  bakes.length = 0;
  vi.mocked(drawForClipboard).mockClear();
  vi.mocked(bakeFurther).mockImplementation(
    (_, _form, { signal, onProgress }) =>
      new Promise((resolve, reject) => {
        bakes.push({ end: () => resolve(), report: onProgress });
        signal.addEventListener('abort', () => reject(signal.reason));
      }),
  );
});

const FILES: readonly never[] = [];

/** A page with a model whose lines follow the form, or the light, and which was drawn or not. */
function makePage(
  direction: 'form' | 'light' = 'form',
  isOnPage = true,
  simplified?: { triangles: number; error: number },
) {
  const line = fakeStatus();
  const tasks = new TaskRunner(line.status, { hasDrawing: () => true, onIdle: () => {} });
  const model = { root: new Group() };
  const quality = { isOnPage };
  const frames = { invalidate: () => {}, keepPictures: () => {}, leavePictures: () => {} };
  const viewport = { model, shown: { isPlaceholder: false }, quality, isComplete: true, frames };
  const settings = { ...defaultSettings(), technique: 'engraving' as const, direction };
  const session = { viewport, settings, modelLoader: { shown: { title: 'A model', simplified, files: FILES } } };
  const form = new GeometryLoader(viewport as never, settings, tasks);
  const actions = new ExportActions(session as never, {} as never, line.status, tasks, form);
  return { line, viewport, settings, form, actions };
}

const drawn = vi.mocked(drawForClipboard);

test('a picture waits for form lines, and shows their progress', async () => {
  const { line, form, actions } = makePage();
  form.update();
  const picture = actions.drawPicture();
  await eventually(() => expect(bakes).toHaveLength(1));
  bakes[0].report(0.5);
  expect([line.text, line.isWorking]).toEqual(['Laying lines along the form…', true]);
  // Time enough for a picture that does not wait.
  await vi.dynamicImportSettled();
  expect(drawn).not.toHaveBeenCalled();
  bakes[0].end();
  await picture;
  expect(drawn).toHaveBeenCalledOnce();
});

test('a picture begins the bake if the first frame has not, and one of lines around the light waits for none', async () => {
  const { form, actions } = makePage('form', false);
  form.update();
  const picture = actions.drawPicture();
  await eventually(() => expect(bakes).toHaveLength(1));
  expect(drawn).not.toHaveBeenCalled();
  bakes[0].end();
  await picture;
  expect(drawn).toHaveBeenCalledOnce();
  await makePage('light').actions.drawPicture();
  expect(bakes).toHaveLength(1);
});

test('a picture for which another model was opened waits for the lines of that one', async () => {
  const { viewport, form, actions } = makePage();
  form.update();
  const picture = actions.drawPicture();
  await eventually(() => expect(bakes).toHaveLength(1));
  viewport.model = { root: new Group() };
  form.update();
  await eventually(() => expect(bakes).toHaveLength(2));
  expect(drawn).not.toHaveBeenCalled();
  bakes[1].end();
  await picture;
  expect(drawn).toHaveBeenCalledOnce();
});

test('a picture is drawn even if form lines fail, but not if the user cancels', async () => {
  const failing = makePage();
  vi.mocked(bakeFurther).mockRejectedValueOnce(new Error('no field'));
  await failing.actions.drawPicture();
  expect(drawn).toHaveBeenCalledOnce();
  const { line, actions } = makePage();
  const picture = actions.drawPicture();
  await eventually(() => expect(bakes).toHaveLength(1));
  line.cancel();
  await expect(picture).rejects.toThrow('status line');
  expect(drawn).toHaveBeenCalledOnce();
});

test('a picture in which a simplified model is seen to be simplified can be saved from more triangles', async () => {
  const { line, actions } = makePage('light', true, { triangles: 10_000_000, error: 0.0012 });
  await actions.savePng();
  expect([line.text, line.isError, line.remedy]).toEqual([
    'Saved as PNG, simplified: up to 1.2 px off.',
    false,
    'Save finer',
  ]);
  line.mend();
  await eventually(() => expect(line.text).toBe('Saved finer.'));
  expect(saveFiner).toHaveBeenCalledExactlyOnceWith(FILES, { asWritten: undefined, variant: undefined });
  expect(line.remedy).toBeUndefined();
});

test.each([undefined, { triangles: 10_000_000, error: 0.0003 }])(
  'a picture as exact as its pixels is saved with its size in words: %o',
  async (simplified) => {
    const { line, actions } = makePage('light', true, simplified);
    await actions.savePng();
    expect([line.text, line.remedy]).toEqual(['Saved as PNG: 10 × 20 px.', undefined]);
  },
);
