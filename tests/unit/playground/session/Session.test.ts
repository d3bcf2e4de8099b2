import { beforeEach, expect, test, vi } from 'vitest';
import type { ModelEnd, OpenedModel } from '../../../../src/playground/loading/ModelLoader.js';
import { Session } from '../../../../src/playground/session/Session.js';
import type { Look } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import type { ModelChoice } from '../../../../src/viewer/settings/shareLink.js';

type OnModel = (end: ModelEnd, opened?: OpenedModel) => void;

const loaders = vi.hoisted(() => ({
  onModel: undefined as OnModel | undefined,
  showMap: vi.fn(),
  restore: vi.fn(),
  changeModel: vi.fn(),
}));
vi.mock('../../../../src/playground/loading/ModelLoader.js', () => ({
  ModelLoader: class {
    ownFiles = undefined;
    address = undefined;
    choice = { variant: undefined, clip: undefined };
    clip = 0;
    restore = loaders.restore;
    changeModel = loaders.changeModel;
    constructor(_scene: unknown, _settings: unknown, _tasks: unknown, onChange: OnModel) {
      loaders.onModel = onChange;
    }
  },
}));
vi.mock('../../../../src/playground/loading/MapLoader.js', () => ({
  MapLoader: class {
    showChosen = loaders.showMap;
    tileScale = 1;
    hand = undefined;
  },
}));
// Nothing is pressed: there is no page.
vi.mock('../../../../src/playground/session/watchPresses.js', () => ({ watchPresses: () => () => undefined }));

beforeEach(() => void vi.clearAllMocks());

/** A session on a viewport that only remembers what was applied, and the events that the session has told. */
function createSession() {
  const place = { position: [0, 0, 5], target: [0, 0, 0] };
  const view = {
    state: { ...place, framedFor: 'page' as string | undefined },
    ownPlace: undefined,
    frame: vi.fn(),
    onMoved: () => {},
  };
  const applied: string[] = [];
  const viewport = { view, apply: ({ drawn }: Look) => void applied.push(drawn.ink as string), isComplete: true };
  const session = new Session(viewport as never, defaultSettings(), {} as never);
  const events: string[] = [];
  session.listen({
    applied: () => void events.push('applied'),
    moved: () => void events.push('moved'),
    stepped: () => void events.push(`stepped ${session.canUndo} ${session.canRedo}`),
    modelShown: () => void events.push('modelShown'),
  });
  session.start();
  events.length = 0;
  return { session, view, applied, events };
}

test('a change is applied before it becomes a step, and undone and redone as a whole', () => {
  const { session, applied, events } = createSession();
  const { ink } = session.settings;
  session.change({ ink: '#123456', paper: '#ffffff' });
  expect(events).toEqual(['applied', 'stepped true false']);
  expect(applied.at(-1)).toBe('#123456');
  session.undo();
  expect(session.settings.ink).toBe(ink);
  session.redo();
  expect([session.settings.ink, session.settings.paper]).toEqual(['#123456', '#ffffff']);
  expect(events.slice(2)).toEqual(['applied', 'stepped false true', 'applied', 'stepped true false']);
});

test('changes of the view caused by settings belong to the same step', () => {
  const { session, view } = createSession();
  const near = { ...view.state };
  const far = { position: [0, 0, 9], target: [0, 0, 0], framedFor: 'sheet' };
  let isFirst = true;
  session.listen({
    applied: () => {
      if (isFirst) view.state = far;
      isFirst = false;
    },
  });
  session.change({ ink: '#111111' });
  session.change({ ink: '#222222' });
  view.state = near;
  session.undo();
  expect([session.settings.ink, view.state]).toEqual(['#111111', far]);
});

test('Undo brings back the views that the drawing had, and the camera from which a look was seen', () => {
  const { session, view } = createSession();
  const { settings } = session;
  session.views.add('From above');
  const [kept] = session.views.list;
  expect([kept.name, session.canUndo]).toEqual(['From above', true]);
  const own = { position: [3, 0, 0], target: [0, 0, 0], framedFor: undefined };
  view.state = own;
  view.onMoved();
  const near = { position: [0, 0, 2], target: [0, 0, 0], framedFor: undefined };
  const look = { settings: { ...settings, ink: '#111111' }, camera: near, views: [], hand: undefined };
  session.showLook(look as never);
  session.recordChange();
  expect([session.views.list, view.state]).toEqual([[], near]);
  session.undo();
  expect([session.views.list, view.state]).toEqual([[kept], own]);
  session.redo();
  expect([session.views.list, view.state]).toEqual([[], near]);
  session.undo();
  session.undo();
  session.undo();
  expect([session.views.list, session.canUndo]).toEqual([[], false]);
});

test('a look without a camera is framed with what it has made of the drawing', () => {
  const { session, view, applied } = createSession();
  const inks: (string | undefined)[] = [];
  view.frame.mockImplementation(() => void inks.push(applied.at(-1)));
  session.showLook({
    settings: { ...session.settings, ink: '#123456' },
    camera: undefined,
    views: [],
    hand: undefined,
  });
  expect(inks).toEqual(['#123456']);
});

test('a moved camera is a step of its own, which applies no settings', () => {
  const { view, events } = createSession();
  view.onMoved();
  expect(events).toEqual(['stepped true false', 'moved']);
});

test('settings on which the map depends have it loaded, others have not', () => {
  const { session } = createSession();
  session.settingChanged('ink');
  expect(loaders.showMap).not.toHaveBeenCalled();
  session.settingChanged('mapSeed');
  session.settingChanged('technique');
  expect(loaders.showMap).toHaveBeenCalledTimes(2);
  expect(loaders.changeModel).not.toHaveBeenCalled();
  session.settingChanged('model');
  expect(loaders.changeModel).toHaveBeenCalledTimes(1);
});

test('a model that the user opens is a step; one that the settings ask for, and one that fails, is none', () => {
  const { session, events } = createSession();
  loaders.onModel!('restored');
  loaders.onModel!('failed');
  expect([session.canUndo, events]).toEqual([false, ['modelShown', 'applied', 'applied']]);
  loaders.onModel!('opened', { isOther: true, drawing: undefined, views: [] });
  expect([session.canUndo, events.slice(3)]).toEqual([true, ['modelShown', 'applied', 'stepped true false']]);
});

test('another model leaves the views of its file and none of the one before; the same one with more pictures keeps them', () => {
  const { session } = createSession();
  const view = { name: 'From above', camera: undefined, light: {} as never };
  session.views.list = [view];
  loaders.onModel!('opened', { isOther: false, drawing: undefined, views: [] });
  expect(session.views.list).toEqual([view]);
  const ofFile = { ...view, name: 'hero' };
  loaders.onModel!('opened', { isOther: true, drawing: undefined, views: [ofFile] });
  expect(session.views.list).toEqual([ofFile]);
  loaders.onModel!('opened', { isOther: true, drawing: undefined, views: [] });
  expect(session.views.list).toEqual([]);
});

test('a model that comes with its look is drawn so, and the look cannot choose another model', () => {
  const { session } = createSession();
  session.settings.model = 'file';
  const link = new URLSearchParams({ ink: '#7a2e1d', model: 'cube' }).toString();
  loaders.onModel!('opened', { isOther: true, drawing: { link, strokes: [] } as never, views: [] });
  expect([session.settings.ink, session.settings.model]).toEqual(['#7a2e1d', 'file']);
});

test('where a state had files that are gone, the model that is shown stays', () => {
  const choice = { variant: 1, clip: undefined };
  const { session } = createSession();
  const { model } = session.settings;
  session.showState({
    settings: { ...defaultSettings(), model: 'file', ink: '#00ff00' },
    hand: undefined,
    camera: undefined,
    files: undefined,
    views: [],
    choice,
  });
  expect([session.settings.model, session.settings.ink]).toEqual([model, '#00ff00']);
  expect(loaders.restore).toHaveBeenCalledWith({ model, files: undefined, choice }, true);
});

test('a variant and a clip that were chosen are in the link, and undone and redone', () => {
  const { session } = createSession();
  const loader = session.modelLoader as unknown as { choice: ModelChoice };
  const { link } = session;
  for (const choice of [
    { variant: 1, clip: undefined },
    { variant: 1, clip: 2 },
  ]) {
    loader.choice = choice;
    session.recordChange();
  }
  const both = new URLSearchParams(session.link);
  expect([both.get('variant'), both.get('clip')]).toEqual(['2', '3']);
  loaders.restore.mockImplementation(({ choice }: { choice: ModelChoice }) => void Object.assign(loader, { choice }));
  session.undo();
  expect(loader.choice).toEqual({ variant: 1, clip: undefined });
  session.undo();
  expect(session.link).toBe(link);
  session.redo();
  session.redo();
  expect(loader.choice).toEqual({ variant: 1, clip: 2 });
});

test('forgotten steps cannot be undone', () => {
  const { session, events } = createSession();
  session.change({ ink: '#123456' });
  session.forgetSteps();
  expect([session.canUndo, events.at(-1)]).toEqual([false, 'stepped false false']);
});
