import fc from 'fast-check';
import { CapsuleGeometry, IcosahedronGeometry, SphereGeometry, TorusGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  IS_EDGE,
  MATERIAL_BORDER,
} from '../../../../src/mesh/bake/outlineLayout.js';
import {
  type CreaseLimits,
  type FeatureEdges,
  findFeatureEdges,
} from '../../../../src/mesh/features/findFeatureEdges.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { finish, meshOf } from '../meshes.js';
import { cube, noise, patch, prism, together } from '../shapes.js';
import { fanPositions, featureSurface, meshFrom, moebius, outlinesOf, scaled, turned } from './surfaces.js';

const KINDS = BORDER | CREASE | MATERIAL_BORDER | CONTRARY;

/** Edges by the positions of their ends, with the flags of corners. */
function described(mesh: TriangleMesh, ofCorner: Uint32Array, { fans, flags }: FeatureEdges) {
  const positions = fanPositions(mesh, ofCorner);
  return Array.from(flags, (flag, edge) => {
    const [start, end, rightStart, rightEnd] = [...fans.subarray(4 * edge, 4 * edge + 4)].map((fan) => positions[fan]);
    // Both sides are at the same place.
    expect([rightStart, rightEnd]).toEqual([start, end]);
    return {
      kinds: flag & KINDS,
      ends: [
        { position: start, isCorner: (flag & CORNER_AT_START) !== 0 },
        { position: end, isCorner: (flag & CORNER_AT_END) !== 0 },
      ],
    };
  });
}

const NO_LIMITS: CreaseLimits = { featureAngle: null, creaseLength: 0 };

function edgesOf(mesh: TriangleMesh, limits: Partial<CreaseLimits> = {}, triangleGroups: Uint16Array | null = null) {
  const surface = featureSurface(mesh, triangleGroups);
  const edges = finish(findFeatureEdges(surface, { ...NO_LIMITS, ...limits }));
  return described(mesh, surface.ofCorner, edges);
}

const countOf = (edges: ReturnType<typeof edgesOf>, kind: number): number =>
  edges.filter(({ kinds }) => kinds === kind).length;

/** Edges as a set, regardless of order and direction. */
const asSet = (edges: ReturnType<typeof edgesOf>): string[] =>
  edges
    .map(
      ({ kinds, ends }) =>
        `${kinds}: ${ends
          .map((end) => JSON.stringify(end))
          .sort()
          .join(' – ')}`,
    )
    .sort();

/** The right half is folded up about the diagonal 1–2. */
const foldedQuad = (degrees: number) => {
  const angle = (degrees * Math.PI) / 180;
  const along = 0.5 + 0.5 * Math.cos(angle);
  return meshOf(
    [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [along, along, Math.SQRT1_2 * Math.sin(angle)],
    ],
    [
      [0, 1, 2],
      [2, 1, 3],
    ],
  );
};

describe('a cube', () => {
  test('has twelve creases with corners at both ends', () => {
    const edges = edgesOf(cube(1));
    expect(edges).toHaveLength(12);
    expect(countOf(edges, CREASE)).toBe(12);
    for (const { ends } of edges) {
      expect(ends.map(({ isCorner }) => isCorner)).toEqual([true, true]);
      const [a, b] = ends.map(({ position }) => position);
      expect(a.filter((value, axis) => value !== b[axis])).toHaveLength(1);
    }
  });

  test('has no corners inside its straight edges', () => {
    const edges = edgesOf(cube(4));
    expect(edges).toHaveLength(48);
    const corners = edges.flatMap(({ ends }) => ends.filter(({ isCorner }) => isCorner));
    expect(corners).toHaveLength(24);
    for (const { position } of corners) expect(position.map(Math.abs)).toEqual([1, 1, 1]);
  });

  test('has two different sides at each crease', () => {
    const surface = featureSurface(cube(2));
    const { fans } = finish(findFeatureEdges(surface, NO_LIMITS));
    for (let i = 0; i < fans.length; i += 4) {
      expect(fans[i]).not.toBe(fans[i + 2]);
      expect(fans[i + 1]).not.toBe(fans[i + 3]);
    }
  });
});

describe('creases', () => {
  test('are drawn if their connected length suffices; others may still carry the contour', () => {
    const small = scaled(cube(1), 0.25);
    // The edges of the large one add up to 24, those of the small one to 6.
    small.positions.forEach((_, i) => {
      if (i % 3 === 0) small.positions[i] += 5;
    });
    const mesh = together(cube(2), small);
    const counts = (creaseLength: number) => {
      const edges = edgesOf(mesh, { creaseLength });
      return [countOf(edges, CREASE), countOf(edges, 0)];
    };
    expect(counts(5.99)).toEqual([36, 0]);
    expect(counts(6.01)).toEqual([24, 12]);
    expect(counts(23.99)).toEqual([24, 12]);
    expect(counts(24.01)).toEqual([0, 36]);
  });

  test('that are dropped are no edges and make no corners', () => {
    // Of 40°, so that the fans on both sides are the same.
    const limits = { featureAngle: Math.PI / 6, creaseLength: 1.5 };
    expect(countOf(edgesOf(foldedQuad(40), limits), CREASE)).toBe(0);
    expect(edgesOf(foldedQuad(40), limits)).toHaveLength(4);
    expect(countOf(edgesOf(foldedQuad(40), { ...limits, creaseLength: 1.4 }), CREASE)).toBe(1);
  });

  test.each([
    [40, null, 0],
    [60, null, 1],
    [40, 39, 1],
    [40, 41, 0],
    [60, 61, 0],
    [10, 9, 1],
    [0, 1, 0],
  ])('of %i° with a featureAngle of %s: %i', (fold, degrees, count) => {
    const featureAngle = degrees === null ? null : (degrees * Math.PI) / 180;
    const edges = edgesOf(foldedQuad(fold), { featureAngle });
    expect(countOf(edges, CREASE)).toBe(count);
    expect(countOf(edges, BORDER)).toBe(4);
  });

  test('of exactly the featureAngle are creases, however the object is turned', () => {
    const random = noise(3);
    for (let i = 0; i < 20; i++) {
      const turn = [random(), random(), random(), random()];
      expect(countOf(edgesOf(turned(cube(1), turn), { featureAngle: Math.PI / 2 }), CREASE)).toBe(12);
      expect(countOf(edgesOf(turned(prism(8), turn), { featureAngle: Math.PI / 4 }), CREASE)).toBe(24);
      expect(countOf(edgesOf(turned(cube(1), turn), { featureAngle: Math.PI / 2 + 0.01 }), CREASE)).toBe(0);
    }
  });

  test('of an octagonal prism are those of its ends', () => {
    expect(countOf(edgesOf(prism(8)), CREASE)).toBe(16);
    expect(countOf(edgesOf(prism(6)), CREASE)).toBe(18);
  });

  test('are not made by the creaseAngle of the adjacency', () => {
    const { edges } = outlinesOf(foldedQuad(10), { creaseAngle: 0 });
    expect([...edges.flags].filter((flag) => flag & CREASE)).toEqual([]);
  });

  test('do not arise from noise', () => {
    const random = noise(3);
    const mesh = patch(30, 30, (u, v) => [u, v, 0.01 * random()]);
    expect(countOf(edgesOf(mesh), CREASE)).toBe(0);
  });
});

describe('borders', () => {
  test('of a square end and turn at its four corners alone', () => {
    const edges = edgesOf(patch(5, 5, (u, v) => [u, v, 0]));
    expect(edges).toHaveLength(20);
    expect(countOf(edges, BORDER)).toBe(20);
    const corners = edges.flatMap(({ ends }) => ends.filter(({ isCorner }) => isCorner));
    expect(corners).toHaveLength(8);
    for (const { position } of corners) expect(position.every((value) => value === 0 || value === 1)).toBe(true);
  });

  test('have the fans of their only side twice', () => {
    const surface = featureSurface(patch(2, 2, (u, v) => [u, v, 0]));
    const { fans } = finish(findFeatureEdges(surface, NO_LIMITS));
    for (let i = 0; i < fans.length; i += 4) expect(fans.slice(i, i + 2)).toEqual(fans.slice(i + 2, i + 4));
  });

  test('of a Möbius strip are one loop of 128; its contrary edges are no creases', () => {
    const mesh = moebius(64, 5);
    const edges = edgesOf(mesh);
    const borders = edges.filter(({ kinds }) => kinds === BORDER);
    expect(borders).toHaveLength(128);
    expect(borders.flatMap(({ ends }) => ends.filter(({ isCorner }) => isCorner))).toEqual([]);
    const next = new Map<string, string[]>();
    for (const { ends } of borders) {
      const [a, b] = ends.map(({ position }) => position.join(' ')) as [string, string];
      next.set(a, [...(next.get(a) ?? []), b]);
      next.set(b, [...(next.get(b) ?? []), a]);
    }
    const [start] = next.keys();
    const visited = new Set<string>();
    for (let vertex: string | undefined = start; vertex; vertex = next.get(vertex)!.find((v) => !visited.has(v))) {
      expect(next.get(vertex)).toHaveLength(2);
      visited.add(vertex);
    }
    expect(visited.size).toBe(128);
    expect(edges.filter(({ kinds }) => kinds !== BORDER).map(({ kinds }) => kinds)).toEqual(Array(5).fill(CONTRARY));
    const all = edgesOf(mesh, { featureAngle: 0 }).filter(({ kinds }) => kinds & CONTRARY);
    expect(all.map(({ kinds }) => kinds)).toEqual(Array(5).fill(CONTRARY));
  });

  test('are not made by a triangle without area', () => {
    const mesh = meshOf(
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [2, 0, 0],
      ],
      [
        [0, 1, 2],
        [0, 1, 3],
        [0, 0, 2],
      ],
    );
    expect(countOf(edgesOf(mesh), BORDER)).toBe(3);
    expect(edgesOf(mesh)).toHaveLength(3);
  });
});

describe('contrary windings', () => {
  const contrary = (degrees: number) => {
    const mesh = foldedQuad(degrees);
    mesh.indices.set([1, 2, 3], 3);
    return mesh;
  };

  test.each([0, 60, 120])('make no crease, with a fold of %i°', (degrees) => {
    for (const featureAngle of [null, 0, 1]) {
      const edges = edgesOf(contrary(degrees), { featureAngle });
      expect(edges.map(({ kinds }) => kinds).sort()).toEqual([BORDER, BORDER, BORDER, BORDER, CONTRARY].sort());
    }
  });

  test('between groups are borders of a material too', () => {
    const edges = edgesOf(contrary(0), {}, new Uint16Array([1, 2]));
    expect(countOf(edges, MATERIAL_BORDER | CONTRARY)).toBe(1);
  });
});

describe('groups', () => {
  test('have a material border between them, on flat and on sharp edges', () => {
    const groups = new Uint16Array([1, 2]);
    expect(countOf(edgesOf(foldedQuad(0), {}, groups), MATERIAL_BORDER)).toBe(1);
    expect(countOf(edgesOf(foldedQuad(60), {}, groups), MATERIAL_BORDER | CREASE)).toBe(1);
    expect(countOf(edgesOf(foldedQuad(60), { creaseLength: 9 }, groups), MATERIAL_BORDER)).toBe(1);
    expect(edgesOf(foldedQuad(0), {}, new Uint16Array([2, 2]))).toHaveLength(4);
  });

  test('that meet crosswise have a corner there, though both outlines go straight on', () => {
    const mesh = patch(2, 2, (u, v) => [u, v, 0]);
    const edges = edgesOf(mesh, {}, new Uint16Array([1, 1, 2, 2, 3, 3, 4, 4]));
    const crossing = edges
      .filter(({ kinds }) => kinds === MATERIAL_BORDER)
      .flatMap(({ ends }) => ends.filter(({ position }) => position.join() === '0.5,0.5,0'));
    expect(crossing.map(({ isCorner }) => isCorner)).toEqual([true, true, true, true]);
  });

  test('have corners where a straight run of the length asked for ends, subdivided or not', () => {
    for (const parts of [1, 4]) {
      const mesh = patch(parts, parts, (u, v) => [u, v, 0]);
      const cornersOf = (creaseLength: number) =>
        edgesOf(mesh, { creaseLength }).flatMap(({ ends }) => ends.filter(({ isCorner }) => isCorner)).length;
      expect(cornersOf(0.99)).toBe(8);
      expect(cornersOf(1.01)).toBe(0);
    }
  });

  test('are passed to the bake', () => {
    const { edges } = outlinesOf(foldedQuad(0), { outlines: { triangleGroups: new Uint16Array([1, 0]) } });
    expect([...edges.flags].filter((flag) => flag & MATERIAL_BORDER)).toHaveLength(1);
  });
});

describe('smooth surfaces of three.js have no edges', () => {
  test.each([
    ['torus', new TorusGeometry(1, 0.4, 32, 64)],
    ['sphere', new SphereGeometry(1, 64, 32)],
    ['capsule', new CapsuleGeometry(1, 1, 16, 48)],
    ['icosahedron', new IcosahedronGeometry(1, 7)],
  ])('%s', (name, geometry) => {
    const mesh = meshFrom(geometry);
    expect([...outlinesOf(mesh).edges.flags]).toEqual([]);
    // Without welding there are borders, so the check above is meaningful.
    const torn = outlinesOf(mesh, { weldTolerance: 0 }).edges.flags;
    if (name !== 'icosahedron') expect([...torn].filter((flag) => flag & BORDER).length).toBeGreaterThan(20);
  });
});

test('on a coarse mesh every edge may carry the contour', () => {
  const { edges } = outlinesOf(meshFrom(new IcosahedronGeometry(1, 3)));
  expect(edges.flags).toEqual(new Uint8Array(480).fill(IS_EDGE));
});

test('the order of triangles does not matter', () => {
  const random = noise(7);
  const dented = patch(9, 7, (u, v) => [u, v, u > 0.5 && v > 0.4 ? 0.3 : 0.02 * random()]);
  const meshes = [cube(2), prism(6), moebius(20, 3), dented].map((mesh) => ({ mesh, seed: mesh.indices.length }));
  for (const { mesh, seed } of meshes) {
    const count = mesh.indices.length / 3;
    const byChance = noise(seed);
    const groups = Uint16Array.from({ length: count }, () => (byChance() < 0.6 ? 1 : 2));
    const expected = asSet(edgesOf(mesh, { creaseLength: 0.5 }, groups));
    expect(expected.length).toBeGreaterThan(20);
    fc.assert(
      fc.property(fc.nat(), (shuffle) => {
        const key = noise(shuffle);
        const keys = Array.from({ length: count }, key);
        const order = [...keys.keys()].sort((a, b) => keys[a] - keys[b]);
        const indices = new Uint32Array(order.flatMap((t) => [...mesh.indices.subarray(3 * t, 3 * t + 3)]));
        // Each starts at another of its corners.
        for (let i = 0; i < indices.length; i += 3) {
          const [a, b, c] = indices.subarray(i, i + 3);
          if (key() < 0) indices.set([b, c, a], i);
        }
        const shuffled = { positions: mesh.positions, indices };
        const shuffledGroups = Uint16Array.from(order, (t) => groups[t]);
        expect(asSet(edgesOf(shuffled, { creaseLength: 0.5 }, shuffledGroups))).toEqual(expected);
      }),
      { seed: 20080, numRuns: 8 },
    );
  }
});
