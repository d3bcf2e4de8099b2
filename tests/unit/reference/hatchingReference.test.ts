import { describe, expect, test } from 'vitest';
import { defaults } from '../../gpu/referenceScenes.js';
import {
  faceNormal,
  HatchingReference,
  type ReferenceLight,
  type ReferenceMaterial,
} from '../../reference/hatchingReference.js';
import { cube, torus, trianglesOf } from '../../reference/meshes.js';
import { referenceAdjacency, type Triangle, type Vec3 } from '../../reference/referenceAdjacency.js';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const material: ReferenceMaterial = { ...defaults, tilesPerObjectUnit: 1, strokeAngle: 0, strokeOffset: [0, 0] };
const sun: ReferenceLight = { type: 'directional', color: [Math.PI, Math.PI, Math.PI], position: [1, 2, 3] };

const reference = (lights: ReferenceLight[], overrides: Partial<ReferenceMaterial> = {}) =>
  new HatchingReference({
    matrixWorld: identity,
    eye: [0, 0, 5],
    lights,
    material: { ...material, ...overrides },
    tones: 2,
    image: (tone) => tone,
  });

const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const flat: Triangle = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
];

describe('the double-precision reference', () => {
  test('frames are right-handed, orthonormal, and B points towards the light in the plane (Algorithm 1)', () => {
    for (const triangle of trianglesOf(torus)) {
      const n = faceNormal(triangle);
      const { tangent, bitangent } = reference([sun]).frame(triangle);
      expect(dot(tangent, tangent)).toBeCloseTo(1, 12);
      expect(dot(bitangent, bitangent)).toBeCloseTo(1, 12);
      expect(dot(tangent, bitangent)).toBeCloseTo(0, 12);
      expect(dot(bitangent, n)).toBeCloseTo(0, 12);
      const toLight: Vec3 = [1, 2, 3];
      expect(dot(bitangent, toLight)).toBeGreaterThan(0);
      // What is left of L once N and B are taken out is nothing: B is the projection.
      expect(dot(tangent, toLight)).toBeCloseTo(0, 11);
    }
  });

  test('a light along +x on the triangle z = 0 gives the coordinates one draws by hand', () => {
    const fromX = reference([{ ...sun, position: [1, 0, 1] }]);
    // B = x; T = B × N = x × z = −y. So s = −y and t = x.
    expect(fromX.coordinates([0.25, 0.5, 0], flat)[0]).toBeCloseTo(-0.5, 12);
    expect(fromX.coordinates([0.25, 0.5, 0], flat)[1]).toBeCloseTo(0.25, 12);
  });

  test('rotation is counter-clockwise, before scale, and the offset counts in tiles', () => {
    const turned = reference([{ ...sun, position: [1, 0, 1] }], {
      strokeAngle: Math.PI / 2,
      tilesPerObjectUnit: 2,
      strokeOffset: [0.1, 0.2],
    });
    // (s, t) = (−0.5, 0.25) → (−t, s)·2 + offset
    expect(turned.coordinates([0.25, 0.5, 0], flat)[0]).toBeCloseTo(-0.4, 12);
    expect(turned.coordinates([0.25, 0.5, 0], flat)[1]).toBeCloseTo(-0.8, 12);
  });

  test("projecting a vertex into a neighbour's plane changes nothing: V'·T = V·T (Algorithm 2)", () => {
    const projecting = reference([sun]);
    const [triangle, other] = trianglesOf(torus) as [Triangle, Triangle];
    const { tangent, bitangent } = projecting.frame(other);
    for (const vertex of triangle) {
      const [s, t] = projecting.coordinates(vertex, other);
      expect(s).toBeCloseTo(dot(vertex, tangent), 6);
      expect(t).toBeCloseTo(dot(vertex, bitangent), 6);
    }
  });

  test('between coplanar triangles the support of f ends half way to the opposite vertex', () => {
    const neighbour: Triangle = [
      [1, 0, 0],
      [0, 0, 0],
      [0, -1, 0],
    ];
    // A light so near that even coplanar triangles disagree about its direction: the neighbour shows where it counts.
    const dark = (b: number, neighbours: (Triangle | null)[]) => {
      const scene = new HatchingReference({
        matrixWorld: identity,
        eye: [0, 0, 5],
        lights: [{ type: 'point', color: [9, 9, 9], position: [0.3, 0.3, 0.5], decay: 0 }],
        material,
        tones: 2,
        image: (_tone, u) => 0.5 + 0.5 * Math.sin(7 * u),
      });
      return scene.shade(flat, neighbours, [(1 - b) / 2, (1 - b) / 2, b], 1, [0, 0, 1])[0];
    };
    for (const b of [0.1, 0.3, 0.45])
      expect(dark(b, [neighbour, null, null])).not.toBeCloseTo(dark(b, [null, null, null]), 3);
    for (const b of [0.5, 0.7, 0.95]) expect(dark(b, [neighbour, null, null])).toBe(dark(b, [null, null, null]));
    expect(referenceAdjacency([flat, neighbour])[0][0]).toEqual(neighbour);
  });

  test('triangles of different faces of a cube do not influence each other (section 3.3)', () => {
    const triangles = trianglesOf(cube);
    const adjacency = referenceAdjacency(triangles);
    const adjacent = reference([sun]);
    const alone = reference([sun], { technique: 'triangle' });
    triangles.forEach((triangle, i) => {
      const withoutCoplanar = adjacency[i].map((n) =>
        n !== null && dot(faceNormal(n), faceNormal(triangle)) > 0.5 ? null : n,
      );
      const at: Vec3 = [0.4, 0.4, 0.2];
      expect(adjacent.shade(triangle, withoutCoplanar, at, 1, [0, 0, 1])).toEqual(
        alone.shade(triangle, withoutCoplanar, at, 1, [0, 0, 1]),
      );
    });
  });

  test('a light parallel to the normal still gives a frame', () => {
    const { tangent, bitangent } = reference([{ ...sun, position: [0, 0, 1] }]).frame(flat);
    for (const value of [...tangent, ...bitangent]) expect(Number.isFinite(value)).toBe(true);
  });

  test('one directional light of intensity π gives tone 1 − N·L', () => {
    expect(reference([{ ...sun, position: [0, 3, 4] }]).tone([0, 0, 0], [0, 0, 1])).toBeCloseTo(0.2, 6);
  });
});
