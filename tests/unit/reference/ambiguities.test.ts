import { describe, expect, test } from 'vitest';
import { HatchingReference, type ReferenceLight, type ReferenceMaterial } from '../../reference/hatchingReference.js';
import type { Triangle, Vec3 } from '../../reference/referenceAdjacency.js';

/**
 * Where the paper by Suarez et al. says too little or promises too much: what its algorithms do, in numbers. These tests use
 * the reference, which the shader equals. docs/research/paper.md explains the same in words.
 */

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const material: ReferenceMaterial = {
  technique: 'adjacency',
  toneModel: 'lambert',
  toneSteps: 4,
  shininess: 30,
  toneNormal: 'face',
  toneCurve: 'linear',
  reflectedLight: 0,
  strokeLayers: 'single',
  crossFrom: 0.52,
  crossAngle: Math.PI / 3,
  sharpInk: false,
  levelRule: 'derivatives',
  inkBlend: 'cover',
  tilesPerObjectUnit: 1,
  strokeAngle: 0,
  strokeOffset: [0, 0],
  blendAngle: Math.PI / 2,
  ink: [0, 0, 0],
  paper: [1, 1, 1],
  color: [1, 1, 1],
  colorHatching: 0,
  colorFill: 1,
};
const lamp = (...position: Vec3): ReferenceLight => ({ type: 'point', color: [9, 9, 9], position, decay: 0 });
const sun = (...position: Vec3): ReferenceLight => ({ type: 'directional', color: [3, 3, 3], position });

const sceneOf = (
  light: ReferenceLight,
  image: (tone: number, u: number, v: number) => number = (tone) => tone,
  overrides: Partial<ReferenceMaterial> = {},
) =>
  new HatchingReference({
    matrixWorld: identity,
    eye: [0, 0, 5],
    lights: [light],
    material: { ...material, ...overrides },
    tones: 2,
    image,
  });

const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const degreesBetween = (a: Vec3, b: Vec3) => (Math.acos(dot(a, b)) * 180) / Math.PI;
const turned = (degrees: number): Vec3 => [
  Math.cos((degrees * Math.PI) / 180),
  Math.sin((degrees * Math.PI) / 180),
  0.5,
];

/** A square floor of 10 × 10 in two triangles. */
const floor: [Triangle, Triangle] = [
  [
    [-5, -5, 0],
    [5, -5, 0],
    [5, 5, 0],
  ],
  [
    [5, 5, 0],
    [-5, 5, 0],
    [-5, -5, 0],
  ],
];

describe('coplanar triangles', () => {
  const disagreement = (light: ReferenceLight) => {
    const scene = sceneOf(light);
    return degreesBetween(scene.frame(floor[0]).bitangent, scene.frame(floor[1]).bitangent);
  };

  test('disagree about the direction to a near lamp, the less the farther it is', () => {
    expect(disagreement(lamp(1, 2, 0.5))).toBeCloseTo(93.2, 1);
    expect(disagreement(lamp(20, 10, 5))).toBeCloseTo(11.4, 1);
    expect(disagreement(lamp(2000, 1000, 500))).toBeLessThan(0.2);
  });

  test('agree under a directional light, strokes running on from one to the other', () => {
    const scene = sceneOf(sun(1, 2, 0.5));
    expect(disagreement(sun(1, 2, 0.5))).toBe(0);
    const shared: Vec3 = [2, 2, 0];
    expect(scene.coordinates(shared, floor[0])).toEqual(scene.coordinates(shared, floor[1]));
  });

  test('have one direction per point, not per triangle, where strokes are anchored', () => {
    const scene = sceneOf(lamp(1, 2, 0.5));
    const towards = scene.frameOfNormal([0, 0, 1], [1, 1, 0]).bitangent;
    expect(degreesBetween(towards, [0, 1, 0])).toBeCloseTo(0, 5);
    expect(degreesBetween(towards, scene.frameOfNormal([0, 0, 1], [1.01, 1, 0]).bitangent)).toBeLessThan(1);
  });
});

describe('the origin that coordinates are counted from', () => {
  /** How far the strokes at a distance from the origin move, in tiles, when the light turns by a tenth of a degree. */
  const swim = (distance: number) => {
    const there: Triangle = floor[0].map(([x, y, z]) => [x + distance, y, z]) as Triangle;
    const at: Vec3 = [distance, 0, 0];
    const [before, after] = [0, 0.1].map((angle) => sceneOf(sun(...turned(angle))).coordinates(at, there));
    return Math.hypot(after[0] - before[0], after[1] - before[1]);
  };

  test('is that of object space: strokes swim the faster, the farther they are from it', () => {
    expect(swim(0)).toBe(0);
    expect(swim(1)).toBeCloseTo((0.1 * Math.PI) / 180, 6);
    expect(swim(10)).toBeCloseTo(10 * swim(1), 6);
  });

  test('is a place of no strokes where the surface turns its face to it: every triangle there shows the same spot of the map', () => {
    const scene = sceneOf(sun(0.3, 0.2, 1));
    for (const axis of [0, 1, 2]) {
      const onSphere = ([x, y, z]: Vec3) =>
        [
          [z, x, y],
          [x, z, y],
          [x, y, z],
        ][axis] as Vec3;
      const small: Triangle = [onSphere([-0.01, -0.01, 1]), onSphere([0.01, -0.01, 1]), onSphere([0, 0.02, 1])];
      for (const corner of small) expect(Math.hypot(...scene.coordinates(corner, small))).toBeLessThan(0.03);
    }
  });
});

describe('the strokes of a neighbour, laid into the triangle', () => {
  const angle = Math.PI / 6;
  const flat: Triangle = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
  ];
  const folded: Triangle = [
    [1, 0, 0],
    [0, 0, 0],
    [0, -Math.cos(angle), -Math.sin(angle)],
  ];

  test('are projected, not unfolded: across the edge they are drawn out by 1 / cos of the angle', () => {
    const scene = sceneOf(sun(0, 1, 0.2));
    const from = scene.coordinates([0, 0, 0], folded);
    const to = scene.coordinates([0, 1, 0], folded);
    // One unit across the edge is one unit in the frame of the triangle, and cos of it in that of the neighbour.
    expect(Math.hypot(to[0] - from[0], to[1] - from[1])).toBeCloseTo(Math.cos(angle), 6);
    const along = scene.coordinates([1, 0, 0], folded);
    expect(Math.hypot(along[0] - from[0], along[1] - from[1])).toBeCloseTo(1, 6);
  });

  test('do not meet their own at the edge: each side weighs itself 1 and the other cos of the angle', () => {
    // The map is ink where u is right of a place that lies between what the two frames say of the middle of the edge.
    const middle: Vec3 = [0.5, 0, 0];
    const light = sun(1, 0.3, 0.4);
    const plain = sceneOf(light);
    const u = [flat, folded].map((triangle) => plain.coordinates(middle, triangle)[0]);
    const between = (u[0] + u[1]) / 2;
    expect(Math.abs(u[0] - u[1])).toBeGreaterThan(0.01);
    const scene = sceneOf(light, (_tone, at) => (at > between ? 1 : 0));
    const here = scene.shade(flat, [folded, null, null], [0.5, 0.5, 0], 1, [0, 0, 1])[0];
    const there = scene.shade(folded, [flat, null, null], [0.5, 0.5, 0], 1, [0, 0, 1])[0];
    const c = Math.cos(angle);
    expect(Math.abs(here - there)).toBeCloseTo((1 - c) / (1 + c), 5);
    // Unblended it would be all or nothing.
    expect((1 - c) / (1 + c)).toBeLessThan(0.08);
  });
});
