import { BufferGeometry, Group } from 'three';
import { beforeEach, describe, expect, test, vi } from 'vitest';
import { GeometryLoader } from '../../../../src/playground/loading/bakeLoaders.js';
import { TaskRunner } from '../../../../src/playground/tasks/TaskRunner.js';
import { bakeFurther } from '../../../../src/viewer/drawing/bakeFurther.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';
import { fakeStatus } from '../tasks/fakeStatus.js';

vi.mock('../../../../src/viewer/drawing/bakeFurther.js', () => ({ bakeFurther: vi.fn() }));

const begun = vi.mocked(bakeFurther);

beforeEach(() => {
  begun.mockReset();
  begun.mockResolvedValue();
});

/** A page that shows a model, and how to change its settings: what is to be baked then is baked at once. */
function makePage(changes: Partial<Settings>) {
  const settings: Settings = { ...defaultSettings(), ...changes };
  const { status } = fakeStatus();
  const frames = { fadeIntoNext: vi.fn(), invalidate: vi.fn(), keepPictures: vi.fn(), leavePictures: vi.fn() };
  const viewport = {
    model: { root: new Group(), lacksAdjacency: false },
    shown: { isPlaceholder: false },
    quality: { isOnPage: true },
    frames,
    rebuildPrograms: vi.fn(),
    reapply: vi.fn(),
  };
  const tasks = new TaskRunner(status, { hasDrawing: () => true, onIdle: () => {} });
  const form = new GeometryLoader(viewport as never, settings, tasks);
  const change = async (changed: Partial<Settings>): Promise<number> => {
    Object.assign(settings, changed);
    form.update();
    await form.settled(new AbortController().signal);
    return begun.mock.calls.length;
  };
  return { change, viewport, form };
}

test('form strokes are baked for every shape, and strokes that follow the light are not', async () => {
  const { change } = makePage({ technique: 'hatching', direction: 'light' });
  expect(await change({})).toBe(0);
  expect(await change({ direction: 'form' })).toBe(1);
  expect(begun.mock.calls[0][1].form).toMatchObject({ auto: false });
  expect(await change({ direction: 'acrossForm' })).toBe(1);
  expect(await change({ direction: 'form', technique: 'stipple' })).toBe(1);
});

test('at another angle lines are baked again, and strokes are not', async () => {
  const { change } = makePage({ technique: 'hatching', direction: 'form', crossAngle: 60 });
  expect(await change({})).toBe(1);
  expect(await change({ technique: 'engraving' })).toBe(1);
  expect(await change({ crossAngle: 70 })).toBe(2);
  expect(await change({ technique: 'hatching' })).toBe(2);
  expect(await change({ crossAngle: 80 })).toBe(2);
  expect(await change({ technique: 'engraving' })).toBe(3);
  expect(begun.mock.lastCall![1].form?.crossAngle).toBeCloseTo((80 / 180) * Math.PI);
});

test('strokes have the form baked for all shapes, even next to lines that do so only for some', async () => {
  const { change } = makePage({ technique: 'engraving', direction: 'auto' });
  expect(await change({})).toBe(1);
  expect(begun.mock.lastCall![1].form?.auto).toBe(true);
  expect(await change({ compare: 'hatching', direction: 'form' })).toBe(2);
  expect(begun.mock.lastCall![1].form?.auto).toBe(false);
});

test('each geometry fades into the next one, which frees what was made before it and nothing else', async () => {
  const { change, viewport, form } = makePage({ technique: 'engraving', direction: 'form', crossAngle: 60 });
  const geometries = [0, 1, 2, 3].map(() => new BufferGeometry());
  const freed: number[] = [];
  for (const [i, geometry] of geometries.entries()) geometry.addEventListener('dispose', () => freed.push(i));
  let drawn = 0;
  begun.mockImplementation(async (_root, _form, _options, onBaked, onExchanged) => {
    onBaked(geometries[drawn], geometries[++drawn]);
    onExchanged?.();
    onBaked(geometries[drawn], geometries[drawn]);
    onExchanged?.();
  });
  await change({});
  expect(freed).toEqual([]);
  await change({ crossAngle: 70 });
  await change({ crossAngle: 80 });
  expect(freed).toEqual([1, 2]);
  expect(viewport.frames.fadeIntoNext).toHaveBeenCalledTimes(6);
  // Programs that the next geometry asks for are built before it is drawn, not in its frame.
  expect(viewport.rebuildPrograms).toHaveBeenCalledTimes(6);
  viewport.model = { root: new Group(), lacksAdjacency: false };
  form.update();
  expect(freed).toEqual([1, 2, 3]);
});

test('bakes once after a slider has stopped', async () => {
  const { change, form, viewport } = makePage({ technique: 'engraving', direction: 'form', crossAngle: 60 });
  expect(await change({})).toBe(1);
  const changes = [70, 75, 80].map((crossAngle) => change({ crossAngle }));
  await Promise.all(changes);
  expect(begun.mock.calls.map(([, { form }]) => Math.round((form!.crossAngle / Math.PI) * 180))).toEqual([60, 80]);
  expect([form.isAwaited, viewport.rebuildPrograms.mock.calls.length]).toEqual([false, 0]);
});

describe('adjacency', () => {
  /** A page whose model gets adjacency when it is baked, if that is asked for. */
  function pageWithout(changes: Partial<Settings>) {
    const made = makePage(changes);
    const { viewport } = made;
    viewport.model.lacksAdjacency = true;
    begun.mockImplementation(async (_root, { adjacency }) => {
      if (adjacency) viewport.model.lacksAdjacency = false;
    });
    return made;
  }

  test('is baked once a technique asks for it, also for a comparison, and then the look is applied again', async () => {
    const { change, viewport } = pageWithout({ technique: 'hatching' });
    expect(await change({})).toBe(0);
    expect(await change({ compare: 'adjacencyCrisp' })).toBe(1);
    expect(begun.mock.lastCall![1]).toEqual({ form: undefined, adjacency: true });
    expect(viewport.reapply).toHaveBeenCalledTimes(1);
    expect(await change({ technique: 'triangle', compare: 'none' })).toBe(1);
  });

  test('keeps the form that was baked before, which is not baked again', async () => {
    const { change, viewport } = pageWithout({ technique: 'engraving', direction: 'form', crossAngle: 60 });
    expect(await change({})).toBe(1);
    expect(begun.mock.lastCall![1].adjacency).toBe(false);
    expect(viewport.reapply).not.toHaveBeenCalled();
    expect(await change({ technique: 'adjacency', crossAngle: 70 })).toBe(2);
    expect(begun.mock.lastCall![1].adjacency).toBe(true);
    expect(begun.mock.lastCall![1].form?.crossAngle).toBeCloseTo(Math.PI / 3);
    expect(await change({ technique: 'engraving', crossAngle: 60 })).toBe(2);
  });

  test('is baked once, and again after another request', async () => {
    const { change } = pageWithout({ technique: 'adjacency' });
    begun.mockRejectedValue(new Error('no memory'));
    expect(await change({})).toBe(1);
    expect(await change({ crossAngle: 70 })).toBe(1);
    expect(await change({ technique: 'hatching' })).toBe(1);
    expect(await change({ technique: 'adjacency' })).toBe(2);
  });
});
