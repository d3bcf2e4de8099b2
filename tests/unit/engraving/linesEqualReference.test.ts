import { mat4, vec3 } from 'gl-matrix';
import { expect, test } from 'vitest';
import { leftOf, sharedByTwo, takenOf } from '../../../src/engraving/crossedTones.js';
import { type CutField, firstField } from '../../../src/engraving/fieldAxis.js';
import { handTone, handWidth } from '../../../src/engraving/hand.js';
import { fieldLight } from '../../../src/engraving/lightField.js';
import { cutFamilies, familyGradient, familyValue, type Lean, readCut } from '../../../src/engraving/readCut.js';
import { octaveOf, riseOf, roomOf } from '../../../src/engraving/ruledLines.js';
import { changePerPixel, screenMap } from '../../../src/engraving/screenGradient.js';
import { combined, type Vec3 } from '../../../src/engraving/vectors.js';
import { EngravedReference, type EngravedSettings } from '../../reference/engravedReference.js';
import type { HatchingReference, ReferenceLight } from '../../reference/hatchingReference.js';
import { randomNumbers } from '../vector/randomNumbers.js';

/**
 * The darkness of a fragment, put together from the functions of the processor and compared with the reference: values, gradients, tones of
 * families, octaves, rooms, widths, the hand and the light of the field must all be right for it.
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
const centre: Vec3 = [0.2, -0.1, 0.05];

const sun: ReferenceLight = { type: 'directional', color: [3, 3, 3], position: [1, 2, 3], target: [0, 0, 0] };
const lamp: ReferenceLight = { type: 'point', color: [4, 2, 1], position: [2, 1.5, 1], decay: 2 };

const cameras = [
  { name: 'perspective', projection: mat4.perspective(mat4.create(), 0.8, 1, 0.1, 50), isOrthographic: false },
  { name: 'orthographic', projection: mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50), isOrthographic: true },
];
const view = mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0]);
const matrixWorld = mat4.fromRotation(mat4.create(), 0.7, [1, 2, 0.5])!;

/** As `lineCoverage.glsl`. */
const coverage = (away: number, half: number): number =>
  Math.min(Math.max(Math.max(half, 0.5) + 0.5 - away, 0), 1) * Math.min(2 * half, 1);

const LEANS = (angle: number): Lean[] => {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return [
    { cosine: 1, sine: 0, side: null },
    { cosine, sine, side: 'B' },
    { cosine, sine, side: 'C' },
    { cosine, sine: -sine, side: 'B' },
    { cosine, sine: -sine, side: 'C' },
  ];
};

const rankOf = (line: number): number => {
  let rank = -40;
  while (rank < 60 && Number.isInteger(line / 2 ** (rank + 1))) rank++;
  return rank;
};

function fieldLamps(lights: readonly ReferenceLight[], tilesPerUnit: number) {
  const toObject = mat4.invert(mat4.create(), matrixWorld)!;
  return lights.map(({ type, position, color }) => {
    // Less what a light that is switched off counts for, which the reference does not know.
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

/** The darkness of one fragment by the functions of the processor. */
function darknessOf(
  given: EngravedSettings,
  { projection, isOrthographic }: (typeof cameras)[number],
  lights: readonly ReferenceLight[],
  place: Vec3,
  normal: Vec3,
  [tone, own]: readonly [number, number],
): number {
  const { tilesPerUnit, lineField, strokeRotation, crossFrom, crossAngle, handmade, lineSpacing, sizedOnScreen } =
    given;
  const families = cutFamilies(
    firstField(lineField as CutField, fieldLight(fieldLamps(lights, tilesPerUnit)), strokeRotation),
  );
  const reading = readCut(families, combined(tilesPerUnit, place, -tilesPerUnit, centre), normal, handmade);
  const toView = mat4.multiply(mat4.create(), view, matrixWorld);
  const seen = vec3.transformMat4([0, 0, 0], place as unknown as vec3, toView) as unknown as Vec3;
  const back = mat4.invert(mat4.create(), toView)!;
  const row = (i: number): Vec3 => [tilesPerUnit * back[i], tilesPerUnit * back[4 + i], tilesPerUnit * back[8 + i]];
  const unitsPerPixel = (2 * (isOrthographic ? 1 : -seen[2])) / (projection[5] * SIZE);
  const map = screenMap(normal, [row(0), row(1), row(2)], { view: seen, isOrthographic, unitsPerPixel });
  const first = reading.has * takenOf(own, crossFrom);
  const [b, c] = sharedByTwo(leftOf(own, first), reading.shareB);
  const [d, e] = sharedByTwo(leftOf(tone, own), reading.shareB);
  let blank = 1;
  for (const [i, familyTone] of [first, b, c, d, e].entries()) {
    if (i > 0 && familyTone <= 1e-4) continue;
    const lean = LEANS(crossAngle)[i];
    const value = familyValue(families, reading, lean);
    const perPixel = changePerPixel(familyGradient(families, reading, lean), map);
    const rise = i === 0 ? riseOf(reading.slope) : 1;
    const octave = octaveOf({ lineSpacing, finestSpacing: 3, sizedOnScreen }, rise, perPixel, 100);
    const pressed = handTone(reading.pressure, familyTone);
    const step = 2 ** (Math.ceil(octave) - 1);
    let covered = 0;
    for (let k = Math.floor(value / step) - 3; k <= value / step + 4; k++) {
      const half = (0.5 * roomOf(rankOf(k * step), octave) * pressed * handWidth(k * step, handmade)) / perPixel;
      covered += coverage(Math.abs(value - k * step) / perPixel, half);
    }
    blank *= 1 - Math.min(covered, 1);
  }
  return 1 - blank;
}

const cases = cameras.flatMap((camera) =>
  (['light', 'towards', 'x', 'y', 'z', 'slant'] as const).flatMap((lineField) =>
    [[sun], [lamp], [sun, lamp]].map((lights) => ({ camera, lineField, lights, name: lights.map(({ type }) => type) })),
  ),
);

test.each(cases)(
  'lines by $lineField under $name, $camera.name, are those of the reference',
  ({ camera, lineField, lights }) => {
    let inked = 0;
    for (let i = 0; i < 60; i++) {
      const given = { ...settings, lineField, crossFrom: between(0.1, 1), sizedOnScreen: random() };
      const own = between(0, 0.9);
      const tone = own + (1 - own) * between(0, 0.9);
      const reference = {
        toWorld: (p: Vec3) => p,
        tone: (_at: Vec3, _normal: Vec3, hasShadows = true) => (hasShadows ? tone : own),
        turnsAway: () => false,
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
      const found = darknessOf(given, camera, lights, place, normal, [tone, own]);
      expect(Math.abs(found - expected)).toBeLessThan(1e-6);
      if (expected > 0.05) inked++;
    }
    expect(inked).toBeGreaterThan(10);
  },
);
