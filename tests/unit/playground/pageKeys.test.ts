import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { isShortcut, listenToKeys, type PageKeys } from '../../../src/playground/pageKeys.js';

let isDialogOpen: boolean;
let press: (event: object) => void;

/** An element that is within a field, or not. */
class FakeElement {
  constructor(
    private readonly field: string | undefined,
    readonly type = 'text',
  ) {}

  closest(selector: string): object | null {
    if (this.field === 'range') return null;
    return this.field !== undefined && selector.includes(this.field) ? this : null;
  }
}

class FakeInput extends FakeElement {}

beforeEach(() => {
  isDialogOpen = false;
  vi.stubGlobal('Element', FakeElement);
  vi.stubGlobal('HTMLInputElement', FakeInput);
  vi.stubGlobal('document', {
    querySelector: (selector: string) => (selector === 'dialog[open]' && isDialogOpen ? {} : null),
  });
  vi.stubGlobal('addEventListener', (_: string, listener: typeof press) => {
    press = listener;
  });
});

afterEach(() => void vi.unstubAllGlobals());

const NO_MODIFIERS = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: false };
const DRAWING = new FakeElement(undefined);
const keyEvent = (key: string, more: object = {}) =>
  ({ key, target: DRAWING, ...NO_MODIFIERS, preventDefault: vi.fn(), ...more }) as unknown as KeyboardEvent;

test('a letter is a shortcut outside of fields and lists, without a modifier, and under no dialog', () => {
  expect(isShortcut(keyEvent('f'), 'f')).toBe(true);
  expect(isShortcut(keyEvent('F', { shiftKey: true }), 'f')).toBe(true);
  expect(isShortcut(keyEvent('g'), 'f')).toBe(false);
  for (const modifier of ['ctrlKey', 'metaKey', 'altKey']) {
    expect(isShortcut(keyEvent('f', { [modifier]: true }), 'f'), modifier).toBe(false);
  }
  for (const field of ['input', 'select', 'textarea']) {
    expect(isShortcut(keyEvent('f', { target: new FakeElement(field) }), 'f'), field).toBe(false);
  }
  expect(isShortcut(keyEvent('f', { target: new FakeElement('range') }), 'f'), 'a slider').toBe(true);
  isDialogOpen = true;
  expect(isShortcut(keyEvent('f'), 'f')).toBe(false);
});

/** What the keys of a page do, in the order in which it is done. */
function listen(more: Partial<PageKeys> = {}): unknown[] {
  const done: unknown[] = [];
  const note = (what: string) => () => void done.push(what);
  listenToKeys({
    close: note('close'),
    fillScreen: note('fillScreen'),
    showAnotherView: note('showAnotherView'),
    openKeys: note('openKeys'),
    showView: (index) => done.push(index),
    undo: note('undo'),
    redo: note('redo'),
    ...more,
  });
  return done;
}

test('each key does what it is for, and digits show the views that they number', () => {
  const done = listen();
  for (const key of ['f', 'v', '1', '9', '?', 'h', 'F1', 'Escape', 'q', '0']) press(keyEvent(key));
  expect(done).toEqual(['fillScreen', 'showAnotherView', 0, 8, 'openKeys', 'openKeys', 'openKeys', 'close']);
});

test('Escape closes an open dialog alone', () => {
  const done = listen();
  isDialogOpen = true;
  press(keyEvent('Escape'));
  expect(done).toEqual([]);
});

test('Undo and Redo have the keys of every system, but not in text fields or under a dialog', () => {
  const done = listen();
  const ctrlKey = { ctrlKey: true };
  const metaKey = { metaKey: true };
  const shiftKey = { shiftKey: true };
  for (const [key, modifiers] of [
    ['z', ctrlKey],
    ['z', metaKey],
    ['Z', { ...ctrlKey, ...shiftKey }],
    ['Z', { ...metaKey, ...shiftKey }],
    ['y', ctrlKey],
  ] as const) {
    const event = keyEvent(key, modifiers);
    press(event);
    expect(event.preventDefault, key).toHaveBeenCalledOnce();
  }
  expect(done).toEqual(['undo', 'undo', 'redo', 'redo', 'redo']);
  for (const more of [{}, shiftKey, { ...ctrlKey, altKey: true }, { ...ctrlKey, target: new FakeInput('input') }]) {
    press(keyEvent('z', more));
  }
  // Of a browser, it opens the list of what was visited.
  press(keyEvent('y', metaKey));
  isDialogOpen = true;
  press(keyEvent('z', ctrlKey));
  expect(done).toHaveLength(5);
  isDialogOpen = false;
  press(keyEvent('z', { ...ctrlKey, target: new FakeInput('range', 'range') }));
  expect(done.at(-1)).toBe('undo');
});
