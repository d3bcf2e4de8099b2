import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { nearestRadius } from '../../../../src/playground/print/print.js';

test('a radius has as many pixels as two points at the near side of the model lie apart', () => {
  const camera = new PerspectiveCamera(30, 1.5, 0.01, 100);
  camera.position.set(2, 3, 4);
  camera.lookAt(0.1, 0.2, -0.1);
  camera.updateMatrixWorld();
  const forward = camera.getWorldDirection(new Vector3());
  const up = new Vector3(0, 1, 0).transformDirection(camera.matrixWorld);
  const near = forward.multiplyScalar(-1);
  const [from, to] = [near.clone(), near.clone().add(up)].map((point) => point.project(camera).y);
  expect(nearestRadius(camera, { viewHeight: 900 })).toBeCloseTo(450 * (to - from), 6);
});

test('within the model the nearest place is at the near plane', () => {
  const camera = new PerspectiveCamera(90, 1, 0.5, 100);
  camera.position.set(0, 0, 0.9);
  camera.updateMatrixWorld();
  expect(nearestRadius(camera, { viewHeight: 100 })).toBeCloseTo(100, 6);
});
