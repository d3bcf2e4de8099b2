import { expect, test } from 'vitest';
import { findParts } from '../../../../src/mesh/form/FormSurface.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { dot } from '../features/surfaces.js';
import { finish } from '../meshes.js';
import { sphere, together } from '../shapes.js';
import { facesOf, frontOf, twinsOf } from './fronts.js';

const placed = ({ positions, indices }: TriangleMesh, size: number, x: number): TriangleMesh => ({
  positions: positions.map((value, i) => size * value + (i % 3 === 0 ? x : 0)),
  indices,
});

/** A body with bumps. */
function bumpy(): TriangleMesh {
  const mesh = sphere(20);
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x, y, z] = mesh.positions.subarray(i, i + 3);
    const radius = 1 + 0.25 * Math.sin(3 * x + 1) * Math.cos(2.5 * y) + 0.15 * Math.sin(4 * z + y);
    mesh.positions.set([radius * x, 1.4 * radius * y, radius * z], i);
  }
  return mesh;
}

test('each part has its bounding radius, and none counts as less than a hundredth of the mesh', () => {
  const mesh = together(sphere(6), placed(sphere(6), 0.2, 3), placed(sphere(6), 1e-4, 4));
  const { adjacency, radius, whole } = twinsOf(mesh);
  const { ofTriangle, shares } = finish(findParts(mesh, whole, adjacency.areaNormals, radius));
  const faces = sphere(6).indices.length / 3;
  expect([0, faces, 2 * faces].map((face) => ofTriangle[face])).toEqual([0, 1, 2]);
  expect(shares[0] * radius).toBeCloseTo(1, 5);
  expect(shares[1] * radius).toBeCloseTo(0.2, 5);
  expect(shares[2]).toBeCloseTo(0.01, 6);
});

test('a small part of an assembly is drawn as it is alone', () => {
  const alone = facesOf(frontOf(bumpy()));
  const assembly = facesOf(frontOf(together(placed(sphere(20), 4, 0), placed(bumpy(), 0.2, 6)))).slice(-alone.length);
  const errors = alone.map(({ across }, i) => {
    const cosine = Math.abs(dot(across, assembly[i].across));
    return (Math.acos(Math.min(1, cosine)) * 180) / Math.PI;
  });
  expect(errors.filter((error) => error > 3).length).toBeLessThan(0.1 * errors.length);
});
