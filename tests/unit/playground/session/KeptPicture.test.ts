import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { KeptPicture } from '../../../../src/playground/session/KeptPicture.js';
import { fakeFences } from '../viewport/fakeFences.js';

const PICTURE = 'data:image/webp;base64,AA==';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A drawing at rest, on a graphics card that has not drawn it yet, and what is read of it. */
function createPicture() {
  const gl = fakeFences();
  const toDataURL = vi.fn(() => PICTURE);
  const drawImage = vi.fn();
  vi.stubGlobal('document', { createElement: () => ({ toDataURL, getContext: () => ({ drawImage }) }) });
  const viewport = {
    isComplete: true,
    frames: { isWaiting: false, redraw: () => true, canvas: { width: 300, height: 200 }, count: 0 },
    quality: { isCoarse: false },
    shown: { isPlaceholder: false },
    context: gl.context,
  };
  const taken: string[] = [];
  const picture = new KeptPicture(
    viewport as never,
    () => true,
    (pending) => void pending.then((address) => taken.push(address)),
  );
  return { gl, viewport, toDataURL, drawImage, taken, picture };
}

test('the drawing is copied in the task of its frame, and read only when the graphics card has drawn it', async () => {
  const { gl, toDataURL, drawImage, taken, picture } = createPicture();
  picture.want();
  expect(drawImage).toHaveBeenCalledTimes(1);
  await vi.advanceTimersByTimeAsync(1000);
  expect([toDataURL.mock.calls.length, taken]).toEqual([0, []]);
  gl.finish();
  await vi.advanceTimersByTimeAsync(1000);
  expect([toDataURL.mock.calls.length, taken]).toEqual([1, [PICTURE]]);
});

test('a drawing that is not final waits for a later frame, and is read once', async () => {
  const { gl, viewport, drawImage, taken, picture } = createPicture();
  gl.finish();
  viewport.quality.isCoarse = true;
  picture.want();
  picture.frameDrawn();
  expect(drawImage).not.toHaveBeenCalled();
  viewport.quality.isCoarse = false;
  viewport.shown.isPlaceholder = true;
  picture.frameDrawn();
  expect(drawImage).not.toHaveBeenCalled();
  viewport.shown.isPlaceholder = false;
  picture.frameDrawn();
  picture.frameDrawn();
  await vi.advanceTimersByTimeAsync(1000);
  expect([drawImage.mock.calls.length, taken]).toEqual([1, [PICTURE]]);
});

test('is not read while later frames are drawn, for which reading would wait', async () => {
  const { gl, viewport, toDataURL, picture } = createPicture();
  gl.finish();
  picture.want();
  for (let i = 0; i < 5; i++) {
    viewport.frames.count++;
    await vi.advanceTimersByTimeAsync(10);
  }
  expect(toDataURL).not.toHaveBeenCalled();
  await vi.advanceTimersByTimeAsync(30);
  expect(toDataURL).toHaveBeenCalledTimes(1);
});
