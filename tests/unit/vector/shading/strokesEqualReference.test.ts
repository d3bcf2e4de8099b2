import { mat4, vec3 } from 'gl-matrix';
import { expect, test } from 'vitest';
import { combined, lengthOf, type Vec3 } from '../../../../src/look/vectors.js';
import { KEPT_BY_PEN, leftOf, THIRD_FROM, takenOf } from '../../../../src/vector/shading/crossedTones.js';
import { handTone } from '../../../../src/vector/shading/hand.js';
import { COARSEST_OCTAVES, formVarying, readForm } from '../../../../src/vector/shading/readForm.js';
import { screenMap } from '../../../../src/vector/shading/screenGradient.js';
import {
  EngravedReference,
  type EngravedSettings,
  type Quadratic,
  quadraticAt,
  quadraticGradient,
} from '../../../reference/engravedReference.js';
import type { HatchingReference, ReferenceLight } from '../../../reference/hatchingReference.js';
import { randomNumbers } from '../randomNumbers.js';
import { familyDarkness, type SeenFamily } from './familyDarkness.js';

/**
 * Compares the darkness of a fragment of lines that follow the form, in every medium, from the functions of the processor, with the
 * reference. It depends on values and gradients of the form, strokes of the pen, cuts of the gouge, their lengths, widths and hashes.
 */

const SIZE = 480;
const random = randomNumbers(17);
const between = (from: number, to: number): number => from + (to - from) * random();
const place3 = (reach: number): Vec3 => [between(-reach, reach), between(-reach, reach), between(-reach, reach)];

const cameras = [
  { name: 'perspective', projection: mat4.perspective(mat4.create(), 0.8, 1, 0.1, 50), isOrthographic: false },
  { name: 'orthographic', projection: mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50), isOrthographic: true },
];
const view = mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0]);
const matrixWorld = mat4.fromRotation(mat4.create(), 0.7, [1, 2, 0.5])!;
const sun: ReferenceLight = { type: 'directional', color: [3, 3, 3], position: [1, 2, 3], target: [0, 0, 0] };
const centre: Vec3 = [0.2, -0.1, 0.05];

/** The darkness of one fragment, by the functions of the processor. */
function fragmentOf(
  given: EngravedSettings,
  { projection, isOrthographic }: (typeof cameras)[number],
  place: Vec3,
  normal: Vec3,
  { tone, own, isDark }: { tone: number; own: number; isDark: boolean },
): number {
  const { tilesPerUnit, crossFrom, handmade, medium } = given;
  const point = combined(tilesPerUnit, place, -tilesPerUnit, centre);
  const toView = mat4.multiply(mat4.create(), view, matrixWorld);
  const seen = vec3.transformMat4([0, 0, 0], place as unknown as vec3, toView) as unknown as Vec3;
  const back = mat4.invert(mat4.create(), toView)!;
  const row = (i: number): Vec3 => [tilesPerUnit * back[i], tilesPerUnit * back[4 + i], tilesPerUnit * back[8 + i]];
  const unitsPerPixel = (2 * (isOrthographic ? 1 : -seen[2])) / (projection[5] * SIZE);
  const map = screenMap(normal, [row(0), row(1), row(2)], { view: seen, isOrthographic, unitsPerPixel });
  const read = given.form!.map((quadratic) => {
    const gradient = quadraticGradient(quadratic, [...point]) as Vec3;
    const varying = formVarying(gradient, quadraticAt(quadratic, [...point]), point);
    return { ...readForm(varying, point, handmade, medium === 'ink'), gradient };
  });
  // Where no light arrives the families change places.
  const isAcross = (given.lineField === 'acrossForm') !== isDark;
  const [first, crossing] = isAcross ? read.toReversed() : read;
  const [coarsest, coarsestCrossing] = isAcross ? COARSEST_OCTAVES.toReversed() : COARSEST_OCTAVES;
  const riseOfCrossing = lengthOf(crossing.gradient);
  const other: SeenFamily = {
    value: first.value - crossing.value,
    gradient: combined(1, first.gradient, -1, crossing.gradient),
    rise: riseOfCrossing,
    coarsest: Math.min(...COARSEST_OCTAVES),
  };
  const families: SeenFamily[] = [
    { ...first, rise: lengthOf(first.gradient), coarsest },
    { ...crossing, rise: riseOfCrossing, coarsest: coarsestCrossing },
    other,
    other,
  ];
  const taken = (of: number, from: number) => (medium === 'pen' ? takenOf(of, from, KEPT_BY_PEN) : takenOf(of, from));
  const firstTone = taken(own, crossFrom);
  const others = leftOf(own, firstTone);
  const second = medium === 'pen' ? taken(others, THIRD_FROM) : others;
  let blank = 1;
  for (const [i, familyTone] of [firstTone, second, leftOf(others, second), leftOf(tone, own)].entries()) {
    if (i > 0 && familyTone <= 1e-4) continue;
    blank *= 1 - familyDarkness(families[i], handTone(first.pressure, familyTone), given, { map, point, normal });
  }
  return 1 - blank;
}

const cases = cameras.flatMap((camera) =>
  (['form', 'acrossForm'] as const).flatMap((lineField) =>
    (['ink', 'pen', 'woodcut'] as const).flatMap((medium) =>
      (['tone', 'cross', 'reorient'] as const).map((shadows) => ({ camera, lineField, medium, shadows })),
    ),
  ),
);

test.each(cases)(
  'lines by $lineField in the medium $medium, shadows by $shadows, $camera.name, are those of the reference',
  (one) => {
    let [inked, blank] = [0, 0];
    for (let i = 0; i < 100; i++) {
      const quadratic = (): Quadratic => ({ linear: [...place3(1)], squares: [...place3(0.2)] });
      const given: EngravedSettings = {
        strokeRotation: 0,
        lineField: one.lineField,
        form: [quadratic(), quadratic()],
        lineSpacing: between(3, 9),
        strokeLength: between(30, 140),
        crossFrom: between(0.1, 1),
        crossAngle: 1,
        handmade: random(),
        sizedOnScreen: random(),
        tilesPerUnit: 3,
        medium: one.medium,
        shadowStrokes: one.shadows,
      };
      const own = between(0.02, 0.98);
      const tone = one.shadows === 'cross' ? own + (1 - own) * between(0, 0.9) : own;
      const isDark = one.shadows === 'reorient';
      const reference = {
        toWorld: (p: Vec3) => p,
        tone: (_at: Vec3, _normal: Vec3, hasShadows = true) => (hasShadows ? tone : own),
        turnsAway: () => isDark,
      } as unknown as HatchingReference;
      const engraved = new EngravedReference({
        ...{
          reference,
          settings: given,
          lights: [sun],
          matrixWorld: [...matrixWorld],
          size: SIZE,
          centre: [...centre],
        },
        camera: { view: [...view], projection: [...one.camera.projection] },
      });
      const place = place3(1);
      const [x, y, z] = vec3.normalize([0, 0, 0], [...place3(1)]);
      const expected = engraved.darkness([...place], [x, y, z], [x, y, z]);
      const found = fragmentOf(given, one.camera, place, [x, y, z], { tone, own, isDark });
      expect(Math.abs(found - expected)).toBeLessThan(1e-6);
      if (expected > 0.05) inked++;
      if (expected < 0.95) blank++;
    }
    expect(inked).toBeGreaterThan(25);
    expect(blank).toBeGreaterThan(25);
  },
);
