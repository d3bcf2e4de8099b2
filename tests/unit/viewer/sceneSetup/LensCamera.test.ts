import { OrthographicCamera, PerspectiveCamera, Raycaster, Vector2, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { LENS, LensCamera } from '../../../../src/viewer/sceneSetup/LensCamera.js';
import { linkedCamera } from '../../../../src/viewer/sceneSetup/placeCamera.js';
import type { CameraLens, CameraView } from '../../../../src/viewer/settings/CameraView.js';

const wide: CameraLens = { isOrthographic: false, high: 0.5, aspect: 2, up: [0, 1, 0] };
const flat: CameraLens = { isOrthographic: true, high: 1.25, aspect: 0, up: [0, 1, 0] };

function placed(lens: CameraLens, aspect: number): LensCamera {
  const camera = new LensCamera();
  camera.aspect = aspect;
  camera.lens = lens;
  camera.position.set(1, 2, 5);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

describe('a camera with the lens of a file', () => {
  test.each([wide, flat, { ...flat, aspect: 3 }])('draws the very picture of the command: %j', (lens) => {
    for (const aspect of [0.5, 1, 3]) {
      const camera = placed(lens, aspect);
      const view: CameraView = { position: [1, 2, 5], target: [0, 0, 0], lens };
      const { camera: other } = linkedCamera(aspect, view, false);
      other.updateMatrixWorld();
      for (const point of [new Vector3(0.3, -0.4, 0.6), new Vector3(-1, 0.9, -0.2)]) {
        const [here, there] = [camera, other].map((one) => point.clone().project(one));
        expect(Math.hypot(here.x - there.x, here.y - there.y)).toBeLessThan(1e-6);
      }
    }
  });

  test('shows all of its picture on a sheet in the middle of the page', () => {
    const camera = placed(wide, 2);
    camera.sheet = [0.5, 0.8];
    const corner = new Vector3(0, wide.high, -1).applyMatrix4(camera.matrixWorld).project(camera);
    const side = new Vector3(wide.high * 2, 0, -1).applyMatrix4(camera.matrixWorld).project(camera);
    expect(side.x).toBeCloseTo(0.5, 5);
    expect(corner.y).toBeLessThan(0.8);
    camera.sheet = [1, 0.3];
    const top = new Vector3(0, wide.high, -1).applyMatrix4(camera.matrixWorld).project(camera);
    expect(top.y).toBeCloseTo(0.3, 5);
  });

  test('has the flags by which three tells cameras apart, also after a reset and a clone', () => {
    const camera = placed(flat, 1);
    expect(['isOrthographicCamera' in camera, 'isPerspectiveCamera' in camera]).toEqual([true, false]);
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(0.4, 0), camera);
    expect(ray.ray.direction.angleTo(camera.getWorldDirection(new Vector3()))).toBeLessThan(1e-6);
    const clone = camera.clone();
    expect(['isOrthographicCamera' in clone, clone.top]).toEqual([true, flat.high]);
    expect(clone.projectionMatrix.equals(camera.projectionMatrix)).toBe(true);
    camera.lens = undefined;
    expect(['isOrthographicCamera' in camera, 'isPerspectiveCamera' in camera]).toEqual([false, true]);
    const page = new PerspectiveCamera(LENS.fieldOfView, 1, LENS.near, LENS.far);
    expect(camera.projectionMatrix.equals(page.projectionMatrix)).toBe(true);
  });

  test('draws tiles of its picture', () => {
    const camera = placed(flat, 2);
    camera.setViewOffset(200, 100, 50, 0, 100, 100);
    const same = new OrthographicCamera(-2.5, 2.5, 1.25, -1.25, LENS.near, LENS.far);
    same.setViewOffset(200, 100, 50, 0, 100, 100);
    expect(camera.projectionMatrix.elements).toEqual(same.projectionMatrix.elements);
    camera.clearViewOffset();
    camera.widen(2);
    expect(camera.lens?.high).toBe(2.5);
    camera.widen(1e9);
    expect(camera.lens?.high).toBe(100);
  });
});
