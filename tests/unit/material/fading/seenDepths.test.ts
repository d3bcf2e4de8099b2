import { Box3, Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { automaticDepthFade } from '../../../../src/material/fading/automaticDepthFade.js';
import { type SeenBox, seenBox } from '../../../../src/material/fading/seenDepths.js';

const NOWHERE = new Matrix4();

const box = (min: [number, number, number], max: [number, number, number]): Box3 =>
  new Box3(new Vector3(...min), new Vector3(...max));

function cameraAt(z: number, fov = 40, aspect = 1.5): PerspectiveCamera {
  const camera = new PerspectiveCamera(fov, aspect, 0.01, 1000);
  camera.position.z = z;
  camera.updateMatrixWorld();
  return camera;
}

function seen(bounds: Box3, camera: PerspectiveCamera | OrthographicCamera, frame = NOWHERE): SeenBox | null {
  const depths = { front: -1, back: -1, left: -1, right: -1, bottom: -1, top: -1 };
  return seenBox(bounds, frame, camera, depths) ? depths : null;
}

describe('the depths that are seen of a box', () => {
  test('are those of its front and its back, where all of it is on the sheet', () => {
    const depths = seen(box([-1, -1, -1], [1, 1, 1]), cameraAt(6))!;
    expect(depths.front).toBeCloseTo(5, 9);
    expect(depths.back).toBeCloseTo(7, 9);
  });

  test('move with the object in whose space it is', () => {
    const frame = new Matrix4().makeTranslation(0, 0, -2).multiply(new Matrix4().makeRotationY(Math.PI / 2));
    const depths = seen(box([-3, -1, -1], [3, 1, 1]), cameraAt(10), frame)!;
    expect(depths.front).toBeCloseTo(9, 9);
    expect(depths.back).toBeCloseTo(15, 9);
  });

  test('begin where the walls of a corridor come onto the sheet, for an eye within', () => {
    const depths = seen(box([-2, -1, -50], [2, 1, 10]), cameraAt(0))!;
    // The floor is 1 below the eye, at the lower edge of the sheet.
    expect(depths.front).toBeCloseTo(1 / Math.tan((20 / 180) * Math.PI), 9);
    expect(depths.back).toBeCloseTo(50, 9);
  });

  test('are the same for each tile of a picture', () => {
    const corridor = box([-2, -1, -50], [2, 1, 10]);
    const whole = seen(corridor, cameraAt(0))!;
    const camera = cameraAt(0);
    for (const [x, y] of [
      [0, 0],
      [400, 300],
      [450, 100],
    ]) {
      camera.setViewOffset(600, 400, x, y, 150, 100);
      const tile = seen(corridor, camera)!;
      expect(tile.front).toBeCloseTo(whole.front, 9);
      expect(tile.back).toBeCloseTo(whole.back, 9);
      expect(automaticDepthFade(tile, camera)).toBeCloseTo(automaticDepthFade(whole, cameraAt(0)), 9);
    }
  });

  test('are those of an orthographic camera too, also of what lies behind the sheet', () => {
    const camera = new OrthographicCamera(-2, 2, 2, -2, 0, 100);
    camera.updateMatrixWorld();
    expect(seen(box([-1, -1, -9], [1, 1, -4]), camera)).toEqual({
      front: 4,
      back: 9,
      left: -0.5,
      right: 0.5,
      bottom: -0.5,
      top: 0.5,
    });
  });

  test('are none where the box is off the sheet, behind the eye or empty', () => {
    expect(seen(box([20, -1, -1], [22, 1, 1]), cameraAt(6))).toBeNull();
    expect(seen(box([-1, -1, 8], [1, 1, 9]), cameraAt(6))).toBeNull();
    expect(seen(new Box3(), cameraAt(6))).toBeNull();
  });
});

describe('a scene fades by itself', () => {
  /**
   * The depth divided by the shorter side of the sheet at the middle of the scene, half way from front to back on the sheet: the
   * harmonic mean of their distances.
   */
  const ratio = (front: number, back: number, slope: number): number =>
    (back - front) / (2 * slope * (2 / (1 / front + 1 / back)));

  test('from three times as deep as the shorter side of the sheet on, in full from four times on', () => {
    const camera = cameraAt(0);
    const slope = Math.tan((20 / 180) * Math.PI);
    for (let back = 1.5; back < 12; back += 0.5) {
      const depth = ratio(1, back, slope);
      const expected = 0.7 * Math.min(Math.max(depth - 3, 0), 1);
      expect(automaticDepthFade({ front: 1, back }, camera), `${depth}`).toBeCloseTo(expected, 9);
    }
  });

  test('by the width of a sheet that is upright', () => {
    const upright = cameraAt(0, 40, 0.5);
    const depths = { front: 1, back: 3 };
    expect(ratio(1, 3, Math.tan((20 / 180) * Math.PI))).toBeLessThan(3);
    expect(automaticDepthFade(depths, cameraAt(0))).toBe(0);
    expect(automaticDepthFade(depths, upright)).toBeGreaterThan(0);
  });

  test('not where it is one object before an ordinary lens, but as a corridor', () => {
    const camera = cameraAt(5, 26);
    expect(automaticDepthFade(seen(box([-1, -1, -1], [1, 1, 1]), camera)!, camera)).toBe(0);
    expect(automaticDepthFade(seen(box([-1, -1, -15], [1, 1, 6]), camera)!, camera)).toBe(0.7);
  });

  test('alike before a camera whose pictures are turned, as those of a CubeCamera', () => {
    const turned = cameraAt(0);
    turned.fov *= -1;
    turned.updateProjectionMatrix();
    for (const back of [3, 5, 9]) {
      const depths = { front: 1, back };
      expect(automaticDepthFade(depths, turned)).toBe(automaticDepthFade(depths, cameraAt(0)));
    }
  });

  test('before an orthographic camera, if it is deeper than three sheets', () => {
    const camera = new OrthographicCamera(-2, 2, 1, -1, 0, 100);
    expect(automaticDepthFade({ front: 40, back: 46 }, camera)).toBe(0);
    expect(automaticDepthFade({ front: 40, back: 48 }, camera)).toBe(0.7);
  });
});
