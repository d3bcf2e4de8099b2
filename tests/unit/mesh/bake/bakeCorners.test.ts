import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { CORNER_STRIDE, cornerLayout } from '../../../../src/mesh/bake/attributeLayouts.js';
import { type BakeRequest, bakeCorners } from '../../../../src/mesh/bake/bakeCorners.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish, meshOf } from '../meshes.js';

const DEGREES = Math.PI / 180;

const bakeOf = (mesh: TriangleMesh, options: Partial<BakeRequest> = {}) =>
  finish(
    bakeCorners({ label: 'test', mesh, creaseAngle: Math.PI / 2, wantsNormals: false, attributes: [], ...options }),
  );

/** The attributes of one corner, cut out of the interleaved buffer. */
function cornerOf({ corners }: { corners: Float32Array }, corner: number): Record<string, number[]> {
  const floats = [...corners.subarray(CORNER_STRIDE * corner, CORNER_STRIDE * (corner + 1))];
  return Object.fromEntries(cornerLayout.map(({ name, itemSize }) => [name, floats.splice(0, itemSize)]));
}

/**
 *  2 ── 3
 *  │ ╲  │      the right half is folded up about the diagonal by `angle`
 *  0 ── 1
 */
const foldedQuad = (angle: number) => {
  const reach = Math.SQRT1_2;
  const along = 0.5 + reach * Math.cos(angle) * Math.SQRT1_2;
  return meshOf(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [along, along, reach * Math.sin(angle)],
    ],
    [
      [0, 1, 2],
      [2, 1, 3],
    ],
  );
};

describe('bakeCorners', () => {
  test('packs six adjacency vertices per corner', () => {
    const result = bakeOf(foldedQuad(0));
    const [v0, v1, v2, v3] = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [1, 1, 0],
    ];
    expect([...result.positions]).toEqual([v0, v1, v2, v2, v1, v3].flat());
    // Triangle 0: α and γ lie beyond borders, where the triangle's own opposite vertex stands in; β is vertex 3.
    expect([0, 1, 2].map((corner) => cornerOf(result, corner))).toEqual([
      { cornerNext: [...v1!, 0], cornerPrevious: v2, oppositeAlpha: v2, oppositeBeta: v3, oppositeGamma: v1 },
      { cornerNext: [...v2!, 1], cornerPrevious: v0, oppositeAlpha: v2, oppositeBeta: v3, oppositeGamma: v1 },
      { cornerNext: [...v0!, 2], cornerPrevious: v1, oppositeAlpha: v2, oppositeBeta: v3, oppositeGamma: v1 },
    ]);
    expect(cornerOf(result, 4)).toEqual({
      cornerNext: [...v3!, 1],
      cornerPrevious: v2,
      oppositeAlpha: v0,
      oppositeBeta: v2,
      oppositeGamma: v1,
    });
  });

  test.each([
    [30, 40, true],
    [50, 40, false],
    [40, 40, false],
    [89, 90, true],
    [90, 90, false],
    [91, 90, false],
    [179, 180, true],
  ])('a fold of %d° and a crease angle of %d°: neighbours %s', (fold, crease, areNeighbours) => {
    const mesh = foldedQuad(fold * DEGREES);
    const { oppositeBeta } = cornerOf(bakeOf(mesh, { creaseAngle: crease * DEGREES }), 0);
    expect(oppositeBeta).toEqual([...mesh.positions.subarray(areNeighbours ? 9 : 0, areNeighbours ? 12 : 3)]);
  });

  test('inconsistent winding: the crease angle is measured as if the winding were consistent', () => {
    const flat = foldedQuad(0);
    flat.indices.set([1, 2, 3], 3);
    expect(cornerOf(bakeOf(flat), 0).oppositeBeta).toEqual([1, 1, 0]);
    const sharp = foldedQuad(120 * DEGREES);
    sharp.indices.set([1, 2, 3], 3);
    expect(cornerOf(bakeOf(sharp), 0).oppositeBeta).toEqual([0, 0, 0]);
  });

  test('adds smooth normals, split at creases', () => {
    const [smooth, split] = [60, 40].map((crease) =>
      bakeOf(foldedQuad(50 * DEGREES), { wantsNormals: true, creaseAngle: crease * DEGREES }),
    );
    const normal = (normals: Float32Array | null, corner: number) => [...normals!.subarray(3 * corner, 3 * corner + 3)];
    const tilt = 50 * DEGREES;
    const up = [0, 0, 1];
    const tilted = [-Math.sin(tilt) * Math.SQRT1_2, -Math.sin(tilt) * Math.SQRT1_2, Math.cos(tilt)];
    const middle = [-Math.sin(tilt / 2) * Math.SQRT1_2, -Math.sin(tilt / 2) * Math.SQRT1_2, Math.cos(tilt / 2)];
    const closeTo = (values: number[]) => values.map((value) => expect.closeTo(value, 6));
    // corners 1, 2 and 3, 4 lie on the diagonal; both triangles have the same area
    expect([0, 1, 2, 3, 4, 5].map((corner) => normal(smooth!.normals, corner))).toEqual(
      [up, middle, middle, middle, middle, tilted].map(closeTo),
    );
    expect([0, 1, 2, 3, 4, 5].map((corner) => normal(split!.normals, corner))).toEqual(
      [up, up, up, tilted, tilted, tilted].map(closeTo),
    );
  });

  test('normals do not mix where windings contradict each other', () => {
    // The lower triangle is larger, and wound the other way: a sum would turn the normals of the upper one over.
    const mesh = meshOf(
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [1, -4, 0],
      ],
      [
        [0, 1, 2],
        [0, 1, 3],
      ],
    );
    const { normals, inconsistentEdges } = bakeOf(mesh, { wantsNormals: true });
    expect(inconsistentEdges).toBe(1);
    expect([2, 5, 8, 11, 14, 17].map((z) => normals![z])).toEqual([1, 1, 1, -1, -1, -1]);
  });

  test('weights normals by area', () => {
    // The tilted triangle is three times as large: vertex 3 lies three times as far from the diagonal.
    const mesh = foldedQuad(90 * DEGREES);
    mesh.positions.set([0.5, 0.5, 3 * Math.SQRT1_2], 9);
    const { normals } = bakeOf(mesh, { wantsNormals: true, creaseAngle: Math.PI });
    const scale = 1 / Math.sqrt(10);
    const expected = [-3 * Math.SQRT1_2 * scale, -3 * Math.SQRT1_2 * scale, scale];
    expect([...normals!.subarray(3, 6)]).toEqual(expected.map((value) => expect.closeTo(value, 6)));
  });

  test('expands attributes word by word', () => {
    const { attributes } = bakeOf(foldedQuad(0), {
      attributes: [
        { words: new Uint8Array([10, 11, 12, 13]), wordsPerVertex: 1 },
        { words: new Uint32Array([0, 1, 10, 11, 20, 21, 30, 0xffffffff]), wordsPerVertex: 2 },
      ],
    });
    expect(attributes).toEqual([
      new Uint8Array([10, 11, 12, 12, 11, 13]),
      new Uint32Array([0, 1, 10, 11, 20, 21, 20, 21, 10, 11, 30, 0xffffffff]),
    ]);
  });

  test('bounds include used vertices only', () => {
    const mesh = meshOf(
      [
        [-1, 0, 0],
        [3, 0, 0],
        [0, 4, 2],
        [99, 99, 99],
      ],
      [[0, 1, 2]],
    );
    expect(bakeOf(mesh).bounds).toEqual({ min: [-1, 0, 0], max: [3, 4, 2], radius: 3 });
  });

  test('progress rises from weld to pack and ends at 1', () => {
    const mesh = foldedQuad(0);
    const task = bakeCorners({
      label: 'test',
      mesh,
      creaseAngle: 1,
      wantsNormals: true,
      attributes: [{ words: new Uint8Array(4), wordsPerVertex: 1 }],
    });
    const progress = [...task];
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
  });

  test('never writes NaN, whatever the triangles are', () => {
    const coordinate = fc.constantFrom(0, -0, 1, 1e-45, 1e-38, -1e-20, 1, 2, 3.4e38, -3.4e38);
    fc.assert(
      fc.property(
        fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 3, maxLength: 8 }),
        fc.array(fc.tuple(fc.nat(), fc.nat(), fc.nat()), { minLength: 1, maxLength: 20 }),
        (vertices, seeds) => {
          const mesh = meshOf(
            vertices,
            seeds.map((seed) => seed.map((value) => value % vertices.length)),
          );
          const { positions, corners, normals, bounds } = bakeOf(mesh, { wantsNormals: true });
          for (const values of [positions, corners, normals!, [bounds.radius, ...bounds.min, ...bounds.max]]) {
            expect(values.every(Number.isFinite)).toBe(true);
          }
          for (let corner = 0; corner < mesh.indices.length; corner++) {
            expect(Math.hypot(...normals!.subarray(3 * corner, 3 * corner + 3))).toBeCloseTo(1, 5);
          }
        },
      ),
      { seed: 20080, numRuns: 500 },
    );
  });
});
