import { type PerspectiveCamera, TorusKnotGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { fitCamera, proportionOf } from '../../../../src/viewer/sceneSetup/framing.js';
import { shadowOnGround } from '../../../../src/viewer/sceneSetup/groundShadow.js';
import { createCamera } from '../../../../src/viewer/sceneSetup/LensCamera.js';

const FILL = 0.7;
const VIEW = new Vector3(0.6, 0.4, 1);
const points = new TorusKnotGeometry().translate(0.2, 0.1, 0).getAttribute('position').array;

/** From where to where points lie in the picture, across and up: −1 and 1 are its edges. */
function seen(camera: PerspectiveCamera, positions: ArrayLike<number>): { low: number[]; high: number[] } {
  camera.updateMatrixWorld();
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const place = new Vector3().fromArray(positions, i).project(camera).toArray();
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis], place[axis]);
      high[axis] = Math.max(high[axis], place[axis]);
    }
  }
  return { low, high };
}

describe.each([0.5, 1, 2.5])('a picture with the aspect %s', (aspect) => {
  const camera = createCamera();
  camera.aspect = aspect;
  camera.updateProjectionMatrix();

  test('is filled by points up to the share asked for, and they are in its middle', () => {
    const target = fitCamera(camera, points, VIEW, { fill: FILL });
    const { low, high } = seen(camera, points);
    const shares = [0, 1].map((axis) => (high[axis] - low[axis]) / 2);
    expect(Math.max(...shares)).toBeCloseTo(FILL, 2);
    // By perspective, the middle of the farther sides is a little off.
    for (const axis of [0, 1]) expect(Math.abs(low[axis] + high[axis])).toBeLessThan(0.1);
    expect(target.clone().project(camera).setZ(0).length()).toBeLessThan(1e-6);
  });

  test('is composed for a part of it', () => {
    const part = [0.5, 0.8] as const;
    fitCamera(camera, points, VIEW, { fill: FILL, part });
    const { low, high } = seen(camera, points);
    const shares = [0, 1].map((axis) => (high[axis] - low[axis]) / 2 / part[axis]);
    expect(Math.max(...shares)).toBeCloseTo(FILL, 2);
    for (const axis of [0, 1]) expect(Math.abs(low[axis] + high[axis])).toBeLessThan(0.1);
  });

  const aside = new Vector3(-1, 1.2, 0.4);

  test('includes the shadow, and shrinks the points for it by a quarter at most', () => {
    const shadow = shadowOnGround(points, aside, true, -1.5);
    const alone = camera.position.distanceTo(fitCamera(camera, points, VIEW, { fill: FILL }));
    // Only a wide picture has room for it without any doing.
    expect(Math.max(...seen(camera, shadow).high) > 0.97).toBe(aspect < 2);
    const target = fitCamera(camera, points, VIEW, { fill: FILL, shadow });
    expect(camera.position.distanceTo(target)).toBeLessThanOrEqual(1.25 * alone);
    for (const { low, high } of [seen(camera, points), seen(camera, shadow)]) {
      expect(Math.min(...low)).toBeGreaterThan(-0.97);
      expect(Math.max(...high)).toBeLessThan(0.97);
    }
  });

  test('keeps the points in the middle while they may be smaller', () => {
    const shadow = shadowOnGround(points, new Vector3(-0.6, 1.2, 0.4), true, -1.5);
    fitCamera(camera, points, VIEW, { fill: FILL, shadow, room: { model: 0.88, shadow: 0.96, smaller: 3 } });
    const { low, high } = seen(camera, points);
    expect(Math.abs(low[0] + high[0]) / 2).toBeLessThan(0.12);
    expect(Math.max(...seen(camera, shadow).high)).toBeLessThan(0.97);
  });

  test('cuts a long shadow, and never the points', () => {
    const shadow = shadowOnGround(points, new Vector3(-1, 0.1, 0.4), true, -1.5);
    const alone = camera.position.distanceTo(fitCamera(camera, points, VIEW, { fill: FILL }));
    const aimed = fitCamera(camera, points, VIEW, { fill: FILL, shadow });
    expect(camera.position.distanceTo(aimed) / alone).toBeCloseTo(1.25, 5);
    expect(seen(camera, shadow).high[0]).toBeGreaterThan(1);
    const { low, high } = seen(camera, points);
    expect(Math.min(...low)).toBeGreaterThan(-0.9);
    expect(Math.max(...high)).toBeLessThan(0.9);
    // They have gone aside for it, but not out of balance.
    const middle = (low[0] + high[0]) / 2;
    expect(middle).toBeLessThan(-0.2);
    expect(middle).toBeGreaterThan(-0.45);
  });

  test('is as before where a shadow is in the picture anyway', () => {
    const before = fitCamera(camera, points, VIEW, { fill: FILL });
    const target = fitCamera(camera, points, VIEW, { fill: FILL, shadow: shadowOnGround([0, 0, 0], aside, true, -1) });
    expect(target.toArray()).toEqual(before.toArray());
  });
});

test('the aspect of points is that of their projection', () => {
  const plank = [0, 0, 0, 0, 0, 3, 0, 1.5, 0];
  expect(proportionOf(plank, new Vector3(1, 0, 0))).toBeCloseTo(2, 6);
  expect(proportionOf(plank, new Vector3(0, 0, 1))).toBeCloseTo(0, 6);
});
