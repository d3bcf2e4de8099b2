import { existsSync, readFileSync } from 'node:fs';
import {
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  IcosahedronGeometry,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';
import { describe, expect, test } from 'vitest';
import { NO_TWIN, nextCorner, triangleOf } from '../../../../src/mesh/corners.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { meshFrom, moebius } from '../features/surfaces.js';
import { cube, patch, sphere, together, torus } from '../shapes.js';
import { borderTurns, frontOf, piecesOf, singularPoints } from './fronts.js';
import { readObj } from './readObj.js';

const knot = () => meshFrom(new TorusKnotGeometry(0.7, 0.24, 160, 24, 2, 3));
const icosahedron = () => meshFrom(new IcosahedronGeometry(1, 12));
const capsule = () => meshFrom(new CapsuleGeometry(0.4, 1.4, 16, 48, 24));

const lying = ({ positions, indices }: TriangleMesh, shift: number): TriangleMesh => ({
  positions: positions.map((value, i) => (i % 3 === 0 ? value + shift : value)),
  indices,
});

describe('the indices of singular points sum to the Euler characteristic', () => {
  test.each([
    ['a sphere', () => sphere(16), 2],
    ['another sphere', icosahedron, 2],
    ['a cube', () => cube(6), 2],
    ['a capsule', capsule, 2],
    ['a torus', () => torus(48, 24), 0],
    ['a knot', knot, 0],
  ])('%s', (_, shape, euler) => {
    const { surface, seam } = frontOf(shape(), {}, false);
    const [largest] = piecesOf(surface, seam).sort((a, b) => b.faces - a.faces);
    expect(largest).toMatchObject({ euler, index: euler, isClosed: true });
  });

  test('of each piece of a mesh', () => {
    const { surface, seam } = frontOf(together(sphere(12), lying(torus(40, 20), 3), lying(cube(5), -3)), {}, false);
    expect(piecesOf(surface, seam).map(({ euler, index }) => [euler, index])).toEqual([
      [2, 2],
      [0, 0],
      [2, 2],
    ]);
  });

  test.each([
    ['a cylinder with lids', () => meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24)), 3, 2],
    ['a cone with its lid', () => meshFrom(new ConeGeometry(0.8, 1, 48, 24)), 2, 2],
    ['half a ball, open', () => meshFrom(new SphereGeometry(1, 48, 24, 0, 2 * Math.PI, 0, Math.PI / 2)), 1, 1],
    ['an open cylinder', () => meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24, true)), 1, 0],
    ['a cube, each face ruled in its way', () => cube(6), 6, 6],
    ['a hilly patch', () => patch(16, 14, (u, v) => [u, v, 0.3 * Math.sin(5 * u) * Math.cos(4 * v)]), 1, 1],
  ])('less what borders turn, between creases: %s', (_, shape, count, euler) => {
    const front = frontOf(shape());
    const pieces = piecesOf(front.surface, front.seam);
    expect(pieces).toHaveLength(count);
    expect(pieces.reduce((sum, piece) => sum + piece.euler, 0)).toBe(euler);
    const index = pieces.reduce((sum, piece) => sum + piece.index, 0);
    expect(index + borderTurns(front)).toBeCloseTo(euler, 5);
  });

  const folder = new URL('../../../../../shared/models/', import.meta.url);
  test.each(['spot.obj', 'nefertiti_lowres.obj'])('of the scan %s', (name) => {
    const file = new URL(name, folder);
    if (!existsSync(file)) return console.log(`skipped: ../shared/models/${name} is not there`);
    const { surface, seam } = frontOf(readObj(readFileSync(file, 'utf8')), {}, false);
    for (const { euler, index, isClosed } of piecesOf(surface, seam)) {
      expect(isClosed).toBe(true);
      expect(index).toBe(euler);
    }
  });
});

describe('singular points', () => {
  test('are none on a torus', () => expect(singularPoints(frontOf(torus(48, 24)))).toEqual([]));

  test('lie in the caps of a capsule', () => {
    const points = singularPoints(frontOf(capsule()));
    expect(points.length).toBeGreaterThan(1);
    for (const [, y] of points) expect(Math.abs(y)).toBeGreaterThan(0.7);
  });

  test('lie where the signs around a fan multiply to −1, or directions turn by whole turns', () => {
    const { seam } = frontOf(sphere(16));
    for (const [fan, turns] of seam.halfTurns.entries()) {
      expect(seam.isSingular[fan]).toBe(Math.abs(turns) % 2);
      expect(seam.isPuncture[fan]).toBe(Number(turns !== 0 && turns % 2 === 0));
    }
  });
});

describe.each([
  ['a sphere', () => sphere(12)],
  ['a torus', () => torus(32, 16)],
  ['a knot', knot],
  ['a patch', () => patch(9, 7, (u, v) => [u, v, 0.3 * Math.sin(5 * u) * Math.cos(4 * v)])],
  ['a Möbius strip', () => moebius(40, 4)],
  ['several pieces', () => together(sphere(6), lying(torus(20, 10), 3))],
] as const)('the cut of %s', (_, shape) => {
  const { surface, directions, seam } = frontOf(shape());
  const { twins, fans } = surface;

  test('leaves directions that are combed', () => {
    for (const [corner, twin] of twins.entries()) {
      if (twin === NO_TWIN) continue;
      const [f, g] = [triangleOf(corner), triangleOf(twin)];
      const cosine = seam.flip[f] * seam.flip[g] * carriedCosine(directions, 3 * f, 3 * g);
      expect(seam.cutSign[corner] * cosine).toBeGreaterThanOrEqual(-1e-6);
      if (seam.cut[corner] === 0) expect(seam.cutSign[corner]).toBe(1);
    }
  });

  test('is the same for both halves of an edge, and opens its twins', () => {
    for (const [corner, twin] of twins.entries()) {
      if (twin === NO_TWIN) expect(seam.cut[corner]).toBe(0);
      else expect([seam.cut[twin], seam.cutSign[twin]]).toEqual([seam.cut[corner], seam.cutSign[corner]]);
      expect(seam.cutTwins[corner]).toBe(seam.cut[corner] === 1 ? NO_TWIN : twin);
    }
  });

  test('ends in singular points and borders only', () => {
    const degrees = new Uint32Array(fans.count);
    for (const [corner, cut] of seam.cut.entries()) degrees[fans.ofCorner[corner]] += cut;
    // In an open fan, the edge that ends at the border belongs to another corner; its cut edges all have twins.
    expect(seam.degree).toEqual(degrees);
    for (const [fan, degree] of degrees.entries()) {
      const mayEnd = seam.isSingular[fan] + seam.isPuncture[fan] + seam.isOpen[fan] > 0;
      if (degree === 1) expect(mayEnd).toBe(true);
      if (seam.isSingular[fan]) expect(degree).toBeGreaterThan(0);
    }
  });

  test('does not divide a piece', () => {
    const pieces = piecesOf(surface, seam);
    expect(
      piecesOf(
        { ...surface, twins: seam.cutTwins, fans: seam.wedges },
        { ...seam, halfTurns: new Int8Array(seam.wedges.count) },
      ),
    ).toHaveLength(pieces.length);
  });

  test('has a corner for each fan to walk from', () => {
    const sizes = new Uint32Array(fans.count);
    for (const fan of fans.ofCorner) sizes[fan]++;
    for (const [fan, first] of seam.cornerOf.entries()) {
      let size = 0;
      let corner = first;
      do {
        expect(fans.ofCorner[corner]).toBe(fan);
        size++;
        corner = twins[corner] === NO_TWIN ? first : nextCorner(twins[corner]);
      } while (corner !== first);
      expect(size).toBe(sizes[fan]);
    }
  });
});

/** The cosine between the direction of face f and that of g, carried over by the shortest rotation of its normal. */
function carriedCosine({ across, normals }: ReturnType<typeof frontOf>['directions'], f: number, g: number): number {
  const at = (values: Float32Array, i: number) => [...values.subarray(i, i + 3)];
  const [u, v, n, m] = [at(across, f), at(across, g), at(normals, f), at(normals, g)];
  const dot = (a: number[], b: number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const scale = dot(v, n) / (1 + dot(n, m));
  return dot(
    u,
    v.map((value, i) => value - scale * (n[i] + m[i])),
  );
}
