import { mat4, vec3 } from 'gl-matrix';
import { expect, test } from 'vitest';
import { combined, type Vec3 } from '../../../../src/look/vectors.js';
import {
  KEPT_BY_PEN,
  leftOf,
  otherShare,
  sharedByTwo,
  THIRD_FROM,
  takenOf,
} from '../../../../src/vector/shading/crossedTones.js';
import { across, type CutField, type Field, firstField } from '../../../../src/vector/shading/fieldAxis.js';
import { handTone } from '../../../../src/vector/shading/hand.js';
import { fieldLight } from '../../../../src/vector/shading/lightField.js';
import {
  cutFamilies,
  familyGradient,
  familyValue,
  type Lean,
  readCut,
} from '../../../../src/vector/shading/readCut.js';
import { riseOf } from '../../../../src/vector/shading/ruledLines.js';
import { screenMap } from '../../../../src/vector/shading/screenGradient.js';
import { EngravedReference, type EngravedSettings } from '../../../reference/engravedReference.js';
import type { HatchingReference, ReferenceLight } from '../../../reference/hatchingReference.js';
import { randomNumbers } from '../randomNumbers.js';
import { familyDarkness } from './familyDarkness.js';

/**
 * Compares the darkness of a fragment, from the functions of the processor, with the reference. It depends on values, gradients, tones of
 * families, octaves, rooms, widths, strokes, the hand and the light of the field.
 */

const SIZE = 480;
const random = randomNumbers(7);
const between = (from: number, to: number): number => from + (to - from) * random();
const direction = (): Vec3 => {
  const [x, y, z] = vec3.normalize([0, 0, 0], [between(-1, 1), between(-1, 1), between(-1, 1)]);
  return [x, y, z];
};

const settings: EngravedSettings = {
  strokeRotation: 0.3,
  lineField: 'light',
  lineSpacing: 4.5,
  strokeLength: 72,
  crossFrom: 0.4,
  crossAngle: Math.PI / 3,
  handmade: 0.7,
  sizedOnScreen: 0.8,
  tilesPerUnit: 3,
  shadowStrokes: 'cross',
};
const matrixWorld = mat4.fromRotation(mat4.create(), 0.7, [1, 2, 0.5])!;
const centre: Vec3 = [0.2, -0.1, 0.05];

const sun: ReferenceLight = { type: 'directional', color: [3, 3, 3], position: [1, 2, 3], target: [0, 0, 0] };
const lamp: ReferenceLight = { type: 'point', color: [4, 2, 1], position: [2, 1.5, 1], decay: 2 };

/** In object space it is near the limit beyond which the axis across it is not derived from the world's up. */
const steep: ReferenceLight = {
  ...{ type: 'directional', color: [3, 3, 3], target: [0, 0, 0] },
  position: vec3.transformMat4([0, 0, 0], [0.4, 0.82, 0.41], matrixWorld) as [number, number, number],
};

const cameras = [
  { name: 'perspective', projection: mat4.perspective(mat4.create(), 0.8, 1, 0.1, 50), isOrthographic: false },
  { name: 'orthographic', projection: mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50), isOrthographic: true },
];
const view = mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0]);

const LEANS = (angle: number): Lean[] => {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  const other = { cosine: Math.sin(angle / 2), sine: -Math.cos(angle / 2) };
  return [
    { cosine: 1, sine: 0, side: null },
    { cosine, sine, side: 'B' },
    { cosine, sine, side: 'C' },
    { ...other, side: 'B' },
    { ...other, side: 'C' },
    { ...other, side: 'B' },
    { ...other, side: 'C' },
  ];
};

function fieldLamps(lights: readonly ReferenceLight[], tilesPerUnit: number) {
  const toObject = mat4.invert(mat4.create(), matrixWorld)!;
  return lights.map(({ type, position, color }) => {
    // Without the least weight that a light has even when switched off, which the reference lacks.
    const luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2] - 1e-6;
    const isFar = type === 'directional';
    const start = vec3.transformMat4([0, 0, 0], isFar ? [0, 0, 0] : (position as vec3), toObject);
    const end = vec3.transformMat4([0, 0, 0], isFar ? (position as vec3) : [0, 0, 0], toObject);
    const way: Vec3 = isFar
      ? [end[0] - start[0], end[1] - start[1], end[2] - start[2]]
      : [start[0] - centre[0], start[1] - centre[1], start[2] - centre[2]];
    return { toLight: combined(tilesPerUnit, way, 0, way), luminance, isFar };
  });
}

/** The light of the field where only some lights arrive. */
function arrivingLight(
  lights: readonly ReferenceLight[],
  dark: ReadonlySet<ReferenceLight>,
  tilesPerUnit: number,
): Field {
  const arriving = lights.filter((light) => !dark.has(light));
  const field = fieldLight(fieldLamps(arriving.length > 0 ? arriving : lights, tilesPerUnit));
  return arriving.length > 0 ? field : { axis: across(field.axis), bend: 0 };
}

/** The darkness of one fragment, by the functions of the processor. */
function darknessOf(
  given: EngravedSettings,
  { projection, isOrthographic }: (typeof cameras)[number],
  light: Field,
  place: Vec3,
  normal: Vec3,
  [tone, own]: readonly [number, number],
): number {
  const { tilesPerUnit, lineField, strokeRotation, crossFrom, crossAngle, handmade, medium } = given;
  const families = cutFamilies(firstField(lineField as CutField, light, strokeRotation));
  const point = combined(tilesPerUnit, place, -tilesPerUnit, centre);
  const reading = readCut(families, point, normal, handmade);
  const toView = mat4.multiply(mat4.create(), view, matrixWorld);
  const seen = vec3.transformMat4([0, 0, 0], place as unknown as vec3, toView) as unknown as Vec3;
  const back = mat4.invert(mat4.create(), toView)!;
  const row = (i: number): Vec3 => [tilesPerUnit * back[i], tilesPerUnit * back[4 + i], tilesPerUnit * back[8 + i]];
  const unitsPerPixel = (2 * (isOrthographic ? 1 : -seen[2])) / (projection[5] * SIZE);
  const map = screenMap(normal, [row(0), row(1), row(2)], { view: seen, isOrthographic, unitsPerPixel });
  const taken = (of: number, from: number) => (medium === 'pen' ? takenOf(of, from, KEPT_BY_PEN) : takenOf(of, from));
  const first = reading.has * taken(own, crossFrom);
  const others = leftOf(own, first);
  const second = medium === 'pen' ? taken(others, THIRD_FROM) : others;
  const { shareB, has } = reading;
  const other = otherShare(shareB, has);
  const shared = [
    ...sharedByTwo(second, shareB),
    ...[leftOf(others, second), leftOf(tone, own)].flatMap((of) => sharedByTwo(of, other)),
  ];
  let blank = 1;
  for (const [i, familyTone] of [first, ...shared].entries()) {
    if (i > 0 && familyTone <= 1e-4) continue;
    const lean = LEANS(crossAngle)[i];
    const family = {
      value: familyValue(families, reading, lean),
      gradient: familyGradient(families, reading, lean),
      rise: i === 0 ? riseOf(reading.slope) : 1,
      coarsest: Infinity,
    };
    blank *= 1 - familyDarkness(family, handTone(reading.pressure, familyTone), given, { map, point, normal });
  }
  return 1 - blank;
}

interface Case {
  camera: (typeof cameras)[number];
  lineField: CutField;
  lights: ReferenceLight[];
  /** Lights that do not arrive; lines turn in their shadows. */
  dark: ReferenceLight[];
  medium: 'ink' | 'pen' | 'woodcut';
}

const inSteepLight = (['light', 'towards'] as const).map((lineField) => ({
  ...{ lineField, lights: [steep], dark: [], medium: 'ink' as const },
}));
const inInk = (['light', 'towards', 'x', 'y', 'z', 'slant'] as const).flatMap((lineField) =>
  [[sun], [lamp], [sun, lamp]].map((lights) => ({ lineField, lights, dark: [], medium: 'ink' as const })),
);
const inMedia = (['pen', 'woodcut'] as const).flatMap((medium) =>
  (['light', 'slant'] as const).map((lineField) => ({ lineField, lights: [sun, lamp], dark: [], medium })),
);
const inShadow = [[sun], [lamp], [sun, lamp]].map((dark) => ({
  ...{ lineField: 'light' as const, lights: [sun, lamp], dark, medium: 'ink' as const },
}));
const cases: (Case & { name: string })[] = cameras.flatMap((camera) =>
  [...inInk, ...inSteepLight, ...inMedia, ...inShadow].map((one) => {
    const types = (lights: readonly ReferenceLight[]) => lights.map(({ type }) => type).join(' and ') || 'none';
    return { ...one, camera, name: `${one.medium}, ${types(one.lights)}, dark ${types(one.dark)}` };
  }),
);

test.each(cases)(
  'lines by $lineField, $name, $camera.name, are those of the reference',
  ({ camera, lineField, lights, dark, medium }) => {
    const isDark = new Set(dark);
    let inked = 0;
    for (let i = 0; i < 60; i++) {
      const shadowStrokes = dark.length > 0 ? 'reorient' : 'cross';
      const given: EngravedSettings = { ...settings, lineField, medium, shadowStrokes, sizedOnScreen: random() };
      given.crossFrom = between(0.1, 1);
      const own = between(0.02, 0.9);
      const tone = shadowStrokes === 'cross' ? own + (1 - own) * between(0, 0.9) : own;
      const reference = {
        toWorld: (p: Vec3) => p,
        tone: (_at: Vec3, _normal: Vec3, hasShadows = true) => (hasShadows ? tone : own),
        turnsAway: (light: ReferenceLight) => isDark.has(light),
      } as unknown as HatchingReference;
      const scene = { reference, settings: given, lights, matrixWorld: [...matrixWorld], size: SIZE };
      const engraved = new EngravedReference({
        ...scene,
        centre: [...centre],
        camera: { view: [...view], projection: [...camera.projection] },
      });
      const place: Vec3 = [between(-1, 1), between(-1, 1), between(-1, 1)];
      const normal = direction();
      const expected = engraved.darkness([...place], [...normal], [...normal]);
      const light = arrivingLight(lights, isDark, given.tilesPerUnit);
      const found = darknessOf(given, camera, light, place, normal, [tone, own]);
      expect(Math.abs(found - expected)).toBeLessThan(1e-6);
      if (expected > 0.05) inked++;
    }
    expect(inked).toBeGreaterThan(10);
  },
);
