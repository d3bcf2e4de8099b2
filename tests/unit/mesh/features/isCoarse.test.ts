import { IcosahedronGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { isCoarse } from '../../../../src/mesh/features/isCoarse.js';
import { measureBounds } from '../../../../src/mesh/measureBounds.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { fan, finish, meshOf } from '../meshes.js';
import { cube, noise, patch, prism } from '../shapes.js';
import { meshFrom, scaled, surfaceOf } from './surfaces.js';

/** A sphere of 20·(detail + 1)² triangles. */
const icosphere = (detail: number) => meshFrom(new IcosahedronGeometry(1, detail));

function judged(mesh: TriangleMesh): boolean {
  const { sharpTwins, areaNormals } = surfaceOf(mesh);
  return finish(isCoarse(mesh, sharpTwins, areaNormals, finish(measureBounds(mesh)).radius));
}

describe('coarse', () => {
  test.each<[string, boolean, TriangleMesh]>([
    ['a sphere of 80', true, icosphere(1)],
    ['a sphere of 320', true, icosphere(3)],
    ['a sphere of 1280', false, icosphere(7)],
    ['a large sphere of 320', true, scaled(icosphere(3), 500)],
    ['a small sphere of 1280', false, scaled(icosphere(7), 0.002)],
    ['a cube, whose edges are sharp', false, cube(1)],
    ['a prism of eight sides, that counts as round', true, prism(8)],
    ['a plane of two triangles', false, patch(1, 1, (u, v) => [u, v, 0])],
    ['a disc', false, fan(5)],
    [
      'a triangle',
      false,
      meshOf(
        [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
        ],
        [[0, 1, 2]],
      ),
    ],
    ['a point', false, meshOf([[0, 0, 0]], [[0, 0, 0]])],
  ])('%s: %s', (_, expected, mesh) => {
    expect(judged(mesh)).toBe(expected);
  });

  test('fine triangles are not coarse, however rough', () => {
    const random = noise(3);
    expect(judged(patch(40, 40, (u, v) => [u, v, 0.01 * random()]))).toBe(false);
  });
});
