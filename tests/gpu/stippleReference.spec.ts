import { expect, testOnOnePage } from '../browser/test.js';
import { HatchingReference, type ReferenceLight, type ReferenceMaterial } from '../reference/hatchingReference.js';
import { interpolated } from '../reference/interpolated.js';
import { type PlainMesh, torus, trianglesOf } from '../reference/meshes.js';
import { interiorPixels, rasterizeReference } from '../reference/rasterizeReference.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';
import { StippleReference } from '../reference/stippleReference.js';
import type { HatchingSpec } from './hatchingSpec.js';
import { describeError, expectEqualPictures, pictureError } from './pictureError.js';
import {
  ambient,
  blocked,
  defaults,
  directional,
  eye,
  identity,
  leaning,
  mirrored,
  orthographic,
  perspective,
  placed,
  redSide,
  rotated,
  squashed,
  wall,
} from './referenceScenes.js';

const SIZE = 192;

interface Case {
  name: string;
  /** Default: a torus. */
  mesh?: PlainMesh;
  lights?: ReferenceLight[];
  matrixWorld?: number[];
  isOrthographic?: boolean;
  material?: Partial<ReferenceMaterial>;
  dots?: Partial<NonNullable<HatchingSpec['dots']>>;
  screenConstancy?: number;
}

const cases: Case[] = [
  { name: 'sized on the screen' },
  { name: 'large, with hard edges', dots: { strokeWidth: 9, edgePixels: 0 } },
  { name: 'finer than a pixel', dots: { strokeWidth: 1 } },
  { name: 'sized on the object', screenConstancy: 0, material: { strokeScale: 0.3 } },
  { name: 'sized half on the screen', screenConstancy: 0.5, material: { strokeScale: 0.3 } },
  { name: 'rotated object', matrixWorld: rotated },
  { name: 'rotated, moved and scaled object, two lights', matrixWorld: placed, lights: [directional, redSide] },
  { name: 'mirrored object', matrixWorld: mirrored },
  { name: 'object scaled unequally', matrixWorld: squashed },
  { name: 'orthographic camera', isOrthographic: true },
  { name: 'seen at a slant', mesh: wall, matrixWorld: leaning },
  { name: 'seen at a slant by an orthographic camera', mesh: wall, matrixWorld: leaning, isOrthographic: true },
  { name: 'in shadow', lights: [blocked, ambient] },
];

const test = testOnOnePage('tests/gpu/harness.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.renderHatching !== undefined);
});

/** Linear RGB per pixel that is wholly inside the picture of the mesh. */
function expected(spec: HatchingSpec, subpixelBits: number): Map<number, Vec3> {
  const { positions, normals, indices, matrixWorld, camera } = spec;
  const material = spec.material as ReferenceMaterial;
  const reference = new HatchingReference({
    matrixWorld,
    eye,
    orthographic: !!spec.orthographic,
    lights: spec.lights,
    material,
    tones: 2,
    image: () => 0,
  });
  const settings = { ...spec.dots!, strokeScale: material.strokeScale, screenConstancy: spec.screenConstancy! };
  const stipple = new StippleReference({ reference, settings, matrixWorld, camera, size: SIZE });
  // three turns normals of vertices, and brings them to a length of 1, before it interpolates them.
  const worldNormals = Array.from({ length: normals!.length / 3 }, (_, i) =>
    reference.normalToWorld(normals!.slice(3 * i, 3 * i + 3) as Vec3),
  ).flat();
  const fragments = rasterizeReference(trianglesOf(spec), matrixWorld, camera, SIZE, SIZE, false, subpixelBits);
  return new Map(
    interiorPixels(fragments, SIZE, SIZE).map((pixel) => {
      const [place, normal, toneNormal] = [positions, normals!, worldNormals].map((values) =>
        interpolated(values, indices, fragments[pixel]!),
      ) as [Vec3, Vec3, Vec3];
      const blank = 1 - stipple.darkness(place, normal, toneNormal);
      return [pixel, [blank, blank, blank]];
    }),
  );
}

for (const { name, mesh = torus, ...rest } of cases) {
  test(`stipple equals the double-precision reference: ${name}`, async ({ page }) => {
    const spec: HatchingSpec = {
      width: SIZE,
      height: SIZE,
      positions: mesh.positions,
      normals: mesh.normals!,
      indices: mesh.indices,
      matrixWorld: rest.matrixWorld ?? identity,
      camera: rest.isOrthographic ? orthographic : perspective,
      orthographic: !!rest.isOrthographic,
      lights: rest.lights ?? [directional],
      material: { ...defaults, ...rest.material, technique: 'anchored', toneNormal: 'smooth' },
      map: 'smooth',
      screenConstancy: rest.screenConstancy ?? 1,
      dots: { strokeWidth: 3.2, edgePixels: 1, ...rest.dots },
    };
    const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');
    const reference = expected(spec, await page.evaluate(() => window.subpixelBits));
    expect(reference.size, 'interior pixels').toBeGreaterThan(3000);
    const error = pictureError(pixels, reference);
    test.info().annotations.push(describeError(error));
    expectEqualPictures(error);
  });
}
