import { Vector3 } from 'three';
import { describe, expect, test, vi } from 'vitest';
import { recordVideo } from '../../../../src/playground/video/recordVideo.js';
import { LostContextError } from '../../../../src/playground/viewport/ContextLoss.js';
import type { PictureSession } from '../../../../src/playground/viewport/PictureSession.js';
import type { Viewport } from '../../../../src/playground/viewport/Viewport.js';
import { createCamera } from '../../../../src/viewer/sceneSetup/LensCamera.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

/** A viewport without a browser. @param drawPart what drawing the nth frame does */
function fakeStage(drawPart: (frame: number, canvas: EventTarget) => void = () => {}) {
  const canvas = Object.assign(new EventTarget(), {
    toBlob: (take: (blob: Blob) => void) => take(new Blob(['frame'])),
  });
  let frames = 0;
  const camera = createCamera();
  camera.position.set(0, 1, 4);
  const picture = {
    ...{ hold: vi.fn(), release: vi.fn(), begin: vi.fn(), end: vi.fn() },
    drawPart: vi.fn(() => drawPart(frames++, canvas)),
  };
  const viewport = {
    ...{ canvas, camera, model: undefined, isLost: false, outdateShadows: vi.fn() },
    view: { isFramed: false, controls: { target: new Vector3() } },
    scenery: { lights: { apply: vi.fn(), place: vi.fn() } },
  };
  const record = (changes: Partial<Settings> = {}) =>
    recordVideo(
      viewport as unknown as Viewport,
      picture as unknown as PictureSession,
      { ...defaultSettings(), videoForm: 'frames', videoSeconds: 1, videoRate: '12', ...changes },
      {
        ...{ view: { width: 900, height: 600 }, name: 'cube', signal: new AbortController().signal },
        ...{ onProgress: () => {}, onFrame: () => {} },
      },
    );
  return { viewport, picture, canvas, record };
}

describe('recordVideo', () => {
  test('holds the frames of the page for a video of a size, which shadows are as fine as', async () => {
    const { viewport, picture, record } = fakeStage();
    expect((await record({ videoSize: '3840x2160' })).sentence).toMatch(/^Saved: 3,840 × 2,160 px/);
    expect(picture.hold.mock.calls).toEqual([[3840]]);
    expect(picture.drawPart).toHaveBeenCalledTimes(12);
    expect(picture.release).toHaveBeenCalledTimes(1);
    expect(viewport.camera.position.toArray()).toEqual([0, 1, 4]);
  });

  test.each<[string, (frame: number, canvas: EventTarget) => void]>([
    [
      'noticed by the frame that is drawn',
      (frame) => {
        if (frame === 5) throw new LostContextError();
      },
    ],
    [
      'and back again before the next frame',
      (frame, canvas) => void (frame === 5 && canvas.dispatchEvent(new Event('webglcontextlost'))),
    ],
  ])(
    'a graphics context that is lost, %s, is said for what it is, and no frame is taken for whole',
    async (_, draw) => {
      const { picture, record } = fakeStage(draw);
      const failure = await record().catch((error) => error);
      expect(failure).toBeInstanceOf(LostContextError);
      expect(failure.message).toMatch(
        /let go of the drawing after 5 of 12 frames\. There is no video; record it again/,
      );
      expect(picture.end).toHaveBeenCalledTimes(1);
      expect(picture.release).toHaveBeenCalledTimes(1);
    },
  );

  test('an encoder that goes with the graphics card is not taken for the cause; another failure stays what it is', async () => {
    const { viewport, canvas, record } = fakeStage();
    Object.assign(canvas, {
      toBlob: (take: (blob: null) => void) => {
        viewport.isLost = true;
        take(null);
      },
    });
    await expect(record()).rejects.toThrow(/let go of the drawing after 0 of 12 frames/);
    viewport.isLost = false;
    Object.assign(canvas, { toBlob: (take: (blob: null) => void) => take(null) });
    await expect(record()).rejects.toThrow('The browser could not pack a frame as PNG; choose smaller frames.');
  });
});
