import { expect } from '../browser/test.js';
import { test } from './toolkitPage.js';

/** A lower resolution while something moves on a slow machine. What counts as slow is set, so that no clock decides. */

test('movement is drawn at a lower pixel ratio, and rest at the full one', async ({ page }) => {
  const seen = await page.evaluate(async () => {
    const { THREE, AdaptiveResolution, hatchedMesh, sceneOf, sun, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    renderer.setPixelRatio(2);
    const scene = sceneOf(await hatchedMesh(new THREE.SphereGeometry(1, 24, 12)), sun());
    const camera = makeCamera();
    let rested = () => {};
    let measured = () => {};
    const resolution = new AdaptiveResolution(renderer, {
      slow: 0,
      pause: 300,
      onRest: () => rested(),
      onMeasured: () => measured(),
    });
    const state = () => [renderer.domElement.width, renderer.getPixelRatio(), resolution.scale];
    const frame = async (isMoving?: boolean) => {
      const known = new Promise<void>((resolve) => {
        measured = resolve;
      });
      resolution.render(scene, camera, isMoving);
      // The movement may be over when it is measured.
      const drawn = state();
      await known;
      return drawn;
    };
    const seen: Record<string, unknown> = {};
    seen.first = await frame();
    seen.still = await frame();
    const move = () => {
      camera.position.x += 0.05;
      return frame();
    };
    // The first step is measured in full, and found slow.
    await move();
    const rest = new Promise<void>((resolve) => {
      rested = resolve;
    });
    seen.moving = await move();
    await rest;
    seen.restBeforeFrame = resolution.scale;
    seen.rest = await frame(false);
    await frame(true);
    seen.light = await frame(true);
    renderer.setPixelRatio(1.5);
    seen.ratioSet = await frame(true);
    resolution.dispose();
    seen.disposed = state();
    return seen;
  });
  expect(seen).toEqual({
    first: [192, 2, 1],
    still: [192, 2, 1],
    moving: [96, 1, 0.5],
    restBeforeFrame: 1,
    rest: [192, 2, 1],
    // A light may move too, which the caller must say.
    light: [96, 1, 0.5],
    // A pixel ratio that was set in the meantime is the full one.
    ratioSet: [72, 0.75, 0.5],
    disposed: [144, 1.5, 1],
  });
});

test('fast frames stay in full resolution, and wrong options are reported', { tag: '@all' }, async ({ page }) => {
  const [scale, width, messages] = await page.evaluate(async () => {
    const { THREE, AdaptiveResolution, hatchedMesh, sceneOf, sun, makeRenderer, makeCamera } = window.toolkit;
    const renderer = makeRenderer();
    const scene = sceneOf(await hatchedMesh(new THREE.BoxGeometry()), sun());
    const camera = makeCamera();
    let measured = () => {};
    const resolution = new AdaptiveResolution(renderer, { slow: 1e6, onMeasured: () => measured() });
    for (let i = 0; i < 3; i++) {
      await new Promise<void>((resolve) => {
        measured = resolve;
        resolution.render(scene, camera, true);
      });
    }
    const messages = [{ share: 0 }, { slow: -1 }, { pause: Number.NaN }].map((options) => {
      try {
        return String(new AdaptiveResolution(renderer, options));
      } catch (error) {
        return String(error);
      }
    });
    return [resolution.scale, renderer.domElement.width, messages] as const;
  });
  expect([scale, width]).toEqual([1, 96]);
  expect(messages).toEqual([
    'RangeError: AdaptiveResolution: share is 0. Pass a number in (0, 1], or leave it out.',
    'RangeError: AdaptiveResolution: slow is -1. Pass a number of milliseconds, 0 or more, or leave it out.',
    'RangeError: AdaptiveResolution: pause is NaN. Pass a positive number of milliseconds, or leave it out.',
  ]);
});
