import { mat4, vec3 } from 'gl-matrix';
import { expect, test } from 'vitest';
import { cutFor, cutWidth, rowOctaves } from '../../../src/engraving/carving.js';
import { KEPT_BY_PEN, leftOf, THIRD_FROM, takenOf } from '../../../src/engraving/crossedTones.js';
import { handTone } from '../../../src/engraving/hand.js';
import { penFor, strokeAt } from '../../../src/engraving/penStrokes.js';
import { COARSEST_OCTAVES, formVarying, readForm } from '../../../src/engraving/readForm.js';
import { octaveOf, powerOf2, roomOf } from '../../../src/engraving/ruledLines.js';
import { changePerPixel, screenMap } from '../../../src/engraving/screenGradient.js';
import { alongLines } from '../../../src/engraving/strokeLengths.js';
import { combined, lengthOf, type Vec3 } from '../../../src/engraving/vectors.js';
import {
  EngravedReference,
  type EngravedSettings,
  type Quadratic,
  quadraticAt,
  quadraticGradient,
} from '../../reference/engravedReference.js';
import type { HatchingReference } from '../../reference/hatchingReference.js';
import { randomNumbers } from '../vector/randomNumbers.js';

/**
 * The darkness of a fragment of lines that follow the form, in every medium, put together from the functions of the processor and compared with
 * the reference: values and gradients of the form, strokes of the pen, cuts of the gouge, their lengths, widths and lots must all be right for it.
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
const centre: Vec3 = [0.2, -0.1, 0.05];

/** As `lineCoverage.glsl`. */
const coverage = (away: number, half: number): number =>
  Math.min(Math.max(Math.max(half, 0.5) + 0.5 - away, 0), 1) * Math.min(2 * half, 1);

const rankOf = (line: number): number => {
  let rank = -40;
  while (rank < 60 && Number.isInteger(line / 2 ** (rank + 1))) rank++;
  return rank;
};

interface FormFamily {
  value: number;
  gradient: Vec3;
  rise: number;
  coarsest: number;
}

/** The darkness of one family by the functions of the processor. */
function darknessOf(
  { value, gradient, rise, coarsest }: FormFamily,
  tone: number,
  given: EngravedSettings,
  { map, point, normal }: { map: ReturnType<typeof screenMap>; point: Vec3; normal: Vec3 },
): number {
  const { lineSpacing, sizedOnScreen, strokeLength, handmade, medium } = given;
  const perPixel = changePerPixel(gradient, map);
  const plain = octaveOf({ lineSpacing, finestSpacing: 3, sizedOnScreen }, rise, perPixel, 100);
  const octave = Math.min(plain + (medium === 'woodcut' ? rowOctaves(tone) : 0), coarsest);
  const along = alongLines(point, normal, gradient, map, { strokeLength, sizedOnScreen });
  const repeat = powerOf2(coarsest);
  const step = 2 ** (Math.ceil(octave) - 1);
  let covered = 0;
  for (let k = Math.floor(value / step) - 3; k <= value / step + 4; k++) {
    const line = k * step;
    const room = roomOf(rankOf(line), octave);
    let [width, away] = [room * tone, value - line];
    if (medium === 'woodcut') width = room * cutWidth(cutFor(tone, along, repeat), line);
    if (medium === 'pen') {
      const spacing = powerOf2(octave);
      const stroke = strokeAt(penFor(tone, along, handmade, repeat), room / spacing, line);
      width = spacing * stroke.width;
      away -= spacing * stroke.astray;
    }
    covered += coverage(Math.abs(away) / perPixel, (0.5 * width) / perPixel);
  }
  return medium === 'woodcut' ? 1 - Math.min(covered, 1) : Math.min(covered, 1);
}

/** The darkness of one fragment by the functions of the processor. */
function fragmentOf(
  given: EngravedSettings,
  { projection, isOrthographic }: (typeof cameras)[number],
  place: Vec3,
  normal: Vec3,
  tone: number,
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
    return { ...readForm(varying, point, handmade), gradient };
  });
  const isAcross = given.lineField === 'acrossForm';
  const [first, crossing] = isAcross ? read.toReversed() : read;
  const [coarsest, coarsestCrossing] = isAcross ? COARSEST_OCTAVES.toReversed() : COARSEST_OCTAVES;
  const riseOfCrossing = lengthOf(crossing.gradient);
  const families: FormFamily[] = [
    { ...first, rise: lengthOf(first.gradient), coarsest },
    { ...crossing, rise: riseOfCrossing, coarsest: coarsestCrossing },
    {
      value: first.value - crossing.value,
      gradient: combined(1, first.gradient, -1, crossing.gradient),
      rise: riseOfCrossing,
      coarsest: Math.min(...COARSEST_OCTAVES),
    },
  ];
  const taken = (of: number, from: number) => (medium === 'pen' ? takenOf(of, from, KEPT_BY_PEN) : takenOf(of, from));
  const firstTone = taken(tone, crossFrom);
  const others = leftOf(tone, firstTone);
  const second = medium === 'pen' ? taken(others, THIRD_FROM) : others;
  let blank = 1;
  for (const [i, familyTone] of [firstTone, second, leftOf(others, second)].entries()) {
    if (i > 0 && familyTone <= 1e-4) continue;
    blank *= 1 - darknessOf(families[i], handTone(first.pressure, familyTone), given, { map, point, normal });
  }
  return 1 - blank;
}

const cases = cameras.flatMap((camera) =>
  (['form', 'acrossForm'] as const).flatMap((lineField) =>
    (['ink', 'pen', 'woodcut'] as const).map((medium) => ({ camera, lineField, medium })),
  ),
);

test.each(cases)('lines by $lineField in the medium $medium, $camera.name, are those of the reference', (one) => {
  let [inked, blank] = [0, 0];
  for (let i = 0; i < 150; i++) {
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
      shadowStrokes: 'tone',
    };
    const tone = between(0.02, 0.98);
    const reference = {
      toWorld: (p: Vec3) => p,
      tone: () => tone,
      turnsAway: () => false,
    } as unknown as HatchingReference;
    const engraved = new EngravedReference({
      ...{ reference, settings: given, lights: [], matrixWorld: [...matrixWorld], size: SIZE, centre: [...centre] },
      camera: { view: [...view], projection: [...one.camera.projection] },
    });
    const place = place3(1);
    const [x, y, z] = vec3.normalize([0, 0, 0], [...place3(1)]);
    const expected = engraved.darkness([...place], [x, y, z], [x, y, z]);
    const found = fragmentOf(given, one.camera, place, [x, y, z], tone);
    expect(Math.abs(found - expected)).toBeLessThan(1e-6);
    if (expected > 0.05) inked++;
    if (expected < 0.95) blank++;
  }
  expect(inked).toBeGreaterThan(40);
  expect(blank).toBeGreaterThan(40);
});
