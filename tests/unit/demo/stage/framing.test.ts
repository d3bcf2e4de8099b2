import { TorusKnotGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { createCamera } from '../../../../src/demo/stage/createCamera.js';
import { fitCamera } from '../../../../src/demo/stage/framing.js';

const FILL = 0.7;

describe.each([0.5, 1, 2.5])('a picture with the aspect %s', (aspect) => {
  test('is filled by points up to the share asked for, and they are in its middle', () => {
    const camera = createCamera();
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
    const points = new TorusKnotGeometry().translate(0.2, 0.1, 0).getAttribute('position').array;
    const target = fitCamera(camera, points, new Vector3(0.6, 0.4, 1), 1, FILL);
    camera.updateMatrixWorld();
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    for (let i = 0; i < points.length; i += 3) {
      const seen = new Vector3().fromArray(points, i).project(camera).toArray();
      for (const axis of [0, 1]) {
        low[axis] = Math.min(low[axis], seen[axis]);
        high[axis] = Math.max(high[axis], seen[axis]);
      }
    }
    const shares = [0, 1].map((axis) => (high[axis] - low[axis]) / 2);
    expect(Math.max(...shares)).toBeCloseTo(FILL, 2);
    // By perspective, the middle of the farther sides is a little off.
    for (const axis of [0, 1]) expect(Math.abs(low[axis] + high[axis])).toBeLessThan(0.1);
    expect(target.clone().project(camera).setZ(0).length()).toBeLessThan(1e-6);
  });
});
