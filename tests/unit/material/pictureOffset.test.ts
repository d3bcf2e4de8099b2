import { PerspectiveCamera, Vector2, Vector4 } from 'three';
import { expect, test } from 'vitest';
import { writeSheet } from '../../../src/material/pictureOffset.js';

const offset = (camera: PerspectiveCamera, viewport: Vector4): number[] => {
  const target = new Vector2(7, 7);
  writeSheet(new Vector4(), camera, viewport, target);
  return target.toArray();
};

test('a whole picture begins at its lower left', () => {
  const camera = new PerspectiveCamera();
  expect(offset(camera, new Vector4(10, 20, 300, 200))).toEqual([0, 0]);
  camera.setViewOffset(600, 400, 300, 0, 300, 200);
  camera.clearViewOffset();
  expect(offset(camera, new Vector4(0, 0, 300, 200))).toEqual([0, 0]);
});

test('a tile of a larger one lies where it belongs, counted from below', () => {
  const camera = new PerspectiveCamera();
  camera.setViewOffset(600, 400, 300, 0, 300, 200);
  expect(offset(camera, new Vector4(0, 0, 300, 200))).toEqual([300, 200]);
  camera.setViewOffset(600, 400, 0, 200, 300, 200);
  expect(offset(camera, new Vector4(0, 0, 600, 400))).toEqual([0, 0]);
  // Drawn twice as large, into the right half of the canvas.
  camera.setViewOffset(600, 400, 300, 200, 300, 200);
  expect(offset(camera, new Vector4(600, 0, 600, 400))).toEqual([0, 0]);
});
