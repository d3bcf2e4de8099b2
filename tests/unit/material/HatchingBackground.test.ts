import { Box3, Camera, Group, Mesh, Raycaster, Scene, SphereGeometry, Vector3 } from 'three';
import { expect, test, vi } from 'vitest';
import { SceneExtent } from '../../../src/material/fading/SceneExtent.js';
import { HatchingBackground } from '../../../src/material/HatchingBackground.js';

test('its subject is an extent, or an object that is measured in its own space', () => {
  const extent = new SceneExtent(new Group());
  expect(new HatchingBackground(extent).subject).toBe(extent);
  expect(new HatchingBackground().subject).toBeNull();
  const ball = new Mesh(new SphereGeometry(2));
  ball.position.x = 5;
  const { subject } = new HatchingBackground(ball);
  expect(subject!.frame).toBe(ball);
  expect(subject!.box.getCenter(new Vector3()).length()).toBeLessThan(1e-6);
  expect(subject!.box.max.x).toBeCloseTo(2, 6);
});

test('numbers out of range are refused, by the constructor too', () => {
  const background = new HatchingBackground(null, { tone: 0.4, ink: '#ff0000' });
  expect(background.tone).toBe(0.4);
  expect(background.ink.getHex()).toBe(0xff0000);
  expect(() => Object.assign(background, { tone: 2 })).toThrow('HatchingBackground.tone: 2 is not a number in [0, 1].');
  expect(() => new HatchingBackground(null, { spacing: 0 })).toThrow(RangeError);
  expect(background.tone).toBe(0.4);
});

test('raycasts and bounding boxes ignore it', () => {
  const scene = new Scene().add(new HatchingBackground());
  scene.updateMatrixWorld();
  expect(new Raycaster(new Vector3(0, 0, 5), new Vector3(0, 0, -1)).intersectObjects([scene])).toEqual([]);
  expect(new Box3().setFromObject(scene).isEmpty()).toBe(true);
});

test('warns once that WebGPURenderer does not draw it', () => {
  const error = vi.spyOn(console, 'error').mockImplementation(() => {});
  const background = new HatchingBackground(new Mesh(new SphereGeometry()));
  const draw = () => background.onBeforeRender({ isWebGPURenderer: true } as never, new Scene(), new Camera());
  draw();
  draw();
  expect(error.mock.calls.flat()).toEqual([
    expect.stringMatching(
      /^.*HatchingBackground: WebGPURenderer draws no materials .* Draw the scene with WebGLRenderer, from 'three'\.$/,
    ),
  ]);
  error.mockRestore();
});
