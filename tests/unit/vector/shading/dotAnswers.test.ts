import { mat4, vec3 } from 'gl-matrix';
import { expect, test } from 'vitest';
import { normalize, type Vec3 } from '../../../../src/look/vectors.js';
import {
  coverOf,
  directionOfNeedles,
  dotArea,
  dotOctave,
  grownBy,
  inLayer,
  layerTones,
  ownCover,
  planesNear,
  setShift,
} from '../../../../src/vector/shading/stipple.js';
import { stippleDarkness } from '../../../gpu/stippleDarkness.js';
import type { HatchingReference } from '../../../reference/hatchingReference.js';
import { answers } from './answers.js';

answers(
  'coverOf',
  coverOf,
  `
  0.1 → 0.1
  0.5 → 0.5
  0.7 → 0.7
  0.8 → 0.808
  0.9 → 0.932
  0.95 → 1
`,
);

// By hand: 1 − (1 − cover)^share.
answers(
  'ownCover',
  ownCover,
  `
  0.75, 0.5 → 0.5
  0.75, 1 → 0.75
  0.75, 0 → 0
`,
);

answers(
  'grownBy',
  grownBy,
  `
  0.2, 0 → 1
  0.2, 0.1 → 0.385714286
  0.5, 0.4 → 0.685714286
  0.6, 0.6 → 0.6
  0.9, 1 → 0.714285714
`,
);

answers(
  'dotArea',
  dotArea,
  `
  0.0001, 0.3, 5.2 → 2.31827446
  0.0004, 0.7, 3.8 → 7.57776653
  0.001, 0.95, 4.5 → 2.33338206
  0.0002, 0.05, 4.01 → 0.975919037
`,
);

answers(
  'dotOctave',
  (pixelArea: number, own: number, dotPixels: number, tilesPerObjectUnit: number, screenSpaceShare: number) =>
    dotOctave(pixelArea, own, { dotPixels, tilesPerObjectUnit, screenSpaceShare }),
  `
  0.0000735, 0.29, 5.94, 0.36, 0.11 → 3.51586274
  0.0000336, 0.45, 4.38, 0.44, 0.58 → 4.81359117
  0.0000687, 0.74, 1.16, 0.13, 0.06 → 3.68727305
  0.0000639, 0.56, 3.84, 0.88, 0.8 → 4.81376171
  # By hand: on the object 64 dots per tile, in octaves 6, at half tone.
  0.000001, 0.5, 1, 1, 0 → 6
  0.000001, 0.5, 1, 4, 0 → 8
`,
);

answers(
  'planesNear: axes and shares, the nearest first',
  (direction: Vec3) => {
    const planes = planesNear(normalize(direction)).toSorted((a, b) => b.share - a.share);
    return planes.map(({ axis, share }) => [...axis, share]);
  },
  `
  [1, 2, 3] → [[0, 0.707106781, 0.707106781, 0.883214963], [0.577350269, 0.577350269, 0.577350269, 0.116785037]]
  [0.1, 1, 0.05] → [[0, 1, 0, 1]]
  [-3, 1, 2.9] → [[-0.707106781, 0, 0.707106781, 1]]
  [1, 1, -1] → [[0.577350269, 0.577350269, -0.577350269, 1]]
`,
);

// By hand: half way from the normal to the viewer; at grazing angles the normal counts a half.
answers(
  'directionOfNeedles',
  (front: Vec3, toViewer: Vec3) => directionOfNeedles(front, toViewer),
  `
  [0, 0, 1], [0, 0, 1] → [0, 0, 1]
  [1, 0, 0], [0, 0, 1] → [0.447213595, 0, 0.894427191]
`,
);

// By hand: the products of the axis with 3.17, 7.71, 5.39, and with these moved up by one, over the tiles per unit.
answers(
  'setShift',
  setShift,
  `
  [0, 1, 0], 1 → [7.71, 5.39]
  [0, 0, 1], 2 → [2.695, 1.585]
`,
);

// By hand: the first layer takes 0.4 of the excess over where the second begins.
answers(
  'layerTones',
  (tone: number, crossFrom: number | null) => layerTones(tone, { shift: 1, crossFrom }),
  `
  0.7, null → [0.7]
  0.4, 0.5 → [0.4, 0, 0]
  0.7, 0.5 → [0.58, 0.285714286, 0]
`,
);

test('a layer is moved by its number of shifts along one vector', () => {
  const moved = (layer: number) => inLayer([0, 0, 0], layer, { shift: 0.5, crossFrom: 0.5 });
  expect(moved(0)).toEqual([0, 0, 0]);
  for (const k of [0, 1, 2]) expect(moved(2)[k]).toBeCloseTo(2 * moved(1)[k], 12);
});

const SIZE = 480;
const view = mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0]);
const matrixWorld = [...mat4.fromRotation(mat4.create(), 0.7, [1, 2, 0.5])!];

answers(
  'darkness of fragments',
  (
    isOrthographic: boolean,
    place: Vec3,
    normal: Vec3,
    tone: number,
    [tilesPerObjectUnit, strokeWidth, screenSpaceShare]: readonly [number, number, number],
  ) => {
    const reference = {
      toWorld: (p: Vec3) => vec3.transformMat4([0, 0, 0], [...p], matrixWorld as unknown as mat4),
      tone: () => tone,
    } as unknown as HatchingReference;
    const projection = isOrthographic
      ? mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50)
      : mat4.perspective(mat4.create(), 0.8, 1, 0.1, 50);
    const darknessOf = stippleDarkness(
      {
        ...{ matrixWorld, camera: { view: [...view], projection: [...projection] }, width: SIZE, height: SIZE },
        ...{ material: { tilesPerObjectUnit }, dots: { strokeWidth, edgePixels: 1 }, screenSpaceShare },
      },
      reference,
    );
    return darknessOf([...place], [...normal], [0, 1, 0], [...normal], false);
  },
  `
  true, [0.61, 0.85, 0.3], [-0.85, 0.85, 0.07], 0.85, [0.45, 1.86, 0.83] → 0.700150426
  false, [0.41, -0.6, 0.97], [-0.05, -0.03, 0.58], 0.58, [0.93, 4.47, 0.86] → 0.646167588
  true, [0.48, -0.4, -0.82], [-0.9, 0.96, -0.16], 0.73, [0.73, 5.02, 0.18] → 0.26918277
  false, [0.87, 0.12, -0.61], [0.5, 0.43, 0.19], 0.28, [0.89, 2.98, 0.98] → 0.0772335042
  false, [0.64, -0.76, -0.53], [-0.44, 0.16, 0.81], 0.48, [0.68, 1.76, 0.18] → 0.408679711
  false, [-0.1, 0.1, 0.5], [-0.22, 0.37, -0.12], 0.45, [0.95, 2.05, 0.04] → 0.334355857
  true, [-0.92, 0.94, 0.54], [0.84, -0.39, 0.81], 0.7, [0.74, 4.29, 0.91] → 0.0593863872
  false, [-0.31, -0.82, -0.95], [-0.88, -0.26, 0.75], 0.64, [0.26, 5.63, 0.59] → 0.431519728
  true, [-0.97, 0.26, 0.62], [-0.01, -0.56, 0.72], 0.36, [0.51, 4.92, 0.83] → 0.874136862
  true, [0.1, -0.03, -0.46], [0.51, 0.16, 0.91], 0.38, [0.77, 2.55, 0.54] → 0.11185061
  true, [0.52, -0.38, -0.57], [-0.23, 0.94, -0.17], 0.46, [0.41, 4.07, 0.93] → 0.319293521
  false, [0.08, 0.88, 0.39], [-0.48, 0.78, 0.66], 0.29, [0.85, 2.26, 0.53] → 0.483356969
  true, [-0.88, -0.47, -0.01], [0.81, 0.14, 0.7], 0.47, [0.27, 1.59, 0.53] → 0.337802058
  false, [0.11, -0.69, 0.15], [0.47, 0.55, -0.35], 0.81, [0.22, 3.78, 0.24] → 0.809402456
`,
  5,
);
