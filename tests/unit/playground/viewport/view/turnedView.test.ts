import { BoxGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { turnedView } from '../../../../../src/playground/viewport/turnedView.js';
import { proportionOf } from '../../../../../src/viewer/sceneSetup/framing.js';

const pointsOf = (...size: [number, number, number]): ArrayLike<number> =>
  new BoxGeometry(...size).getAttribute('position').array;
const FIRST = new Vector3(0.62, 0.36, 1);

describe('the view of points in a narrow picture', () => {
  test('is the first one where they are narrow enough', () => {
    const view = turnedView(pointsOf(1, 2, 1), FIRST, 1);
    expect(view.angleTo(FIRST)).toBeLessThan(1e-6);
  });

  test.each([
    ['along x', pointsOf(3, 1, 0.6)],
    ['along z', pointsOf(0.6, 1, 3)],
  ])('is turned towards the end of what lies %s, and no farther than it takes', (_, framedPoints) => {
    const view = turnedView(framedPoints, FIRST, 1.1);
    expect(proportionOf(framedPoints, FIRST)).toBeGreaterThan(1.1);
    expect(proportionOf(framedPoints, view)).toBeLessThanOrEqual(1.1);
    expect(proportionOf(framedPoints, view)).toBeGreaterThan(0.8);
    // Not from behind.
    expect(view.angleTo(FIRST)).toBeLessThan(Math.PI / 2);
  });

  test('is raised for what lies flat', () => {
    const flat = pointsOf(2, 0.2, 2);
    const view = turnedView(flat, FIRST, 1.3);
    expect(view.y).toBeGreaterThan(FIRST.clone().normalize().y + 0.1);
    expect(proportionOf(flat, view)).toBeLessThanOrEqual(1.3);
  });

  test('is that in which they are narrowest, if they are too wide in all', () => {
    const framedPoints = pointsOf(6, 0.1, 6);
    expect(proportionOf(framedPoints, turnedView(framedPoints, FIRST, 0.2))).toBeLessThan(
      proportionOf(framedPoints, FIRST),
    );
  });
});
