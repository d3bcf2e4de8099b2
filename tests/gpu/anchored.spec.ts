import { mat4, vec3 } from 'gl-matrix';
import { type StrokeStyleName, strokeStyles } from '../../src/tam/strokeStyles.js';
import { expect, test } from '../browser/test.js';
import { type AnchoredSettings, anchoredExcess } from '../reference/anchoredReference.js';
import { HatchingReference, type ReferenceLight, type ReferenceMaterial } from '../reference/hatchingReference.js';
import { type PlainMesh, torus, trianglesOf } from '../reference/meshes.js';
import { interiorPixels, rasterizeReference } from '../reference/rasterizeReference.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';
import { analyticThreshold } from './analyticMaps.js';
import type { HatchingSpec } from './hatchingSpec.js';
import {
  crossed,
  defaults,
  directional,
  eye,
  hemisphere,
  identity,
  mirrored,
  perspective,
  placed,
  point,
  redSide,
  rotated,
  spot,
} from './referenceScenes.js';

const SIZE = 192;

interface Case {
  name: string;
  lights?: ReferenceLight[];
  matrixWorld?: number[];
  material?: Partial<ReferenceMaterial>;
  anchorSpacing?: number;
  screenConstancy?: number;
}

const cases: Case[] = [
  { name: 'directional light' },
  { name: 'point light', lights: [point] },
  { name: 'spot light', lights: [spot] },
  { name: 'hemisphere light alone', lights: [hemisphere] },
  { name: 'two lights', lights: [directional, redSide] },
  { name: 'rotated object', matrixWorld: rotated },
  { name: 'rotated, moved and scaled object', matrixWorld: placed, lights: [point] },
  { name: 'mirrored object', matrixWorld: mirrored },
  { name: 'no rotation, other scale and spacing', material: { strokeRotation: 0, strokeScale: 3 }, anchorSpacing: 0.6 },
  { name: 'between levels of the map', material: { strokeScale: 0.6 } },
  { name: 'sized on the screen', screenConstancy: 1 },
  { name: 'sized on the screen, placed object', screenConstancy: 1, matrixWorld: placed, lights: [point] },
  { name: 'sized half on the screen, two lights', screenConstancy: 0.5, lights: [directional, redSide] },
  ...(['halfLambert', 'phong', 'toon'] as const).flatMap((toneModel) => [
    { name: toneModel, material: { toneModel } },
    { name: `${toneModel}, point light, moved object`, lights: [point], matrixWorld: placed, material: { toneModel } },
  ]),
  { name: 'perceptual tone', material: { toneCurve: 'perceptual' } },
  {
    name: 'tone curve of points',
    material: {
      toneCurve: [
        [0, 0.2],
        [0.4, 0.9],
        [1, 0.5],
      ],
    },
  },
  { name: 'reflected light', lights: [spot], material: { reflectedLight: 0.4 } },
  { name: 'second layer under two lights', lights: crossed, material: { secondLayer: true } },
  {
    name: 'second layer under three lights, moved object',
    lights: [redSide, point, spot],
    matrixWorld: placed,
    material: { secondLayer: true, toneCurve: 'perceptual' },
  },
  { name: 'second layer under one light: none', material: { secondLayer: true } },
];

test.beforeEach(async ({ page }) => {
  await page.goto('tests/gpu/harness.html');
  await page.waitForFunction(() => window.renderHatching !== undefined);
});

for (const { name, lights, matrixWorld, material, anchorSpacing, screenConstancy } of cases) {
  test(`anchored equals the double-precision reference: ${name}`, async ({ page }) => {
    const mesh = torus as Required<PlainMesh>;
    const spec: HatchingSpec = {
      width: SIZE,
      height: SIZE,
      ...mesh,
      matrixWorld: matrixWorld ?? identity,
      camera: perspective,
      lights: lights ?? [directional],
      material: { ...defaults, ...material, technique: 'anchored', toneNormal: 'smooth' },
      map: 'smooth',
      anchorSpacing: anchorSpacing ?? 0.35,
      screenConstancy: screenConstancy ?? 0,
    };
    const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');

    const triangles = trianglesOf(mesh);
    const fragments = rasterizeReference(triangles, spec.matrixWorld, spec.camera, SIZE, SIZE, false);
    const reference = new HatchingReference({
      matrixWorld: spec.matrixWorld,
      eye,
      lights: spec.lights,
      material: spec.material as ReferenceMaterial,
      tones: 2,
      image: () => 0,
    });
    const settings: AnchoredSettings = {
      strokeScale: spec.material.strokeScale,
      strokeRotation: spec.material.strokeRotation,
      anchorSpacing: spec.anchorSpacing!,
      halfTiles: spec.lights.length > 1,
      screenConstancy: spec.screenConstancy!,
      threshold: analyticThreshold.field,
      mapSize: analyticThreshold.size,
      mapLevels: analyticThreshold.levels,
    };
    // Object units to a pixel at a depth of 1.
    const scale = Math.cbrt(Math.abs(mat4.determinant(spec.matrixWorld as unknown as mat4)));
    const unitsPerPixel = 2 / (spec.camera.projection[5]! * SIZE * scale);
    const interior = interiorPixels(fragments, SIZE, SIZE);
    expect(interior.length).toBeGreaterThan(3000);
    let inked = 0;
    let wrong = 0;
    let grey = 0;
    for (const pixel of interior) {
      const { triangle, barycentric } = fragments[pixel]!;
      const interpolate = (of: (corner: number) => number[]) =>
        [0, 1, 2].map((axis) =>
          [0, 1, 2].reduce((sum, k) => sum + barycentric[k]! * of(3 * triangle + k)[axis]!, 0),
        ) as Vec3;
      const vertexOf = (array: number[]) => (corner: number) => {
        const vertex = mesh.indices[corner]!;
        return array.slice(3 * vertex, 3 * vertex + 3);
      };
      const position = interpolate(vertexOf(mesh.positions));
      const normal = interpolate(vertexOf(mesh.normals));
      const length = Math.hypot(...normal);
      const unit = normal.map((x) => x / length) as Vec3;
      const depth = -vec3.transformMat4(
        [0, 0, 0],
        reference.toWorld(position),
        spec.camera.view as unknown as mat4,
      )[2]!;
      const excess = anchoredExcess(reference, position, unit, normal, depth * unitsPerPixel, settings);
      const value = pixels[4 * pixel]!;
      if (value !== 0 && value !== 255) grey++;
      if (excess > 0) inked++;
      // On the very edge of a stroke a rounding decides.
      if (Math.abs(excess) > 0.01 && value < 128 !== excess > 0) wrong++;
    }
    expect(inked, 'pixels of ink').toBeGreaterThan(0.1 * interior.length);
    expect(inked, 'pixels of ink').toBeLessThan(0.98 * interior.length);
    // Where threshold and tone are the same number, rounding leaves a half.
    expect(grey, 'grey pixels, with hard edges').toBeLessThanOrEqual(2);
    expect(wrong / interior.length, 'share of pixels on the wrong side').toBeLessThanOrEqual(0.01);
    test
      .info()
      .annotations.push({ type: 'error', description: `${((100 * wrong) / interior.length).toFixed(2)} % wrong` });
  });
}

for (const style of Object.keys(strokeStyles) as StrokeStyleName[]) {
  test(`anchored strokes print the tone asked for, at any size: ${style}`, async ({ page }, testInfo) => {
    await page.goto('tests/gpu/toolkit.html');
    await page.waitForFunction(() => window.toolkit !== undefined);
    const errors = await page.evaluate(measureTones, style);
    testInfo.annotations.push({ type: 'tone error', description: errors.map((error) => error.toFixed(3)).join(', ') });
    for (const error of errors) expect(Math.abs(error), errors.join()).toBeLessThan(0.03);
  });
}

/** Mean ink less the tone asked for, over tones and sizes of strokes, on a wall much larger than the map. */
async function measureTones(style: StrokeStyleName): Promise<number[]> {
  const { THREE, TonalArtMap, hatchedMesh, makeRenderer, sceneOf, sun } = window.toolkit;
  const [size, side, places] = [128, 512, 4];
  const tonalArtMap = await TonalArtMap.generate({ style, size });
  const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 10);
  const mesh = await hatchedMesh(new THREE.PlaneGeometry(40, 40), {
    technique: 'anchored',
    tonalArtMap,
    edgePixels: 0,
  });
  const light = sun();
  const scene = sceneOf(mesh, light);
  const renderer = makeRenderer();
  renderer.setSize(side, side, false);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(side * side * 4);
  const errors = [];
  for (const level of [0, 0.25, 0.5, 0.75]) {
    // So large that the map is too fine by so much of a level.
    mesh.material.strokeScale = (2 ** level * side) / (2 * size);
    for (const tone of [0.15, 0.4, 0.7]) {
      light.position.set(Math.sqrt(1 - (1 - tone) ** 2), 0, 1 - tone);
      let paper = 0;
      for (let place = 0; place < places; place++) {
        camera.position.set(2.1 * (place % 2), 2.1 * (place >> 1), 1);
        renderer.render(scene, camera);
        gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        for (let i = 0; i < pixels.length; i += 4) paper += pixels[i]!;
      }
      errors.push(1 - paper / (255 * side * side * places) - tone);
    }
  }
  return errors;
}
