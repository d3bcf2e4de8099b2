import { expect, test, vi } from 'vitest';
import { freeName, SavedViews } from '../../../../src/playground/savedLooks/SavedViews.js';
import { type CameraView, MAX_VIEWS } from '../../../../src/viewer/settings/CameraView.js';
import type { Look } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';

const NEAR: CameraView = { position: [0, 0, 2], target: [0, 0, 0] };

/** The views of a drawing, on a viewport that notes what is done to it and in which light. */
function onStage() {
  const settings = { ...defaultSettings(), lightAzimuth: 10 };
  const done: [what: string, lightAzimuth: number][] = [];
  let lit = settings.lightAzimuth;
  let place: CameraView | undefined;
  const view = {
    get ownPlace() {
      return place;
    },
    set place(next: CameraView) {
      place = next;
      done.push(['placed', lit]);
    },
    frame: () => {
      place = undefined;
      done.push(['framed', lit]);
    },
  };
  const apply = (_look: Look): void => {
    lit = settings.lightAzimuth;
  };
  const onChange = vi.fn();
  const views = new SavedViews({ view, apply } as never, settings, onChange);
  return { views, view, settings, done, onChange };
}

test('a view brings back its camera and its light, which is there before the model is framed', () => {
  const { views, view, settings, done } = onStage();
  views.add('Whole');
  view.place = NEAR;
  settings.lightAzimuth = 70;
  views.add('Near');
  expect([views.isShown(0), views.isShown(1)]).toEqual([false, true]);
  done.length = 0;
  views.choose(0);
  expect([settings.lightAzimuth, done]).toEqual([10, [['framed', 10]]]);
  expect([views.isShown(0), views.isShown(1)]).toEqual([true, false]);
  views.choose(1);
  expect([settings.lightAzimuth, done.at(-1), view.ownPlace]).toEqual([70, ['placed', 70], NEAR]);
  // The camera of the one in the light of the other is neither.
  settings.lightAzimuth = 10;
  expect([views.isShown(0), views.isShown(1)]).toEqual([false, false]);
  const { length } = done;
  views.choose(7);
  expect(done).toHaveLength(length);
});

test('views are named, renamed and deleted; a name of nothing is none; each change makes another list', () => {
  const { views, onChange } = onStage();
  const { list } = views;
  views.add('  ');
  views.add('From\nabove');
  expect(views.items).toEqual([
    { name: 'View 1', key: '1' },
    { name: 'From above', key: '2' },
  ]);
  expect(list).toEqual([]);
  const before = views.list;
  views.rename(1, '\t');
  views.rename(0, 'Left');
  expect(views.items.map(({ name }) => name)).toEqual(['Left', 'From above']);
  expect(before.map(({ name }) => name)).toEqual(['View 1', 'From above']);
  views.remove(0);
  expect(views.items).toEqual([{ name: 'From above', key: '1' }]);
  expect(onChange).toHaveBeenCalledTimes(5);
});

test('there are as many as there are digits', () => {
  const { views } = onStage();
  for (let i = 0; i < MAX_VIEWS; i++) {
    expect(views.isFull, String(i)).toBe(false);
    views.add('');
  }
  expect(views.isFull).toBe(true);
  expect(new Set(views.items.map(({ name }) => name)).size).toBe(MAX_VIEWS);
});

test('a name that is free is none of those that are taken', () => {
  expect(freeName('View', [])).toBe('View 1');
  expect(freeName('View', [{ name: 'View 2' }])).toBe('View 3');
  expect(freeName('View', [{ name: 'a' }, { name: 'View 3' }])).toBe('View 4');
});
