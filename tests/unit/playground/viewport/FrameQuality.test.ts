import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { FrameQuality } from '../../../../src/playground/viewport/FrameQuality.js';
import { fakeFences } from './fakeFences.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Frames of a renderer whose graphics card has drawn them when the test says so. */
function createQuality() {
  const gl = fakeFences();
  const renderer = { getContext: () => gl.context, getPixelRatio: () => 1, setPixelRatio: () => {} };
  const host = { isPlaceholder: () => false, refine: vi.fn(), onSketched: () => {} };
  const quality = new FrameQuality(renderer as never, host);
  /** Draws a frame that takes so many milliseconds. */
  const draw = async (milliseconds: number): Promise<void> => {
    gl.begin();
    quality.measure(() => {}, false);
    await vi.advanceTimersByTimeAsync(milliseconds);
    gl.finish();
    await vi.advanceTimersByTimeAsync(20);
  };
  return { gl, quality, host, draw };
}

test('the graphics card is busy while it draws a frame of unknown length, or a long one, and not with quick ones', async () => {
  const { gl, quality, draw } = createQuality();
  expect(quality.isBusy).toBe(false);
  quality.measure(() => {}, false);
  await vi.advanceTimersByTimeAsync(300);
  expect(quality.isBusy).toBe(true);
  gl.finish();
  await vi.advanceTimersByTimeAsync(20);
  expect([quality.isBusy, quality.milliseconds! >= 300]).toEqual([false, true]);

  quality.restart();
  for (let i = 0; i < 3; i++) await draw(5);
  gl.begin();
  quality.measure(() => {}, false);
  expect(quality.isBusy).toBe(false);
});

test('a restart does not count the graphics card as idle', async () => {
  const { gl, quality } = createQuality();
  quality.measure(() => {}, false);
  quality.restart();
  await vi.advanceTimersByTimeAsync(100);
  expect(quality.isBusy).toBe(true);
  gl.finish();
  await vi.advanceTimersByTimeAsync(20);
  expect(quality.isBusy).toBe(false);
});

test('a lost context does not block frames', async () => {
  const { gl, quality } = createQuality();
  quality.measure(() => {}, false);
  gl.lose();
  await vi.advanceTimersByTimeAsync(20);
  expect(quality.isBusy).toBe(false);
});

test('after a movement a frame in full resolution is asked for, and drawn so though frames of the movement took longer than the pause', async () => {
  const { gl, quality, host } = createQuality();
  const move = async (isMoving: boolean): Promise<number> => {
    gl.begin();
    let share = 0;
    quality.measure(() => (share = quality.share), isMoving);
    await vi.advanceTimersByTimeAsync(600);
    gl.finish();
    await vi.advanceTimersByTimeAsync(20);
    return share;
  };
  for (let i = 0; i < 4; i++) await move(true);
  expect(host.refine).toHaveBeenCalled();
  expect(await move(false)).toBe(1);
});
