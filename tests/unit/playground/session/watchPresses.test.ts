import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { watchPresses } from '../../../../src/playground/session/watchPresses.js';

let page: EventTarget;

beforeEach(() => {
  page = new EventTarget();
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
});

afterEach(() => void vi.unstubAllGlobals());

const tell = (type: string, isPrimary = true) => page.dispatchEvent(Object.assign(new Event(type), { isPrimary }));

test('each press has a number, which is there until it ends', () => {
  const press = watchPresses();
  expect(press()).toBeUndefined();
  tell('pointerdown');
  expect([press(), press()]).toEqual([1, 1]);
  tell('pointerup');
  expect(press()).toBeUndefined();
  tell('pointerdown');
  expect(press()).toBe(2);
  tell('pointercancel');
  expect(press()).toBeUndefined();
});

test('of several fingers only the first counts', () => {
  const press = watchPresses();
  tell('pointerdown');
  tell('pointerdown', false);
  expect(press()).toBe(1);
  tell('pointerup', false);
  expect(press()).toBe(1);
  tell('pointerup');
  expect(press()).toBeUndefined();
});
