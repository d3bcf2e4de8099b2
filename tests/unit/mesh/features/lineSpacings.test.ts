import { describe, expect, test } from 'vitest';
import { bakeIndexed } from '../../../../src/mesh/bake/bakeIndexed.js';
import { POINT_BITS, POINT_MASK, SPACING_STEPS } from '../../../../src/mesh/bake/outlineLayout.js';
import type { PackedOutlines } from '../../../../src/mesh/bake/packOutlines.js';
import { lineSpacings } from '../../../../src/mesh/features/lineSpacings.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish } from '../meshes.js';
import { cube, patch, together, torus } from '../shapes.js';
import { scaled } from './surfaces.js';

function outlinesOf({ positions, indices }: TriangleMesh): PackedOutlines {
  const { outlines } = finish(
    bakeIndexed({
      label: 'test',
      mesh: { positions: positions.slice(), indices: indices.slice() },
      creaseAngle: Math.PI / 2,
      wantsNormals: true,
      outlines: { triangleGroups: null },
    }),
  );
  return outlines!;
}

/** The spacings of the triangles and of the edges of a mesh, as shares of the bounding radius. */
function spacingsOf(mesh: TriangleMesh): { triangles: number[]; edges: number[]; outlines: PackedOutlines } {
  const outlines = outlinesOf(mesh);
  const words = finish(lineSpacings({ ...outlines, primitives: outlines.primitives.slice() }));
  const spacingAt = (i: number): number =>
    2 ** (-((words[4 * i + 2] >>> POINT_BITS) | ((words[4 * i + 3] >>> POINT_BITS) << 4)) / SPACING_STEPS);
  const all = Array.from({ length: outlines.triangleCount + outlines.edgeCount }, (_, i) => spacingAt(i));
  // The points and the flags stay.
  for (let i = 0; i < words.length; i++) {
    const mask = i % 4 < 2 ? 0xffffffff : POINT_MASK;
    if ((words[i] & mask) >>> 0 !== outlines.primitives[i]) throw new Error(`word ${i} has changed`);
  }
  return { triangles: all.slice(0, outlines.triangleCount), edges: all.slice(outlines.triangleCount), outlines };
}

/** Strips side by side in a plane, each half as wide as the distance from one to the next. */
const strips = (count: number, width = 1): TriangleMesh =>
  together(...Array.from({ length: count }, (_, k) => patch(1, 1, (u, v) => [(2 * k + u) * width, 2 * v, 0])));

const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;

describe('a crowd', () => {
  test.each([24, 60, 200])('of %i strips has lines at the distance of their borders', (count) => {
    const { edges, outlines } = spacingsOf(strips(count, 1 / count));
    const spacing = mean(edges) * outlines.radius * count;
    expect(spacing).toBeGreaterThan(0.5);
    expect(spacing).toBeLessThan(2);
  });

  test('has the same spacings at any size', () => {
    const small = spacingsOf(scaled(strips(60, 0.01), 0.001));
    const large = spacingsOf(scaled(strips(60, 0.01), 1000));
    expect(mean(small.edges)).toBeCloseTo(mean(large.edges), 3);
  });

  test('of rings is told from their curvature, without a single edge', () => {
    const ring = torus(20, 10);
    const chain = together(
      ...Array.from({ length: 36 }, (_, k) => ({
        ...ring,
        positions: ring.positions.map((value, i) => value + [3 * (k % 6), 3 * Math.floor(k / 6), 0][i % 3]),
      })),
    );
    expect(spacingsOf(chain).edges).toEqual([]);
    expect(mean(spacingsOf(chain).triangles)).toBeLessThan(0.1);
  });

  test('thins by no more than what it has around it: a part far away keeps its width', () => {
    const lone = patch(1, 1, (u, v) => [9 + 0.01 * u, 2 * v, 0]);
    const { edges } = spacingsOf(together(strips(60, 0.01), lone));
    expect(mean(edges.slice(-4))).toBe(1);
    expect(mean(edges.slice(0, 4))).toBeLessThan(0.02);
  });
});

describe('no crowd', () => {
  test.each<[string, TriangleMesh]>([
    ['a cube', cube(2)],
    ['a torus', torus(60, 30)],
    ['a thin strip', strips(1, 0.01)],
    ['a strip of two sides', together(strips(1, 0.01), strips(1, 0.01))],
  ])('is %s', (_, mesh) => {
    const { triangles, edges, outlines } = spacingsOf(mesh);
    expect(Math.min(...triangles, ...edges)).toBe(1);
    expect(outlines.mayCrowd).toBe(false);
  });

  test('is looked for in a mesh of few parts', () => {
    expect([12, 23, 24, 60].map((count) => outlinesOf(strips(count)).mayCrowd)).toEqual([false, false, true, true]);
  });
});
