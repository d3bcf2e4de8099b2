import { TorusKnotGeometry, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { turnedPoints } from '../../../../src/playground/video/videoPlan.js';
import { fitCamera } from '../../../../src/viewer/sceneSetup/framing.js';
import { createCamera } from '../../../../src/viewer/sceneSetup/LensCamera.js';

const FILL = 0.7;

test('a model that turns stays within the picture, and fills it in the widest turn', () => {
  const camera = createCamera();
  camera.aspect = 1;
  camera.updateProjectionMatrix();
  // Long, and off the axis that it turns about.
  const points = new TorusKnotGeometry().scale(0.4, 0.3, 1.6).translate(0, 0, 0.4).getAttribute('position').array;
  fitCamera(camera, turnedPoints(points), new Vector3(0, 0.3, 1), { fill: FILL });
  camera.updateMatrixWorld();
  let widest = 0;
  for (let turn = 0; turn < 60; turn++) {
    for (let i = 0; i < points.length; i += 3) {
      const seen = new Vector3().fromArray(points, i).applyAxisAngle(new Vector3(0, 1, 0), (Math.PI * turn) / 30);
      seen.project(camera);
      widest = Math.max(widest, Math.abs(seen.x), Math.abs(seen.y));
    }
  }
  expect(widest).toBeLessThan(FILL + 0.02);
  expect(widest).toBeGreaterThan(FILL - 0.02);
});
