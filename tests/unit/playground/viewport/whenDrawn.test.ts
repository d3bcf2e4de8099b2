import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { whenDrawn } from '../../../../src/playground/viewport/graphicsCard.js';
import { fakeFences } from './fakeFences.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Whether `whenDrawn` has resolved. */
function watch(context: WebGL2RenderingContext): () => Promise<boolean> {
  let isDrawn = false;
  void whenDrawn(context).then(() => {
    isDrawn = true;
  });
  return async () => {
    await vi.advanceTimersByTimeAsync(1000);
    return isDrawn;
  };
}

test('resolves when the fence is signalled and not before, and deletes the fence', async () => {
  const gl = fakeFences();
  const isDrawn = watch(gl.context);
  expect(gl.isFlushed).toBe(true);
  expect(await isDrawn()).toBe(false);
  gl.finish();
  expect([await isDrawn(), gl.fences.size]).toEqual([true, 0]);
});

test('resolves when the context is lost: while it waits, before it begins, and where it comes back at once', async () => {
  const gl = fakeFences();
  const isDrawn = watch(gl.context);
  gl.lose();
  expect(await isDrawn()).toBe(true);
  expect(await watch(gl.context)()).toBe(true);
  gl.restore();
  const isDrawnAgain = watch(gl.context);
  gl.lose();
  gl.restore();
  expect(await isDrawnAgain()).toBe(true);
});
