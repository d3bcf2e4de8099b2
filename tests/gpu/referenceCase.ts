import { type Page, test } from '@playwright/test';
import { cross } from '../../src/look/vectors.js';
import { expect } from '../browser/test.js';
import { HatchingReference, type ReferenceLight, type ReferenceMaterial } from '../reference/hatchingReference.js';
import { interpolated } from '../reference/interpolated.js';
import { type PlainMesh, toFloat, torus, trianglesOf } from '../reference/meshes.js';
import { interiorPixels, rasterizeReference } from '../reference/rasterizeReference.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';
import type { HatchingSpec } from './hatchingSpec.js';
import { describeError, expectEqualPictures, pictureError } from './pictureError.js';
import { defaults, directional, eye, identity, orthographic, perspective } from './referenceScenes.js';

/** Pixels per side of the pictures that are compared with a reference in double precision. */
export const SIZE = 128;

/** The differences from a torus under one light, seen in perspective. */
export interface ReferenceCase {
  name: string;
  mesh?: PlainMesh;
  lights?: ReferenceLight[];
  matrixWorld?: number[];
  isOrthographic?: boolean;
  material?: Partial<ReferenceMaterial>;
  screenSpaceShare?: number;
  importance?: number;
}

/** The page's input for a case. */
export function specOf(
  { mesh = torus, lights, matrixWorld, isOrthographic, material, screenSpaceShare = 1, importance = 1 }: ReferenceCase,
  technique: 'hatching' | 'engraving',
): HatchingSpec {
  return {
    width: SIZE,
    height: SIZE,
    positions: toFloat(mesh.positions),
    normals: mesh.normals!,
    indices: mesh.indices,
    matrixWorld: matrixWorld ?? identity,
    camera: isOrthographic ? orthographic : perspective,
    orthographic: !!isOrthographic,
    lights: lights ?? [directional],
    material: { ...defaults, ...material, technique, toneNormal: 'smooth' },
    map: 'smooth',
    screenSpaceShare,
    importance,
  };
}

/** The centre of the bounding sphere, as three.js finds it. */
export const centreOf = (positions: readonly number[]): Vec3 =>
  [0, 1, 2].map((axis) => {
    const along = positions.filter((_, i) => i % 3 === axis);
    return (Math.min(...along) + Math.max(...along)) / 2;
  }) as Vec3;

/** The reference of what all techniques share: lights and tone. */
export const referenceOf = ({
  matrixWorld,
  orthographic,
  camera,
  lights,
  material,
  importance,
}: HatchingSpec): HatchingReference =>
  new HatchingReference({
    matrixWorld,
    eye,
    orthographic: !!orthographic,
    camera,
    importance,
    lights,
    material: material as ReferenceMaterial,
    tones: 2,
    image: () => 0,
  });

/** Says how dark a place is, by its normal in the object, that which lights are reckoned with, and its triangle. */
export type DarknessOf = (place: Vec3, normal: Vec3, toneNormal: Vec3, flatNormal: Vec3, isPlane: boolean) => number;

/** Draws on the page, and compares every pixel that is wholly inside the mesh with its darkness. */
export async function expectDarkness(
  page: Page,
  spec: HatchingSpec,
  reference: HatchingReference,
  darknessOf: DarknessOf,
): Promise<void> {
  const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');
  const { positions, indices, matrixWorld, camera } = spec;
  const normals = spec.normals!;
  // three turns normals of vertices, and brings them to a length of 1, before it interpolates them.
  const worldNormals = Array.from({ length: normals.length / 3 }, (_, i) =>
    reference.normalToWorld(normals.slice(3 * i, 3 * i + 3) as Vec3),
  ).flat();
  const subpixelBits = await page.evaluate(() => window.subpixelBits);
  const fragments = rasterizeReference(trianglesOf(spec), matrixWorld, camera, SIZE, SIZE, false, subpixelBits);
  const expected = new Map(
    interiorPixels(fragments, SIZE, SIZE).map((pixel) => {
      const [place, normal, toneNormal] = [positions, normals, worldNormals].map((values) =>
        interpolated(values, indices, fragments[pixel]!),
      ) as [Vec3, Vec3, Vec3];
      const { triangle } = fragments[pixel]!;
      const flatNormal = flatNormalOf(positions, indices, triangle);
      const blank = 1 - darknessOf(place, normal, toneNormal, flatNormal, isPlane(normals, indices, triangle));
      return [pixel, [blank, blank, blank] as Vec3];
    }),
  );
  expect(expected.size, 'interior pixels').toBeGreaterThan(3000);
  const error = pictureError(pixels, expected);
  test.info().annotations.push(describeError(error));
  expectEqualPictures(error);
}

/** Whether the corners of a triangle have one normal. */
function isPlane(normals: ArrayLike<number>, indices: readonly number[], triangle: number): boolean {
  const corner = (k: number) => [0, 1, 2].map((axis) => normals[3 * indices[3 * triangle + k]! + axis]).join();
  return corner(0) === corner(1) && corner(0) === corner(2);
}

/** The normal of a triangle, of any length. */
function flatNormalOf(positions: ArrayLike<number>, indices: readonly number[], triangle: number): Vec3 {
  const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => positions[3 * indices[3 * triangle + k]! + axis]!));
  const [u, v] = [b, c].map((corner) => corner!.map((x, axis) => x - a![axis]!) as Vec3) as [Vec3, Vec3];
  return [...cross(u, v)];
}
