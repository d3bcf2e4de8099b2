import { Vector3 } from 'three';
import { describe, expect, test, vi } from 'vitest';
import { defaultSettings, type Settings } from '../../../../src/demo/settings/settings.js';
import { createCamera } from '../../../../src/demo/stage/createCamera.js';
import type { HatchingScene } from '../../../../src/demo/stage/createScene.js';
import { LostContextError } from '../../../../src/demo/stage/LostContextError.js';
import { recordVideo } from '../../../../src/demo/video/recordVideo.js';

/** A scene without a browser. @param drawPart what drawing the nth frame does */
function fakeScene(drawPart: (frame: number, canvas: EventTarget) => void = () => {}) {
  const canvas = Object.assign(new EventTarget(), {
    toBlob: (take: (blob: Blob) => void) => take(new Blob(['frame'])),
  });
  let frames = 0;
  const camera = createCamera();
  camera.position.set(0, 1, 4);
  const scene = {
    ...{ canvas, camera, model: undefined, isLost: false },
    view: { isFramed: false, controls: { target: new Vector3() } },
    lights: { apply: vi.fn(), place: vi.fn() },
    ...{ hold: vi.fn(), release: vi.fn(), beginPicture: vi.fn(), endPicture: vi.fn(), outdateShadows: vi.fn() },
    drawPart: vi.fn(() => drawPart(frames++, canvas)),
  };
  const record = (changes: Partial<Settings> = {}) =>
    recordVideo(
      scene as unknown as HatchingScene,
      { ...defaultSettings(), videoForm: 'frames', videoSeconds: 1, videoRate: '12', ...changes },
      {
        ...{ view: { width: 900, height: 600 }, name: 'cube', signal: new AbortController().signal },
        ...{ onProgress: () => {}, onFrame: () => {} },
      },
    );
  return { scene, canvas, record };
}

describe('recordVideo', () => {
  test('holds the scene for frames of their size, which shadows are as fine as', async () => {
    const { scene, record } = fakeScene();
    expect((await record({ videoSize: '3840x2160' })).sentence).toMatch(/^Saved: 3,840 × 2,160 px/);
    expect(scene.hold.mock.calls).toEqual([[3840]]);
    expect(scene.drawPart).toHaveBeenCalledTimes(12);
    expect(scene.release).toHaveBeenCalledTimes(1);
    expect(scene.camera.position.toArray()).toEqual([0, 1, 4]);
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
      const { scene, record } = fakeScene(draw);
      const failure = await record().catch((error) => error);
      expect(failure).toBeInstanceOf(LostContextError);
      expect(failure.message).toMatch(
        /let go of the drawing after 5 of 12 frames\. There is no video; record it again/,
      );
      expect(scene.endPicture).toHaveBeenCalledTimes(1);
      expect(scene.release).toHaveBeenCalledTimes(1);
    },
  );

  test('an encoder that goes with the graphics card is not taken for the cause; another failure stays what it is', async () => {
    const { scene, canvas, record } = fakeScene();
    Object.assign(canvas, {
      toBlob: (take: (blob: null) => void) => {
        scene.isLost = true;
        take(null);
      },
    });
    await expect(record()).rejects.toThrow(/let go of the drawing after 0 of 12 frames/);
    scene.isLost = false;
    Object.assign(canvas, { toBlob: (take: (blob: null) => void) => take(null) });
    await expect(record()).rejects.toThrow('The browser could not pack a frame as PNG; choose smaller frames.');
  });
});
