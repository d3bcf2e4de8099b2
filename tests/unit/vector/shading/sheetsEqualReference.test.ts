import { describe, expect, test } from 'vitest';
import { normalize } from '../../../../src/look/vectors.js';
import { type BackgroundField, lineAt, lineWidth, placeOnLine } from '../../../../src/vector/shading/background.js';
import { across } from '../../../../src/vector/shading/fieldAxis.js';
import { awayField, groundTone, lineLeft } from '../../../../src/vector/shading/groundShadow.js';
import { type ToneLook, toneFromRadiance } from '../../../../src/vector/shading/tone.js';
import { type ReferenceBackground, ruledAt } from '../../../reference/backgroundReference.js';
import { axisAway, leftOfLine, shadowedTone } from '../../../reference/groundReference.js';
import type { Vec3 } from '../../../reference/referenceAdjacency.js';
import { randomNumbers } from '../randomNumbers.js';

const random = randomNumbers(43);
const between = (from: number, to: number): number => from + (to - from) * random();
const same = (found: number, expected: number) => expect(Math.abs(found - expected)).toBeLessThan(1e-6);

test('the field behind a subject is that of the reference', () => {
  let [blank, full] = [0, 0];
  for (let i = 0; i < 600; i++) {
    const angle = between(-Math.PI, Math.PI);
    const shared = {
      ...{ tone: random(), contrast: random(), spacing: between(3, 12), extent: between(1, 3) },
      sheet: [between(300, 900), between(300, 900)] as const,
      centre: [between(100, 500), between(100, 500)] as const,
      half: [between(40, 200), between(40, 200)] as const,
      lit: [between(-1, 1), between(-1, 1)] as const,
    };
    const field: BackgroundField = { ...shared, direction: [Math.cos(angle), Math.sin(angle)] };
    const reference: ReferenceBackground = { ...shared, angle };
    const place = [between(0, shared.sheet[0]), between(0, shared.sheet[1])] as const;
    const line = lineAt(field, place);
    const expected = ruledAt(reference, place);
    expect(line).toBe(expected.line);
    const width = lineWidth(field, line, place);
    same(width, expected.width);
    if (width === 0) blank++;
    if (width > 0.05 * shared.spacing) full++;
    const [x, y] = placeOnLine(field, line, between(-50, 50));
    expect(lineAt(field, [x, y])).toBe(line);
  }
  expect(blank).toBeGreaterThan(100);
  expect(full).toBeGreaterThan(100);
});

describe('shadows on a ground', () => {
  const look: ToneLook = {
    ...{ curve: 'perceptual', steps: 0, exposure: [1, 0], highlightRamp: [0, 1], toneEnds: [0.1, 0.9] },
    ...{ occlusion: 0, hollowTone: 0, darkness: 0 },
  };

  test('have the tone of the reference, and none with light ink', () => {
    let printed = 0;
    for (let i = 0; i < 200; i++) {
      // Every third place has so little light that the added millionth matters.
      const scale = i % 3 === 0 ? 1e-6 : 1;
      const [lit, taken, left, tone] = [scale * random(), scale * random(), random(), random()];
      const ground = { tone, fade: 1, softness: 0 };
      const expected = shadowedTone(lit, taken, (share) => toneFromRadiance(share, look), 0.1, tone, left);
      same(groundTone(lit, taken, left, look, ground), expected);
      if (expected > 0.05) printed++;
      expect(groundTone(lit, taken, left, { ...look, toneEnds: [0.9, 0.1] }, ground)).toBe(0);
    }
    expect(groundTone(0, 0, 1, look, { tone: 1, fade: 1, softness: 0 })).toBe(0);
    expect(printed).toBeGreaterThan(50);
  });

  test('end line by line as those of the reference do, and have the tone in the mean', () => {
    for (let i = 0; i < 200; i++) {
      const [line, left] = [(i - 100) / 8, between(0.01, 1)];
      same(lineLeft(line, left), leftOfLine(line, left));
    }
    for (const left of [1e-3, 5e-4, 1e-4]) same(lineLeft(0, left), leftOfLine(0, left));
    expect(lineLeft(3, 1)).toBe(1);
    const lines = 4096;
    for (const left of [0.01, 0.05, 0.2, 0.39, 0.5, 0.8, 0.99]) {
      let sum = 0;
      for (let line = 0; line < lines; line++) sum += lineLeft(line, left);
      expect(Math.abs(sum / lines - 1), `left ${left}`).toBeLessThan(0.015);
    }
  });

  test('run away from the light as those of the reference do', () => {
    let overhead = 0;
    for (let i = 0; i < 200; i++) {
      const vector = (): Vec3 => [between(-1, 1), between(-1, 1), between(-1, 1)];
      const normal = vector();
      // Overhead, nearly overhead, and from a random direction.
      const sides = [[0, 1, 0], [...normalize([0.00103, 1, 0])], [...normalize(vector())]] as const;
      const light: Vec3 = [...sides[i % 3]];
      const { axis, bend } = awayField(light, normal);
      const expected = axisAway(light, normal) ?? across(light);
      if (axisAway(light, normal) === null) overhead++;
      expect(bend).toBe(0);
      for (let k = 0; k < 3; k++) same(axis[k], expected[k]);
    }
    expect(overhead).toBeGreaterThan(5);
  });
});
