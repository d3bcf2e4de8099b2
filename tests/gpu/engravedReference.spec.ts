import { expect, testOnOnePage } from '../browser/test.js';
import { EngravedReference } from '../reference/engravedReference.js';
import { HatchingReference, type ReferenceLight, type ReferenceMaterial } from '../reference/hatchingReference.js';
import { interpolated } from '../reference/interpolated.js';
import { type PlainMesh, toFloat, torus, trianglesOf } from '../reference/meshes.js';
import { interiorPixels, rasterizeReference } from '../reference/rasterizeReference.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';
import type { HatchingSpec, LineSettings } from './hatchingSpec.js';
import { describeError, expectEqualPictures, pictureError } from './pictureError.js';
import {
  ambient,
  blocked,
  crossed,
  defaults,
  directional,
  eye,
  hemisphere,
  identity,
  leaning,
  mirrored,
  moved,
  movedBack,
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
  lines?: Partial<LineSettings>;
  screenConstancy?: number;
}

const fromAbove: ReferenceLight = { ...directional, position: [0.2, 3, 0.3] };

const lamp: ReferenceLight = { type: 'point', color: [20, 20, 20], position: [1.2, 1.5, 2], distance: 0, decay: 2 };
const spot: ReferenceLight = {
  type: 'spot',
  color: [12, 9, 6],
  position: [-2, 1, 2],
  target: [0, 0, 0],
  distance: 0,
  decay: 2,
  angle: 0.7,
  penumbra: 0.3,
};

const cases: Case[] = [
  { name: 'tangent to the light' },
  { name: 'tangent to the light, a ruling machine', lines: { handmade: 0 } },
  { name: 'towards the light', lines: { lineField: 'towards' } },
  { name: 'towards the light, a ruling machine', lines: { lineField: 'towards', handmade: 0 } },
  { name: 'tangent to a light from above', lights: [fromAbove] },
  ...(['x', 'y', 'z'] as const).map((lineField) => ({
    name: `across the axis ${lineField}`,
    lines: { lineField, handmade: lineField === 'x' ? 0 : 0.4 },
  })),
  { name: 'a very unsteady hand', lines: { handmade: 1 } },
  { name: 'carved', lines: { carved: true, crossFrom: 1, lineSpacing: 9 } },
  { name: 'carved towards a near lamp', lights: [lamp], lines: { carved: true, lineField: 'towards', crossFrom: 1 } },
  {
    name: 'carved across the axis y, sized on the object',
    screenConstancy: 0,
    lines: { carved: true, lineField: 'y' },
  },
  {
    name: 'carved, placed and crossed by shadow',
    lights: [blocked, ambient],
    matrixWorld: placed,
    lines: { carved: true },
    material: { shadowStrokes: 'cross' },
  },
  { name: 'no crossing', lines: { crossFrom: 1 } },
  { name: 'crossing at right angles from light tones on', lines: { crossFrom: 0.2, crossAngle: Math.PI / 2 } },
  { name: 'finer than lines may lie', lines: { lineSpacing: 2.6 } },
  { name: 'wide apart', lines: { lineSpacing: 21 } },
  { name: 'sized on the object', screenConstancy: 0, lines: { lineSpacing: 12 } },
  { name: 'sized half on the screen', screenConstancy: 0.5 },
  { name: 'rotated object', matrixWorld: rotated },
  { name: 'rotated, moved and scaled object', matrixWorld: placed },
  { name: 'mirrored object', matrixWorld: mirrored },
  { name: 'object scaled unequally', matrixWorld: squashed },
  { name: 'geometry off its origin', mesh: moved(torus, 3), matrixWorld: movedBack(3) },
  { name: 'orthographic camera', isOrthographic: true },
  { name: 'seen at a slant', mesh: wall, matrixWorld: leaning },
  { name: 'seen at a slant by an orthographic camera', mesh: wall, matrixWorld: leaning, isOrthographic: true },
  { name: 'two lights', lights: [directional, redSide] },
  { name: 'two lights as strong as each other, rotated object', lights: crossed, matrixWorld: rotated },
  { name: 'no light with a direction', lights: [hemisphere] },
  { name: 'a near lamp', lights: [lamp] },
  { name: 'a near lamp, rotated, moved and scaled object', lights: [lamp], matrixWorld: placed },
  { name: 'turned from the light', material: { strokeRotation: 0.7 } },
  {
    name: 'turned from the direction to the light',
    material: { strokeRotation: 0.4 },
    lines: { lineField: 'towards' },
  },
  { name: 'turned from a near lamp', lights: [lamp], material: { strokeRotation: -0.6 } },
  { name: 'turned beyond a near lamp', lights: [lamp], material: { strokeRotation: 2.2 } },
  { name: 'towards a near lamp', lights: [lamp], lines: { lineField: 'towards' } },
  { name: 'a lamp, a spot and a light without an end', lights: [lamp, redSide, spot] },
  { name: 'perceptual tone, reflected light', material: { toneCurve: 'perceptual', reflectedLight: 0.4 } },
  ...(['tone', 'cross', 'reorient'] as const).flatMap((shadowStrokes) => [
    { name: `in shadow, ${shadowStrokes}`, lights: [blocked, ambient], material: { shadowStrokes } },
    {
      name: `in the shadow of one of three lights, ${shadowStrokes}, moved object`,
      lights: [lamp, blocked, redSide],
      matrixWorld: placed,
      material: { shadowStrokes },
    },
  ]),
  { name: 'out of all shadows, cross', lights: [directional, redSide], material: { shadowStrokes: 'cross' } },
];

const test = testOnOnePage('tests/gpu/harness.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.renderHatching !== undefined);
});

/** Linear RGB per pixel that is wholly inside the picture of the mesh. */
function expected(spec: HatchingSpec, subpixelBits: number): Map<number, Vec3> {
  const { positions, normals, indices, matrixWorld, camera, lights, lines, screenConstancy } = spec;
  const material = spec.material as ReferenceMaterial;
  const reference = new HatchingReference({
    matrixWorld,
    eye,
    orthographic: !!spec.orthographic,
    lights,
    material,
    tones: 2,
    image: () => 0,
  });
  const engraved = new EngravedReference({
    reference,
    settings: {
      ...lines!,
      strokeRotation: material.strokeRotation,
      strokeScale: material.strokeScale,
      screenConstancy: screenConstancy!,
      shadowStrokes: material.shadowStrokes,
    },
    lights,
    matrixWorld,
    camera,
    size: SIZE,
    centre: [0, 1, 2].map((axis) => {
      const along = positions.filter((_, i) => i % 3 === axis);
      return (Math.min(...along) + Math.max(...along)) / 2;
    }) as Vec3,
  });
  // three turns normals of vertices, and brings them to a length of 1, before it interpolates them.
  const worldNormals = Array.from({ length: normals!.length / 3 }, (_, i) =>
    reference.normalToWorld(normals!.slice(3 * i, 3 * i + 3) as Vec3),
  ).flat();
  const fragments = rasterizeReference(trianglesOf(spec), matrixWorld, camera, SIZE, SIZE, false, subpixelBits);
  return new Map(
    interiorPixels(fragments, SIZE, SIZE).map((pixel) => {
      const fragment = fragments[pixel]!;
      const [place, normal, toneNormal] = [positions, normals!, worldNormals].map((values) =>
        interpolated(values, indices, fragment),
      ) as [Vec3, Vec3, Vec3];
      const blank = 1 - engraved.darkness(place, normal, toneNormal);
      return [pixel, [blank, blank, blank]];
    }),
  );
}

for (const { name, mesh = torus, ...rest } of cases) {
  test(`engraved equals the double-precision reference: ${name}`, async ({ page }) => {
    const spec: HatchingSpec = {
      width: SIZE,
      height: SIZE,
      positions: toFloat(mesh.positions),
      normals: mesh.normals!,
      indices: mesh.indices,
      matrixWorld: rest.matrixWorld ?? identity,
      camera: rest.isOrthographic ? orthographic : perspective,
      orthographic: !!rest.isOrthographic,
      lights: rest.lights ?? [directional],
      material: { ...defaults, ...rest.material, technique: 'engraved', toneNormal: 'smooth' },
      map: 'smooth',
      screenConstancy: rest.screenConstancy ?? 1,
      lines: {
        lineField: 'light',
        lineSpacing: 7,
        crossFrom: 0.52,
        crossAngle: Math.PI / 3,
        handmade: 0.4,
        ...rest.lines,
      },
    };
    const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');
    const reference = expected(spec, await page.evaluate(() => window.subpixelBits));
    expect(reference.size, 'interior pixels').toBeGreaterThan(3000);
    const error = pictureError(pixels, reference);
    test.info().annotations.push(describeError(error));
    expectEqualPictures(error);
  });
}
