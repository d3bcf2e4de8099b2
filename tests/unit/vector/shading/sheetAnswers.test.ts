import { expect, test } from 'vitest';
import { normalize, type Vec3 } from '../../../../src/look/vectors.js';
import { lineAt, lineWidth, placeOnLine } from '../../../../src/vector/shading/background.js';
import { awayField, groundTone, lineLeft } from '../../../../src/vector/shading/groundShadow.js';
import { meanLightAt } from '../../../../src/vector/shading/radiance.js';
import type { ToneLook } from '../../../../src/vector/shading/tone.js';
import { answers } from './answers.js';

/** Backgrounds, grounds and the light of outlines. */

type Pair = readonly [number, number];

const fieldOf = (
  [tone, contrast, spacing, angle, extent]: readonly [number, number, number, number, number],
  sheet: Pair,
  centre: Pair,
  half: Pair,
  lit: Pair,
) => ({
  tone,
  contrast,
  spacing,
  direction: [Math.cos(angle), Math.sin(angle)] as const,
  extent,
  sheet,
  centre,
  half,
  lit,
});

answers(
  'background: line and width',
  (
    look: readonly [tone: number, contrast: number, spacing: number, angle: number, extent: number],
    sheet: Pair,
    centre: Pair,
    half: Pair,
    lit: Pair,
    place: Pair,
  ) => {
    const field = fieldOf(look, sheet, centre, half, lit);
    const line = lineAt(field, place);
    return [line, lineWidth(field, line, place)];
  },
  `
  [0.2, 0.57, 11, -0.26, 2.9], [390, 355], [476, 438], [103, 177], [-0.32, -0.91], [214, 239] → [-24, 0.643880423]
  [0.77, 0.36, 8, 0.58, 1.2], [538, 425], [303, 278], [135, 180], [0.26, -0.88], [354, 264] → [-5, 6.5296]
  [0.06, 0.64, 7.6, -1.1, 2.1], [365, 868], [326, 292], [65, 73], [0.75, -0.25], [270, 358] → [-3, 0.201218075]
  [0.74, 0.93, 7.6, -1.09, 2.9], [525, 496], [163, 407], [105, 176], [-0.59, 0.5], [220, 441] → [8, 1.34251765]
  [0.11, 0.36, 8, -2.14, 2.6], [607, 833], [251, 114], [148, 147], [0.64, 0.94], [551, 28] → [37, 0.0108788717]
  [0.22, 0.35, 9.9, 2.59, 3], [493, 437], [240, 459], [132, 118], [0.49, 0.51], [478, 404] → [-8, 0.679468363]
  [0.77, 0.03, 8.2, -0.68, 2.9], [509, 420], [104, 264], [155, 112], [0.58, 0.6], [159, 206] → [-2, 6.29412836]
  [0.17, 0.87, 4.2, 1.56, 2.6], [369, 407], [349, 229], [159, 193], [0.81, -0.93], [321, 297] → [6, 0.144348092]
  [0.2, 0.15, 10.1, 2.35, 1.3], [323, 511], [233, 356], [172, 78], [0.71, 0.62], [1, 469] → [8, 0]
  # By hand: in the middle of a subject that no light comes to lines have their whole tone, 0.25 · 8; beyond the extent none.
  [0.25, 0.5, 8, 0, 2], [900, 900], [450, 450], [100, 100], [0, 0], [450, 454] → [0, 2]
  [0.25, 0.5, 8, 0, 2], [900, 900], [450, 450], [100, 100], [0, 0], [850, 454] → [0, 0]
`,
);

// By hand: the middle of line n lies (n + ½) spacings to the left of the direction.
answers(
  'placeOnLine',
  (angle: number, line: number, along: number) =>
    placeOnLine(fieldOf([0.3, 0.5, 10, angle, 2], [900, 900], [450, 400], [100, 100], [0, 0]), line, along),
  `
  0, 0, 0 → [450, 405]
  0, -2, 30 → [480, 385]
  1.57079633, 1, 20 → [435, 420]
`,
);

const look: ToneLook = {
  ...{ curve: null, steps: 0, exposure: [1, 0], highlightRamp: [0, 1], toneEnds: [0.1, 0.9] },
  ...{ occlusion: 0, hollowStrength: 0, openOcclusion: 0, darkness: 0 },
};

answers(
  'groundTone',
  (arriving: number, shadowed: number, left: number, tone: number) =>
    groundTone(arriving, shadowed, left, look, { tone, fade: 1, softness: 0 }),
  `
  0.14, 0.52, 0.82, 0.58 → 0.364626042
  0.19, 0.98, 0.28, 0.36 → 0.0827937668
  0.68, 0.14, 0.11, 0.47 → 0.00453950035
  0.77, 0.01, 0.96, 0.19 → 0
  1.4e-7, 6e-8, 0.74, 0.8 → 0
  # By hand: half of the light is left, 1 − 0.5 − 0.5 · 0.1, less 0.55 of half a millionth; without light there is no shadow.
  0.5, 0.5, 1, 1 → 0.44999945
  0, 0, 1, 1 → 0
`,
);

test('light ink draws no shadow on a ground', () => {
  const light: ToneLook = { ...look, toneEnds: [0.9, 0.1] };
  expect(groundTone(0.2, 0.6, 1, light, { tone: 1, fade: 1, softness: 0 })).toBe(0);
});

answers(
  'lineLeft',
  lineLeft,
  `
  # By hand: the hash 0.6015625 is half a turn on 0.1015625; a ninth of 0.4 is gone: (1 − 0.04444 · 0.1015625) / (1 − 0.02222).
  1, 0.9 → 1.0181108
  2, 0.5 → 0.897460938
  3, 0.5 → 1.09619141
  -7, 0.3 → 1.49389648
  0.5, 0.1 → 1.59375
  0.375, 0.05 → 0
  40.25, 0.02 → 3.86450195
  0, 0.0001 → 0
  3, 1 → 1
`,
);

test('lines that end one by one have the tone in the mean', () => {
  const lines = 4096;
  for (const left of [0.01, 0.05, 0.2, 0.39, 0.5, 0.8, 0.99]) {
    let sum = 0;
    for (let line = 0; line < lines; line++) sum += lineLeft(line, left);
    expect(Math.abs(sum / lines - 1), `left ${left}`).toBeLessThan(0.015);
  }
});

answers(
  'awayField',
  (light: Vec3, normal: Vec3) => awayField(normalize(light), normal).axis,
  `
  [0.8, -0.06, -0.44], [-0.57, -0.1, 0.68] → [-0.0747899482, -0.99719931, 0]
  [0.79, 0.33, -0.21], [0.31, 0.49, -0.28] → [0.256901156, 0, 0.966437683]
  [0.99, -0.38, 0.59], [-0.51, 0.87, 0.79] → [-0.511941426, 0, 0.859020359]
  [0.13, -0.92, 0.83], [0.41, -0.2, -0.16] → [0, 0.669856024, 0.742491015]
  # By hand: overhead lines run along x, as across any upright axis; a ground of y, lit along x, has lines across z.
  [0, 1, 0], [0, 1, 0] → [1, 0, 0]
  [1, 0, 0], [0.2, 1, 0] → [0, 0, 1]
`,
);

test('the mean light at a place is the sum of lamps by what arrives of them, and of skies by their difference', () => {
  const plain = { distance: 0, cone: null, castsShadow: false };
  const sun = { ...plain, luminance: 2, at: [0, 1, 0] as const, isFar: true, decay: 0 };
  // By hand: at a distance of 2, with a decay of 2, a quarter of 8 arrives.
  const lamp = { ...plain, luminance: 8, at: [3, 0, 0] as const, isFar: false, decay: 2 };
  const sky = { up: [0, 0, 1] as const, mean: 1, difference: 0.5 };
  expect(meanLightAt([1, 0, 0], [sun, lamp], [sky])).toEqual([2, 2, 0.5]);
});
