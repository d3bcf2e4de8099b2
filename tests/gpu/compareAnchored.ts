import { mat4, vec3 } from 'gl-matrix';
import { axisAngle } from '../../src/look/vectors.js';
import { quickOnly } from '../browser/quickIf.js';
import { expect, type TestOnOnePage } from '../browser/test.js';
import { type AnchoredSettings, anchoredExcess, formAxisOf, slantAxisOf } from '../reference/anchoredReference.js';
import { interpolated } from '../reference/interpolated.js';
import { trianglesOf } from '../reference/meshes.js';
import { interiorPixels, rasterizeReference } from '../reference/rasterizeReference.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';
import { analyticThreshold } from './analyticMaps.js';
import type { HatchingSpec } from './hatchingSpec.js';
import { quadraticGradient } from './quadratics.js';
import { centreOf, type ReferenceCase, referenceOf, SIZE, specOf } from './referenceCase.js';
import {
  ambient,
  blocked,
  crossed,
  directional,
  hemisphere,
  leaning,
  mirrored,
  placed,
  point,
  redSide,
  rotated,
  spot,
  wall,
} from './referenceScenes.js';

interface AnchoredCase extends ReferenceCase {
  latticeSpacing?: number;
  direction?: 'form' | 'acrossForm' | 'sheet';
}

/** Functions whose gradients turn over the torus by what strokes can follow. */
const form = [
  { linear: [1.5, 5, 0.5], squares: [1.2, -0.6, 0.4] },
  { linear: [4.5, -2.2, 1], squares: [0, 0.5, -0.3] },
] as const satisfies NonNullable<HatchingSpec['strokes']>['form'];

const cases: AnchoredCase[] = [
  { name: 'directional light' },
  {
    name: 'falling off around a point, towards the rim and of less importance',
    importance: 0.7,
    material: { focus: [0.3, 0.4, 0.2], focusRadius: 0.5, vignette: 0.6 },
  },
  { name: 'fading with its depth', material: { depthFade: 0.8, depthFadeStart: 2.4, depthFadeEnd: 4.1 } },
  { name: 'point light', lights: [point] },
  { name: 'spot light', lights: [spot] },
  { name: 'hemisphere light alone', lights: [hemisphere] },
  { name: 'two lights', lights: [directional, redSide] },
  { name: 'rotated object', matrixWorld: rotated },
  { name: 'rotated, moved and scaled object', matrixWorld: placed, lights: [point] },
  { name: 'mirrored object', matrixWorld: mirrored },
  {
    name: 'no rotation, other scale and spacing',
    material: { strokeAngle: 0, tilesPerObjectUnit: 3 },
    latticeSpacing: 0.6,
  },
  { name: 'between levels of the map', material: { tilesPerObjectUnit: 0.6 } },
  { name: 'seen at a slant', mesh: wall, matrixWorld: leaning, material: { strokeAngle: 0 } },
  {
    name: 'seen at a slant, strokes the other way',
    mesh: wall,
    matrixWorld: leaning,
    material: { strokeAngle: 1.5 },
  },
  {
    name: 'seen at a slant, two lights and layers',
    mesh: wall,
    matrixWorld: leaning,
    lights: crossed,
    material: { strokeLayers: 'lights' },
  },
  {
    name: 'seen at a slant by an orthographic camera',
    mesh: wall,
    matrixWorld: leaning,
    isOrthographic: true,
    screenSpaceShare: 1,
  },
  { name: 'sized on the screen', screenSpaceShare: 1 },
  { name: 'sized on the screen, seen at a slant', mesh: wall, matrixWorld: leaning, screenSpaceShare: 1 },
  { name: 'sized on the screen, placed object', screenSpaceShare: 1, matrixWorld: placed, lights: [point] },
  { name: 'sized half on the screen, two lights', screenSpaceShare: 0.5, lights: [directional, redSide] },
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
  {
    name: 'local tone, in a shadow that crosses',
    lights: [blocked, ambient],
    material: { color: [0.3, 0.12, 0.5], colorHatching: 0.8, colorFill: 0, shadowStrokes: 'cross' },
  },
  { name: 'reflected light', lights: [spot], material: { reflectedLight: 0.4 } },
  {
    name: 'exposed, of a colour, in a shadow that crosses',
    lights: [blocked, ambient],
    material: { exposure: 1.7, color: [0.3, 0.12, 0.5], colorHatching: 0.5, colorFill: 0, shadowStrokes: 'cross' },
  },
  { name: 'second layer under two lights', lights: crossed, material: { strokeLayers: 'lights' } },
  {
    name: 'second layer under three lights, moved object',
    lights: [redSide, point, spot],
    matrixWorld: placed,
    material: { strokeLayers: 'lights', toneCurve: 'perceptual' },
  },
  { name: 'second layer under one light: none', material: { strokeLayers: 'lights' } },
  { name: 'layers by tone', material: { strokeLayers: 'tone' } },
  {
    name: 'layers by tone, at a right angle, early, moved object',
    lights: [point],
    matrixWorld: placed,
    material: { strokeLayers: 'tone', crossFrom: 0.2, crossAngle: Math.PI / 2 },
  },
  {
    name: 'layers by tone under two lights, seen at a slant, sized on the screen',
    mesh: wall,
    matrixWorld: leaning,
    lights: crossed,
    material: { strokeLayers: 'tone', crossFrom: 0.1, crossAngle: 0.4 },
    screenSpaceShare: 1,
  },
  ...(['tone', 'cross', 'reorient'] as const).flatMap((shadowStrokes) => [
    { name: `in shadow, ${shadowStrokes}`, lights: [blocked, ambient], material: { shadowStrokes } },
    {
      name: `in the shadow of one of two lights, ${shadowStrokes}, moved object`,
      lights: [redSide, blocked],
      matrixWorld: placed,
      material: { shadowStrokes },
    },
  ]),
  ...(
    [
      { name: 'under two lights', lights: [directional, redSide] },
      { name: 'sized on the screen', screenSpaceShare: 1 },
      { name: 'of a moved object', matrixWorld: placed },
      { name: 'of a mirrored object', matrixWorld: mirrored },
      { name: 'in layers by tone', material: { strokeLayers: 'tone', crossFrom: 0.2 } },
      { name: 'in layers for lights: one', lights: crossed, material: { strokeLayers: 'lights' } },
      { name: 'crossed in shadow', lights: [blocked, ambient], material: { shadowStrokes: 'cross' } },
      { name: 'turned in shadow', lights: [blocked, ambient], material: { shadowStrokes: 'reorient' } },
      { name: 'in the shadow of one light', lights: [redSide, blocked], material: { shadowStrokes: 'reorient' } },
    ] as const satisfies ReferenceCase[]
  ).map(({ name, ...rest }) => ({ ...rest, name: `along the form, ${name}`, direction: 'form' as const })),
  { name: 'across the form', direction: 'acrossForm' },
  ...(
    [
      { name: 'of a moved and scaled object', matrixWorld: placed },
      { name: 'of a mirrored object', matrixWorld: mirrored },
      { name: 'seen by an orthographic camera', matrixWorld: rotated, isOrthographic: true },
      { name: 'under two lights', lights: [directional, redSide], screenSpaceShare: 1 },
    ] as const satisfies ReferenceCase[]
  ).map(({ name, ...rest }) => ({ ...rest, name: `along the sheet, ${name}`, direction: 'sheet' as const })),
  { name: 'out of all shadows, cross', lights: [directional, redSide], material: { shadowStrokes: 'cross' } },
];

/** The gradient of the first function, which is one of the place from the centre in tiles. */
function gradientAt({ positions, material }: HatchingSpec): (point: Vec3) => Vec3 {
  const centre = centreOf(positions);
  return (point) =>
    quadraticGradient(form[0], point.map((x, axis) => (x - centre[axis]) * material.tilesPerObjectUnit) as Vec3);
}

/** The page's input for a case. */
const specFor = ({ latticeSpacing = 0.35, screenSpaceShare = 0, direction, ...rest }: AnchoredCase): HatchingSpec => ({
  ...specOf({ ...rest, screenSpaceShare }, 'hatching'),
  latticeSpacing,
  ...(direction && { strokes: { direction, ...(direction !== 'sheet' && { form }) } }),
});

/** The page's input for all cases of `hatching`, by name. */
export const anchoredSpecs = (): Map<string, HatchingSpec> => new Map(cases.map((one) => [one.name, specFor(one)]));

/** Names of cases that together have each light, layer, field, placement and look. */
const detailsOf = quickOnly(
  cases.map(({ name }) => name),
  [
    'falling off around a point, towards the rim and of less importance',
    'fading with its depth',
    'rotated, moved and scaled object',
    'mirrored object',
    'seen at a slant, two lights and layers',
    'sized on the screen, placed object',
    'phong, point light, moved object',
    'tone curve of points',
    'exposed, of a colour, in a shadow that crosses',
    'layers by tone under two lights, seen at a slant, sized on the screen',
    'in the shadow of one of two lights, reorient, moved object',
    'along the form, in layers by tone',
    'across the form',
    'along the sheet, of a moved and scaled object',
  ],
);

/**
 * Declares a test for each case of `hatching`: the page draws what the reference in double precision says.
 *
 * @param test whose page has `renderHatching`
 */
export function compareAnchored(test: TestOnOnePage): void {
  for (const one of cases) {
    test(`hatching equals the double-precision reference: ${one.name}`, detailsOf(one.name), async ({ page }) => {
      const spec = specFor(one);
      const { direction } = one;
      const { positions, indices } = spec;
      const normals = spec.normals!;
      const pixels = Buffer.from(await page.evaluate((s) => window.renderHatching(s), spec), 'base64');

      const fragments = rasterizeReference(trianglesOf(spec), spec.matrixWorld, spec.camera, SIZE, SIZE, false);
      const reference = referenceOf(spec);
      const hasForm = direction === 'form' || direction === 'acrossForm';
      const settings: AnchoredSettings = {
        tilesPerObjectUnit: spec.material.tilesPerObjectUnit,
        // The reference turns strokes the other way.
        strokeAngle: -axisAngle(spec.material.strokeAngle),
        latticeSpacing: spec.latticeSpacing!,
        halfTiles: hasForm || spec.lights.filter(({ type }) => type !== 'ambient').length > 1,
        screenSpaceShare: spec.screenSpaceShare!,
        shadowStrokes: spec.material.shadowStrokes,
        ...(hasForm && { axisAt: formAxisOf(gradientAt(spec), direction === 'acrossForm') }),
        ...(direction === 'sheet' && {
          axisAt: slantAxisOf(spec.camera, spec.matrixWorld, axisAngle(spec.material.strokeAngle)),
        }),
        threshold: analyticThreshold.field,
        mapSize: analyticThreshold.size,
        mapLevels: analyticThreshold.levels,
      };
      // Object units to a pixel at a depth of 1.
      const scale = Math.cbrt(Math.abs(mat4.determinant(spec.matrixWorld as unknown as mat4)));
      const unitsPerPixel = 2 / (spec.camera.projection[5] * SIZE * scale);
      const interior = interiorPixels(fragments, SIZE, SIZE);
      expect(interior.length).toBeGreaterThan(3000);
      let inked = 0;
      let wrong = 0;
      let grey = 0;
      for (const pixel of interior) {
        const position = interpolated(positions, indices, fragments[pixel]!);
        const normal = interpolated(normals, indices, fragments[pixel]!);
        const length = Math.hypot(...normal);
        const unit = normal.map((x) => x / length) as Vec3;
        const depth = spec.orthographic
          ? 1
          : -vec3.transformMat4([0, 0, 0], reference.toWorld(position), spec.camera.view as unknown as mat4)[2];
        const excess = anchoredExcess(reference, position, unit, normal, depth * unitsPerPixel, settings);
        const value = pixels[4 * pixel];
        if (value !== 0 && value !== 255) grey++;
        if (excess > 0) inked++;
        // Rounding decides on the very edge of a stroke.
        if (Math.abs(excess) > 0.01 && value < 128 !== excess > 0) wrong++;
      }
      // With few strokes in the picture, their share depends on their places.
      expect(inked, 'pixels of ink').toBeGreaterThan(0.08 * interior.length);
      expect(inked, 'pixels of ink').toBeLessThan(0.98 * interior.length);
      // A pixel whose threshold equals the tone may be half dark by rounding.
      expect(grey, 'grey pixels, with hard edges').toBeLessThanOrEqual(2);
      expect(wrong / interior.length, 'share of pixels on the wrong side').toBeLessThanOrEqual(0.01);
      test
        .info()
        .annotations.push({ type: 'error', description: `${((100 * wrong) / interior.length).toFixed(2)} % wrong` });
    });
  }
}
