import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { AddressWriter } from '../../../../src/playground/session/DrawingStore.js';
import type { SessionListener } from '../../../../src/playground/session/Session.js';

/** The window of the page, which is told when the page is left. */
let page: EventTarget;

beforeEach(() => {
  vi.useFakeTimers();
  page = new EventTarget();
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A writer for a session whose state the test sets, and the links that were written. */
function createWriter() {
  const listeners: SessionListener[] = [];
  const modelLoader = { isLoading: false, ownFiles: undefined as unknown, shown: { title: 'bunny' } };
  const session = {
    ...{ modelLoader, link: 'technique=engraving', ownStrokes: undefined },
    settings: { model: 'bunny' },
    viewport: { view: { ownPlace: undefined } },
    listen: (listener: SessionListener) => void listeners.push(listener),
  };
  const address = { isFollowed: false };
  const state = { isOpening: false };
  const written: string[] = [];
  const store = { shown: (_files: unknown, _title: string, link: string) => void written.push(link) };
  const want = vi.fn();
  new AddressWriter(session as never, address as never, store as never, want, () => state.isOpening);
  return { session, modelLoader, address, state, written, want, change: () => listeners[0].applied?.() };
}

test('successive changes are written once, after the last', () => {
  const { change, written, want } = createWriter();
  for (let i = 0; i < 5; i++) {
    change();
    vi.advanceTimersByTime(100);
  }
  expect(written).toEqual([]);
  vi.runAllTimers();
  expect(written).toEqual(['technique=engraving']);
  expect(want, 'a drawing without files of the user').not.toHaveBeenCalled();
});

test('nothing is written while the page shows another drawing than the settings describe', () => {
  const { change, modelLoader, address, state, written } = createWriter();
  for (const [part, name] of [
    [modelLoader, 'isLoading'],
    [address, 'isFollowed'],
    [state, 'isOpening'],
  ] as const) {
    Object.assign(part, { [name]: true });
    change();
    vi.runAllTimers();
    expect(written, name).toEqual([]);
    Object.assign(part, { [name]: false });
  }
  change();
  vi.runAllTimers();
  expect(written).toHaveLength(1);
});

test('a change of the last moment is written when the page is left, and nothing if there was none', () => {
  const { change, written } = createWriter();
  page.dispatchEvent(new Event('pagehide'));
  expect(written).toEqual([]);
  change();
  page.dispatchEvent(new Event('pagehide'));
  expect(written).toHaveLength(1);
  vi.runAllTimers();
  expect(written).toHaveLength(1);
});

test('a thumbnail is stored of a drawing with the user’s files', () => {
  const { session, modelLoader, change, want } = createWriter();
  session.settings.model = 'file';
  modelLoader.ownFiles = [];
  change();
  vi.runAllTimers();
  expect(want).toHaveBeenCalledTimes(1);
});
