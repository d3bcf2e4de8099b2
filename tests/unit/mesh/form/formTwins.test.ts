import { CylinderGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import { NO_TWIN } from '../../../../src/mesh/corners.js';
import { meshFrom } from '../features/surfaces.js';
import { cube, patch, prism, sphere, torus } from '../shapes.js';
import { facesOf, frontOf, piecesOf, singularPoints, twinsOf } from './fronts.js';

const countOf = (twins: Int32Array) => twins.filter((twin) => twin === NO_TWIN).length;

test.each([
  ['a sphere', () => sphere(10)],
  ['a torus', () => torus(40, 20)],
  ['a prism of twelve sides', () => prism(24)],
])('the sides of %s are one piece', (_, shape) => {
  const { surface, seam } = frontOf(shape());
  const sides = piecesOf(surface, seam).map(({ faces }) => faces);
  expect(Math.max(...sides)).toBeGreaterThan(0.5 * sides.reduce((sum, faces) => sum + faces));
});

describe('creases are borders of the field', () => {
  test('on a cube: each side is a piece without a singular point, ruled straight', () => {
    const front = frontOf(cube(8));
    expect(piecesOf(front.surface, front.seam)).toHaveLength(6);
    expect(singularPoints(front)).toEqual([]);
    for (const { middle, across } of facesOf(front)) {
      if (Math.abs(middle[1]) > 0.99) expect(Math.abs(across[1])).toBeLessThan(1e-6);
      else expect(Math.abs(across[1])).toBeGreaterThan(1 - 1e-6);
    }
  });

  test('on a cylinder: rings around its side, and no whirl on its lids', () => {
    const front = frontOf(meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24)));
    expect(piecesOf(front.surface, front.seam)).toHaveLength(3);
    expect(singularPoints(front)).toEqual([]);
  });
});

describe('lines run on', () => {
  test('across a crease that ends within the surface', () => {
    // A sheet folded along a line that ends in its middle.
    const sheet = patch(40, 40, (u, v) => [u - 0.5, v - 0.5, Math.max(0, 0.5 - u) * 3 * Math.abs(v - 0.5)]);
    const { whole, sharp, twins } = twinsOf(sheet);
    expect(countOf(sharp)).toBeGreaterThan(countOf(whole));
    expect(twins).toEqual(whole);
  });

  test('across creases around patches too small for lines of their own', () => {
    const spiked = patch(120, 120, (u, v) => {
      const inside = Math.max(Math.abs(u - 0.5), Math.abs(v - 0.5)) < 0.009;
      return [u - 0.5, v - 0.5, inside ? 0.02 : 0];
    });
    const { whole, sharp, twins } = twinsOf(spiked);
    expect(countOf(sharp)).toBeGreaterThan(countOf(whole));
    expect(twins).toEqual(whole);
  });
});
