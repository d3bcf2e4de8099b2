import { mat4 } from 'gl-matrix';
import { axisAngle } from '../../src/look/vectors.js';
import { quickOnly } from '../browser/quickIf.js';
import { expect, testOnOnePage } from '../browser/test.js';
import { HatchingReference, type ReferenceLight, type ReferenceMaterial } from '../reference/hatchingReference.js';
import { interpolated } from '../reference/interpolated.js';
import { cube, type PlainMesh, sheet, toFloat, torus, trianglesOf } from '../reference/meshes.js';
import { interiorPixels, rasterizeReference } from '../reference/rasterizeReference.js';
import { referenceAdjacency, type Vec3 } from '../reference/referenceAdjacency.js';
import { ANALYTIC_TONES, analyticMaps, analyticThreshold } from './analyticMaps.js';
import type { HatchingSpec } from './hatchingSpec.js';
import { loadBunny } from './loadBunny.js';
import { describeError, expectEqualPictures, pictureError } from './pictureError.js';
import {
  ambient,
  crossed,
  defaults,
  directional,
  eye,
  fadingSpot,
  hemisphere,
  identity,
  mirrored,
  moved,
  movedBack,
  orthographic,
  perspective,
  placed,
  point,
  redSide,
  rotated,
  spot,
  squashed,
} from './referenceScenes.js';

/** Pixels per side of a picture: the bunny's triangles are small. */
const sizeOf = (mesh: Case['mesh']): number => (mesh === loadBunny ? 192 : 128);

interface Case {
  name: string;
  mesh: PlainMesh | (() => PlainMesh);
  lights?: ReferenceLight[];
  material?: Partial<ReferenceMaterial>;
  matrixWorld?: number[];
  map?: HatchingSpec['map'];
  doubleSided?: boolean;
  orthographic?: boolean;
}

const meshes = { cube, torus, sheet, bunny: loadBunny };
const lights = { directional: [directional], point: [point], spot: [spot] };
const every = { ...lights, 'fading spot': [fadingSpot], 'hemisphere and directional': [hemisphere, directional] };
const placements = { identity, placed, mirrored };
const models = ['lambert', 'halfLambert', 'phong', 'toon'] as const;
const curves = {
  perceptual: 'perceptual',
  'through two points': [
    [0.1, 0.05],
    [0.8, 0.9],
  ],
  'through six points': [
    [0, 0.1],
    [0.2, 0.15],
    [0.35, 0.6],
    [0.5, 0.6],
    [0.9, 0.3],
    [1, 1],
  ],
} satisfies Record<string, ReferenceMaterial['toneCurve']>;

const cases: Case[] = [
  // Every mesh, light and technique, with both maps.
  ...Object.entries(meshes).flatMap(([meshName, mesh]) =>
    Object.entries(lights).flatMap(([lightName, list]) =>
      (['triangle', 'adjacency'] as const).flatMap((technique) =>
        (['smooth', 'constantPerTone'] as const).map((map) => ({
          name: `${meshName}, ${lightName}, ${technique}, ${map} map`,
          mesh,
          lights: list,
          material: { technique },
          map,
          doubleSided: meshName === 'sheet',
        })),
      ),
    ),
  ),
  // Every tone model under every light; the placements take turns.
  ...models.flatMap((toneModel, i) =>
    Object.entries(every).map(([lightName, list], j) => {
      const [placement, matrixWorld] = Object.entries(placements)[(i + j) % 3];
      return {
        name: `${toneModel}, ${lightName}, ${placement}`,
        mesh: torus,
        lights: list,
        matrixWorld,
        material: { toneModel, shininess: 12, toneSteps: 3, toneNormal: j % 2 ? 'smooth' : 'face' } as const,
      };
    }),
  ),
  ...Object.entries(curves).flatMap(([name, toneCurve], i) => [
    { name: `tone curve ${name}`, mesh: torus, material: { toneCurve } },
    {
      name: `tone curve ${name}, per triangle, with ${models[i + 1]}`,
      mesh: loadBunny,
      lights: [point],
      material: { toneCurve, toneModel: models[i + 1], technique: 'triangle' } as const,
    },
  ]),
  ...Object.entries({ ...every, 'several lights': [redSide, fadingSpot] }).map(([name, list], i) => ({
    name: `reflected light, ${name}`,
    mesh: torus,
    lights: list,
    matrixWorld: [identity, placed, mirrored][i % 3],
    material: { reflectedLight: 0.4 },
  })),
  ...(['triangle', 'adjacency'] as const).flatMap((technique) => [
    {
      name: `second layer under two lights, ${technique}`,
      mesh: torus,
      lights: crossed,
      material: { technique, strokeLayers: 'lights' } as const,
    },
    {
      name: `second layer under three lights, moved object, ${technique}`,
      mesh: torus,
      lights: [redSide, point, spot],
      matrixWorld: placed,
      material: { technique, strokeLayers: 'lights', toneNormal: 'smooth' } as const,
    },
    {
      name: `second layer, ${technique}, blend alone`,
      mesh: torus,
      lights: crossed,
      map: 'constantPerTone' as const,
      matrixWorld: mirrored,
      material: { technique, strokeLayers: 'lights', toneCurve: 'perceptual' } as const,
    },
    {
      name: `layers by tone, ${technique}`,
      mesh: torus,
      material: { technique, strokeLayers: 'tone' } as const,
    },
    {
      name: `layers by tone, early, at a right angle, moved object, ${technique}`,
      mesh: loadBunny,
      lights: [point],
      matrixWorld: placed,
      material: { technique, strokeLayers: 'tone', crossFrom: 0.1, crossAngle: Math.PI / 2 } as const,
    },
    {
      name: `level by depth, ${technique}`,
      mesh: torus,
      map: 'constantPerLevel' as const,
      material: { technique, levelRule: 'depth' } as const,
    },
    {
      name: `level by depth on a smaller object, ${technique}`,
      mesh: loadBunny,
      matrixWorld: placed,
      map: 'constantPerLevel' as const,
      material: { technique, levelRule: 'depth', tilesPerObjectUnit: 0.6 } as const,
    },
  ]),
  {
    name: 'level by depth, orthographic camera',
    mesh: torus,
    orthographic: true,
    map: 'constantPerLevel',
    material: { levelRule: 'depth', tilesPerObjectUnit: 0.9 },
  },
  ...[0, Math.PI / 2, 2.4].map((strokeAngle, i) => ({
    name: `strokes turned by ${strokeAngle.toFixed(1)}, scaled and shifted`,
    mesh: torus,
    lights: [i % 2 ? point : directional],
    material: {
      technique: i % 2 ? ('triangle' as const) : ('adjacency' as const),
      strokeAngle,
      tilesPerObjectUnit: 0.8 + i,
      strokeOffset: [0.7 * i, -0.2] as [number, number],
    },
  })),
  { name: 'rotated, moved and scaled object', mesh: loadBunny, matrixWorld: placed, lights: [point] },
  { name: 'rotated object under a directional light', mesh: torus, matrixWorld: rotated },
  { name: 'mirrored object', mesh: loadBunny, matrixWorld: mirrored },
  { name: 'mirrored object, point light', mesh: torus, matrixWorld: mirrored, lights: [point] },
  { name: 'object scaled unequally', mesh: loadBunny, matrixWorld: squashed },
  { name: 'object scaled unequally, point light', mesh: torus, matrixWorld: squashed, lights: [point] },
  { name: 'geometry far from its origin', mesh: moved(torus, 50), matrixWorld: movedBack(50) },
  { name: 'light along normals', mesh: cube, lights: [{ ...directional, position: [0, 0, 1] }] },
  {
    name: 'back side of a double-sided sheet',
    mesh: sheet,
    doubleSided: true,
    matrixWorld: [...mat4.fromYRotation(mat4.create(), 2.6)],
  },
  { name: 'orthographic camera, phong', mesh: torus, orthographic: true, material: { toneModel: 'phong' } },
  { name: 'ambient light beside a directional one', mesh: torus, lights: [ambient, directional] },
  { name: 'hemisphere light beside a point light', mesh: torus, lights: [hemisphere, point] },
  { name: 'hemisphere light alone', mesh: loadBunny, lights: [hemisphere] },
  { name: 'two coloured directional lights', mesh: torus, lights: [directional, redSide] },
  { name: 'directional, point and spot light together', mesh: loadBunny, lights: [redSide, point, spot] },
  { name: 'smooth tone', mesh: torus, material: { toneNormal: 'smooth' }, lights: [point] },
  { name: 'smooth tone on a mirrored object', mesh: torus, material: { toneNormal: 'smooth' }, matrixWorld: mirrored },
  { name: 'crease angle of 30°', mesh: torus, material: { blendAngle: Math.PI / 6 } },
  {
    name: 'ink, paper and colour',
    mesh: torus,
    material: { ink: [0.1, 0.02, 0.3], paper: [0.9, 0.8, 0.6], color: [0.5, 0.9, 0.7] },
  },
  {
    name: 'ink that multiplies',
    mesh: torus,
    material: { ink: [0.2, 0.5, 0.9], paper: [0.9, 0.8, 0.6], color: [0.5, 0.9, 0.7], inkBlend: 'multiply' },
  },
  ...(['triangle', 'adjacency'] as const).map((technique) => ({
    name: `local tone without a fill, ${technique}`,
    mesh: torus,
    material: { technique, color: [0.5, 0.1, 0.2] as Vec3, colorHatching: 1, colorFill: 0 },
  })),
  {
    name: 'some local tone of a colour nearly black, on a tint of it',
    mesh: torus,
    material: { color: [0.01, 0.004, 0.006], colorHatching: 0.7, colorFill: 0.4, toneCurve: 'perceptual' },
    lights: [point, ambient],
  },
];

type ShadeArguments = Parameters<HatchingReference['shade']>;

/** The reference's values for every pixel in the interior of a triangle. */
function expected<Shade>(
  spec: HatchingSpec,
  shade: (reference: HatchingReference, ...at: ShadeArguments) => Shade,
): Map<number, Shade> {
  const triangles = trianglesOf(spec);
  const neighbours = referenceAdjacency(triangles);
  const fragments = rasterizeReference(
    triangles,
    spec.matrixWorld,
    spec.camera,
    spec.width,
    spec.height,
    !!spec.doubleSided,
  );
  const backward = mat4.invert(mat4.create(), spec.camera.view as unknown as mat4)!;
  const reference = new HatchingReference({
    matrixWorld: spec.matrixWorld,
    eye: spec.orthographic ? ([backward[8], backward[9], backward[10]] as Vec3) : eye,
    orthographic: !!spec.orthographic,
    lights: spec.lights,
    // The reference turns strokes the other way.
    material: { ...(spec.material as ReferenceMaterial), strokeAngle: -axisAngle(spec.material.strokeAngle) },
    tones: ANALYTIC_TONES,
    image: analyticMaps[spec.map].darkness,
    size: analyticMaps[spec.map].size,
    levels: analyticMaps[spec.map].levels,
    unitsPerPixel: (at) => {
      const [x, y, z] = at;
      const view = spec.camera.view;
      const depth = -(view[2] * x + view[6] * y + view[10] * z + view[14]);
      return ((spec.orthographic ? 1 : depth) * 2) / (spec.camera.projection[5] * spec.height);
    },
  });
  return new Map(
    interiorPixels(fragments, spec.width, spec.height).map((pixel) => {
      const fragment = fragments[pixel]!;
      const { triangle, barycentric, faceDirection } = fragment;
      const smooth: Vec3 = spec.normals ? interpolated(spec.normals, spec.indices, fragment) : [0, 0, 1];
      const at: ShadeArguments = [triangles[triangle], neighbours[triangle], barycentric, faceDirection, smooth];
      return [pixel, shade(reference, ...at)];
    }),
  );
}

const test = testOnOnePage('tests/gpu/harness.html');

test.beforeEach(async ({ page }) => {
  await page.waitForFunction(() => window.renderHatching !== undefined);
});

function specOf({ mesh, ...rest }: Case): HatchingSpec {
  const { positions, normals, indices } = typeof mesh === 'function' ? mesh() : mesh;
  const size = sizeOf(mesh);
  return {
    width: size,
    height: size,
    positions: toFloat(positions),
    ...(normals && { normals }),
    indices,
    matrixWorld: rest.matrixWorld ?? identity,
    camera: rest.orthographic ? orthographic : perspective,
    orthographic: !!rest.orthographic,
    lights: rest.lights ?? [directional],
    material: { ...defaults, ...rest.material },
    map: rest.map ?? 'smooth',
    doubleSided: !!rest.doubleSided,
  };
}

/** Names of cases that together have each mesh, light, technique, tone model, layer, placement and look. */
const detailsOf = quickOnly(
  cases.map(({ name }) => name),
  [
    'cube, directional, triangle, smooth map',
    'torus, point, adjacency, smooth map',
    'sheet, spot, triangle, constantPerTone map',
    'bunny, directional, adjacency, constantPerTone map',
    'halfLambert, fading spot, placed',
    'phong, point, identity',
    'toon, hemisphere and directional, placed',
    'tone curve through six points',
    'reflected light, several lights',
    'second layer under three lights, moved object, adjacency',
    'layers by tone, triangle',
    'level by depth, adjacency',
    'strokes turned by 1.6, scaled and shifted',
    'object scaled unequally, point light',
    'back side of a double-sided sheet',
    'orthographic camera, phong',
    'smooth tone on a mirrored object',
    'crease angle of 30°',
    'ink that multiplies',
    'some local tone of a colour nearly black, on a tint of it',
  ],
);

for (const one of cases) {
  test(`equals the double-precision reference: ${one.name}`, detailsOf(one.name), async ({ page }) => {
    const spec = specOf(one);
    const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');
    const reference = expected(spec, (reference, ...at) => reference.shade(...at));
    expect(reference.size, 'interior pixels').toBeGreaterThan(3000);

    const error = pictureError(pixels, reference);
    test.info().annotations.push(describeError(error));
    expectEqualPictures(error);
  });
}

// Fine enough that the coarsest level of the map serves everywhere.
const fine = { sharpInk: true, tilesPerObjectUnit: 3 };

const crispCases: Case[] = (['triangle', 'adjacency'] as const).flatMap((technique) => [
  { name: `one layer, ${technique}`, mesh: torus, material: { ...fine, technique } },
  { name: `layers by tone, ${technique}`, mesh: torus, material: { ...fine, technique, strokeLayers: 'tone' } },
  {
    name: `layers by tone, early, at a right angle, moved object, ${technique}`,
    mesh: loadBunny,
    lights: [point],
    matrixWorld: placed,
    material: { ...fine, technique, strokeLayers: 'tone', crossFrom: 0.2, crossAngle: Math.PI / 2 },
  },
  {
    name: `layers by disagreeing lights, ${technique}`,
    mesh: torus,
    lights: crossed,
    material: { ...fine, technique, strokeLayers: 'lights' },
  },
]);

const crispDetailsOf = quickOnly(
  crispCases.map(({ name }) => name),
  ['layers by tone, adjacency', 'layers by disagreeing lights, triangle'],
);

for (const one of crispCases) {
  test(`crisp, equals the double-precision reference: ${one.name}`, crispDetailsOf(one.name), async ({ page }) => {
    const spec = specOf(one);
    const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');
    const { field, levels } = analyticThreshold;
    const excess = expected(spec, (reference, ...at) =>
      reference.crispExcess((u, v) => field(u, v, levels - 1), ...at),
    );
    expect(excess.size, 'interior pixels').toBeGreaterThan(3000);
    let [inked, wrong] = [0, 0];
    for (const [pixel, over] of excess) {
      if (over > 0) inked++;
      // Rounding decides on the very edge of a stroke.
      if (Math.abs(over) > 0.01 && pixels[4 * pixel] < 128 !== over > 0) wrong++;
    }
    expect(inked / excess.size, 'share of ink').toBeGreaterThan(0.1);
    expect(inked / excess.size, 'share of ink').toBeLessThan(0.98);
    expect(wrong / excess.size, 'share of pixels on the wrong side').toBeLessThanOrEqual(0.01);
    test.info().annotations.push({ type: 'error', description: `${((100 * wrong) / excess.size).toFixed(2)} % wrong` });
  });
}
