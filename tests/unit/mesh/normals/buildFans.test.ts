import fc from 'fast-check';
import { expect, test } from 'vitest';
import { buildTriangleAdjacency, consistentTwins } from '../../../../src/mesh/adjacency/buildTriangleAdjacency.js';
import { NO_TWIN, nextCorner } from '../../../../src/mesh/corners.js';
import { buildFans } from '../../../../src/mesh/normals/fans.js';
import { findPatches } from '../../../../src/mesh/normals/findPatches.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish } from '../meshes.js';

/** Triangles among few vertices: with borders, edges of many triangles and windings that contradict each other. */
const soups = fc.array(fc.tuple(fc.nat(8), fc.nat(8), fc.nat(8)), { minLength: 1, maxLength: 40 }).map(
  (triangles): TriangleMesh => ({
    positions: Float32Array.from({ length: 27 }, (_, i) => Math.sin(7 * i * i + i)),
    indices: Uint32Array.from(triangles.flat()),
  }),
);

/** Numbers the sets connected by `pairs`, in the order of their first members. */
function numbered(count: number, pairs: readonly (readonly [number, number])[]): number[] {
  const labels = Array.from({ length: count }, (_, i) => i);
  for (let changed = true; changed; ) {
    changed = false;
    for (const [a, b] of pairs) {
      const least = Math.min(labels[a], labels[b]);
      if (labels[a] !== least || labels[b] !== least) changed = true;
      labels[a] = labels[b] = least;
    }
  }
  const order = [...new Set(labels)];
  return labels.map((label) => order.indexOf(label));
}

/** The twins of a mesh whose windings agree, in pairs. */
function twinsOf(mesh: TriangleMesh) {
  const adjacency = finish(buildTriangleAdjacency(mesh));
  const twins = finish(consistentTwins(adjacency));
  const pairs = [...twins].flatMap((twin, corner) => (twin === NO_TWIN ? [] : [[corner, twin] as const]));
  return { ...adjacency, consistent: twins, pairs };
}

test('a fan is the set of corners connected by edges with twins around a vertex', () => {
  fc.assert(
    fc.property(soups, (mesh) => {
      const { consistent, pairs } = twinsOf(mesh);
      const { ofCorner, count } = finish(buildFans(consistent));
      const expected = numbered(
        consistent.length,
        pairs.map(([corner, twin]) => [corner, nextCorner(twin)]),
      );
      expect([...ofCorner]).toEqual(expected);
      expect(count).toBe(Math.max(...expected) + 1);
    }),
  );
});

test('a patch is the set of triangles connected by edges with twins', () => {
  fc.assert(
    fc.property(soups, (mesh) => {
      const { consistent, pairs, areaNormals } = twinsOf(mesh);
      const { ofTriangle, areas, sizes } = finish(findPatches({ twins: consistent, areaNormals }));
      const expected = numbered(
        consistent.length / 3,
        pairs.map(([corner, twin]) => [Math.floor(corner / 3), Math.floor(twin / 3)]),
      );
      expect([...ofTriangle]).toEqual(expected);
      expect([...sizes]).toEqual(
        sizes.length > 0 ? [...sizes].map((_, i) => expected.filter((patch) => patch === i).length) : [],
      );
      const whole = areaNormals.reduce(
        (sum, _, i) => (i % 3 === 0 ? sum + 0.5 * Math.hypot(...areaNormals.subarray(i, i + 3)) : sum),
        0,
      );
      expect(areas.reduce((sum, area) => sum + area, 0)).toBeCloseTo(whole);
    }),
  );
});

test('twins with contradicting windings are removed, and the others stay', () => {
  fc.assert(
    fc.property(soups, (mesh) => {
      const { twins, canonicalCorners, consistent } = twinsOf(mesh);
      for (const [corner, twin] of twins.entries()) {
        const contradict = twin !== NO_TWIN && canonicalCorners[corner] === canonicalCorners[twin];
        expect(consistent[corner]).toBe(contradict ? NO_TWIN : twin);
      }
    }),
  );
});
