import { afterEach, expect, test, vi } from 'vitest';
import { EditHistory } from '../../../../src/viewer/settings/EditHistory.js';

afterEach(() => vi.useRealTimers());

/** A history of a number, and what changes it. */
function counter() {
  vi.useFakeTimers({ toFake: ['performance'] });
  let value = 0;
  let press: number | undefined;
  const history = new EditHistory(
    () => value,
    (a, b) => a === b,
    () => press,
  );
  return {
    history,
    press: (next: number | undefined) => {
      press = next;
    },
    change(source: string, wait = 0) {
      vi.advanceTimersByTime(wait);
      value++;
      history.changed(source);
    },
    /** The values that Undo goes back to, one after the other. */
    undone() {
      const values: number[] = [];
      for (let next = history.undo(); next !== undefined; next = history.undo()) {
        value = next;
        values.push(next);
      }
      return values;
    },
  };
}

test('one drag is one step, however long it pauses; the next is another, however soon it comes', () => {
  const { change, press, undone } = counter();
  press(1);
  change('lamp');
  change('lamp', 5000);
  change('lamp', 60_000);
  press(2);
  change('lamp', 50);
  change('lamp', 5000);
  expect(undone()).toEqual([3, 0]);
});

test('one press that changes two things is two steps', () => {
  const { change, press, undone } = counter();
  press(1);
  change('lamp');
  change('camera');
  expect(undone()).toEqual([1, 0]);
});

test('quick changes by keys or the wheel are one step', () => {
  const { change, undone } = counter();
  change('camera');
  change('camera', 300);
  change('camera', 2000);
  change('lamp', 10);
  expect(undone()).toEqual([3, 2, 0]);
});

test('a change after Undo leaves nothing to redo', () => {
  const { history, change } = counter();
  change('lamp');
  expect(history.undo()).toBe(0);
  expect(history.canRedo).toBe(true);
  change('camera');
  expect([history.canRedo, history.redo()]).toEqual([false, undefined]);
});

test('steps that lead to the present state are skipped', () => {
  let value = 0;
  const history = new EditHistory(
    () => value,
    (a, b) => a === b,
  );
  for (const next of [1, 2, 2]) {
    value = next;
    history.changed();
  }
  expect(history.undo()).toBe(1);
});
