import { Group } from 'three';
import { expect, test, vi } from 'vitest';
import { ShownModel } from '../../../../src/playground/viewport/ShownModel.js';
import type { HatchedModel } from '../../../../src/viewer/drawing/HatchedModel.js';
import { DEFAULT_VIEW } from '../../../../src/viewer/sceneSetup/LensCamera.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';

/** A model without meshes, and what was done to it. */
function fakeModel(name: string) {
  const root = Object.assign(new Group(), { name });
  const maps: unknown[] = [];
  return {
    ...{ root, maps, dispose: vi.fn(), releaseGraphics: vi.fn(), apply: vi.fn() },
    *applying() {
      yield;
      yield;
    },
    set tonalArtMap(map: unknown) {
      maps.push(map);
    },
  };
}

type FakeModel = ReturnType<typeof fakeModel>;
const asModel = (model: FakeModel) => model as unknown as HatchedModel;

function stageOf(...names: string[]) {
  const holder = new Group();
  const onChange = vi.fn();
  const shown = new ShownModel(holder, onChange);
  const models = names.map(fakeModel);
  const disposed = (): string[] => models.filter(({ dispose }) => dispose.mock.calls.length > 0).map(nameOf);
  const seen = (): string[] => holder.children.map(({ name }) => name);
  return { shown, models, onChange, seen, disposed };
}

const nameOf = ({ root }: FakeModel): string => root.name;

test('a model is kept until its replacement has been drawn', () => {
  const { shown, models, onChange, seen, disposed } = stageOf('first', 'second', 'third');
  const [first, second, third] = models.map(asModel);
  shown.set(first);
  expect(onChange).toHaveBeenLastCalledWith('another', DEFAULT_VIEW);
  shown.set(second, [0, 0, 1]);
  expect(onChange).toHaveBeenLastCalledWith('another', [0, 0, 1]);
  expect(seen()).toEqual(['second']);
  expect(disposed()).toEqual([]);
  // One that was not drawn meanwhile does not keep those before it.
  shown.set(third);
  expect(disposed()).toEqual(['first']);
  shown.disposePrevious();
  expect(disposed()).toEqual(['first', 'second']);
  expect(shown.model).toBe(third);
});

test('a baked model replaces its placeholder and the previous model', () => {
  const { shown, models, onChange, seen, disposed } = stageOf('before', 'placeholder', 'other placeholder', 'model');
  const [before, placeholder, other, model] = models.map(asModel);
  shown.set(before);
  shown.setPlaceholder(placeholder);
  expect(onChange).toHaveBeenLastCalledWith('another', DEFAULT_VIEW);
  shown.disposePrevious();
  shown.setPlaceholder(other);
  expect(onChange).toHaveBeenCalledTimes(3);
  expect(onChange).toHaveBeenLastCalledWith('another', DEFAULT_VIEW);
  expect(shown.isPlaceholder).toBe(true);
  shown.disposePrevious();
  expect(disposed()).toEqual(['placeholder']);
  shown.set(model);
  expect(onChange).toHaveBeenLastCalledWith('completed', DEFAULT_VIEW);
  expect(shown.isPlaceholder).toBe(false);
  expect(seen()).toEqual(['model']);
  shown.disposePrevious();
  expect(disposed()).toEqual(['before', 'placeholder', 'other placeholder']);
});

test('a model does not complete another model’s placeholder', () => {
  const { shown, models, onChange, disposed } = stageOf('placeholder', 'other');
  shown.setPlaceholder(asModel(models[0]));
  shown.set(asModel(models[1]), DEFAULT_VIEW, false);
  expect(onChange).toHaveBeenLastCalledWith('another', DEFAULT_VIEW);
  expect(shown.isPlaceholder).toBe(false);
  shown.disposePrevious();
  expect(disposed()).toEqual(['placeholder']);
});

test('if a bake fails, the previous model returns with its framing and the latest map', () => {
  const { shown, models, onChange, seen, disposed } = stageOf('before', 'placeholder');
  const [before, placeholder] = models.map(asModel);
  shown.removePlaceholder();
  expect(onChange).not.toHaveBeenCalled();
  shown.set(before, [1, 0, 0]);
  shown.setPlaceholder(placeholder, [0, 1, 0]);
  const map = {} as never;
  shown.tonalArtMap = map;
  expect(models[0].maps).toEqual([]);
  shown.releaseGraphics();
  expect(models.map(({ releaseGraphics }) => releaseGraphics.mock.calls.length)).toEqual([1, 1]);
  shown.removePlaceholder();
  expect(onChange).toHaveBeenLastCalledWith('back', [1, 0, 0]);
  expect(models[0].maps).toEqual([map]);
  expect(seen()).toEqual(['before']);
  shown.disposePrevious();
  expect(disposed()).toEqual(['placeholder']);
});

test('a failed placeholder of the first model leaves nothing behind', () => {
  const { shown, models, seen, disposed } = stageOf('placeholder');
  shown.setPlaceholder(asModel(models[0]));
  shown.removePlaceholder();
  expect(seen()).toEqual([]);
  expect(shown.model).toBeUndefined();
  shown.disposePrevious();
  expect(disposed()).toEqual(['placeholder']);
});

test('a model gets its look before it is shown, unless that is cancelled', async () => {
  const { shown, models } = stageOf('first', 'second');
  const [first, second] = models;
  const map = {} as never;
  const look = lookOf(defaultSettings());
  shown.apply(look);
  shown.tonalArtMap = map;
  const applying = vi.spyOn(first, 'applying');
  await shown.dress(asModel(first), new AbortController().signal);
  expect(applying).toHaveBeenCalledWith(look);
  expect(first.maps).toEqual([map]);
  expect(shown.model).toBeUndefined();
  await expect(shown.dress(asModel(second), AbortSignal.abort(new Error('enough')))).rejects.toThrow('enough');
});

test('the object before the first model is disposed of once the model has been drawn', () => {
  const { shown, models, seen, disposed } = stageOf('warmUp', 'first', 'second');
  const [warmUp, first, second] = models.map(asModel);
  shown.setWarmUp(warmUp);
  const look = lookOf(defaultSettings());
  shown.apply(look);
  expect(models[0].apply).toHaveBeenCalledWith(look);
  expect([shown.model, shown.drawn, seen()]).toEqual([undefined, warmUp, ['warmUp']]);
  shown.setPlaceholder(first);
  expect([shown.model, shown.drawn, seen(), disposed()]).toEqual([first, first, ['first'], []]);
  // The placeholder was not drawn: it does not keep what was drawn before it.
  shown.set(second);
  expect([seen(), disposed()]).toEqual([['second'], ['warmUp']]);
  shown.disposePrevious();
  expect(disposed()).toEqual(['warmUp', 'first']);
});
