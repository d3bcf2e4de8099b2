import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';
import { describe, expect, test } from 'vitest';
import { findUpAxis } from '../../../../src/demo/files/findUpAxis.js';

const upOf = (geometry: BufferGeometry) =>
  findUpAxis(geometry.getAttribute('position').array, geometry.index?.array ?? null);
/** Stands on its base, with its axis along y. */
const cone = () => new ConeGeometry(1, 2, 48);
const quarter = Math.PI / 2;

describe('the axis that points up', () => {
  test.each([
    ['y', cone()],
    ['-y', cone().rotateX(Math.PI)],
    ['z', cone().rotateX(quarter)],
    ['-z', cone().rotateX(-quarter)],
    ['-x', cone().rotateZ(quarter)],
    ['x', cone().rotateZ(-quarter)],
  ])('is %s by the flat side below', (up, geometry) => {
    expect(upOf(geometry)).toBe(up);
    expect(upOf(geometry.toNonIndexed())).toBe(up);
  });

  test('is that of a column, whichever end is up', () => {
    expect(upOf(new CylinderGeometry(0.5, 0.5, 3, 32).rotateX(quarter))).toBe('z');
  });

  test.each([
    ['no side is flat', new SphereGeometry(1, 32, 16)],
    ['no side is flat', new TorusKnotGeometry()],
    ['every side is', new BoxGeometry(1, 2, 3)],
    ['it may as well hang on a wall', new CylinderGeometry(0.9, 1, 0.2, 32).rotateX(quarter)],
    ['there is nothing', new SphereGeometry(1, 32, 16).setIndex([])],
  ])('is not told where %s', (_, geometry) => {
    expect(upOf(geometry)).toBeUndefined();
  });
});
