import { hiddenWeight } from '../../../../src/look/hiddenOutlines.js';
import { normalize, type Vec3 } from '../../../../src/look/vectors.js';
import {
  contourAlong,
  depthAcross,
  liftOf,
  looksAway,
  paperness,
  shadeWeight,
  suggestiveShare,
  taperAt,
  toleranceOf,
  wobbleAt,
} from '../../../../src/vector/shading/outlines.js';
import { answers } from './answers.js';

type Corners = readonly [Vec3, Vec3, Vec3];

answers(
  'taperAt',
  taperAt,
  `
  # By hand: 3 · 0.3² − 2 · 0.3³.
  0.3, 1 → 0.216
  -0.2, 0.5 → 0
  0.7, 0.9 → 0.873799726
  -0.1, 0 → 0
  0.1, 0 → 1
  2, 1 → 1
`,
);

answers(
  'contourAlong',
  contourAlong,
  `
  # By hand: the right side turns at 0.13 / 0.31, and both face away before.
  [-1, 0.77], [-0.05, -0.36] → [0.564971751, 1]
  [0.79, -0.85], [0.14, 0.85] → [0.481707317, 1]
  [-0.68, 0.17], [0, -0.4] → [0.8, 1]
  [-0.95, 0.47], [0.37, -0.59] → [0, 1]
  [-0.36, -0.63], [-0.6, -0.08] → null
  [0.91, -0.95], [-0.26, -0.64] → [0, 0.489247312]
  [-0.08, -0.96], [0.38, -0.37] → [0, 0.506666667]
  [0.13, 0.06], [0.17, -0.67] → [0.202380952, 1]
  [0.95, -0.99], [0.32, 0.55] → [0.489690722, 1]
`,
);

answers(
  'shadeWeight: before a surface, and before paper',
  (
    normal: Vec3,
    light: Vec3,
    sight: Vec3,
    contour: number,
    shadeWeights: readonly [number, number],
    lostEdges: number,
  ) => {
    const given = { light: normalize(light), sight: normalize(sight), shadeWeights, lostEdges };
    const [weight, left] = shadeWeight(normalize(normal), contour, given);
    return [weight, weight * left];
  },
  `
  [0.23, -0.8, 0.2], [0.05, -0.69, 0.46], [0.83, -0.5, 0.05], 0.72, [0.65, 1.03], 0.69 → [0.65, 0.288938]
  [0.71, 0.91, 0.25], [0.62, 0.58, -0.51], [0.74, 0.97, 0.82], 0.65, [0.03, 1.19], 0.81 → [0.03, 0.0201333212]
  [-0.09, -0.58, -0.74], [0.59, -0.73, -0.79], [0.68, -0.22, -0.86], 0.61, [0.94, 1.54], 0.84 → [0.94, 0.4675184]
  [0.97, 0.72, -0.05], [0.13, 0.06, 0.12], [0.96, 0.11, 0.51], 0.25, [0.42, 1.38], 0.33 → [0.42, 0.389776868]
  [0.3, 0.23, 0.59], [0.03, 0.64, -0.36], [0.09, -0.15, 0.88], 0.9, [0.55, 1.87], 0.07 → [1.36309556, 1.36309556]
  [-0.01, 0.21, -0.34], [-0.04, -0.07, 0.79], [0.29, 0.05, 0.82], 0.48, [0.88, 1.98], 0.97 → [1.98, 1.98]
`,
);

const EDGE = { isSmooth: false, bend: 1, extent: 0, ownCover: 0, isValley: false };

answers(
  'liftOf',
  (isSmooth: boolean, bend: number, extent: number, halfWidth: number, radius: number) =>
    liftOf({ ...EDGE, isSmooth, bend, extent }, halfWidth, radius),
  `
  # By hand: of an edge 0.004 · 0.59 + 0.05 + 6 · 0.003.
  true, 2.12, 0.09, 0.016, 1.06 → 0.24284
  true, 2.91, 0.04, 0.009, 0.66 → 0.124534243
  false, -0.26, 0.05, 0.012, 1.63 → 0.12852
  true, 2.93, 0.08, 0.016, 1.05 → 0.223286772
  true, 2.33, 0.03, 0.003, 2.43 → 0.124824429
`,
);

answers(
  'toleranceOf',
  (ownCover: number, isValley: boolean, pixel: number, radius: number) =>
    toleranceOf({ ...EDGE, ownCover, isValley }, pixel, radius),
  `
  # By hand: 0.01 + 2.49 / 2000 + 6 · 0.007.
  0.08, true, 0.004, 1.06 → 0.10453
  0.06, false, 0.009, 0.66 → 0.06033
  0.06, true, 0.003, 1.63 → 0.078815
`,
);

answers(
  'paperness',
  paperness,
  `
  0.2 → 0
  0.4 → 0.216
  0.6 → 0.784
  0.9 → 1
`,
);

answers(
  'hiddenWeight',
  hiddenWeight,
  `
  0.05 → 0.078125
  0.15 → 0.421875
  0.3 → 0.5
`,
);

answers(
  'wobbleAt',
  wobbleAt,
  `
  [-0.24, -0.86, -0.07], 0.59 → [-0.226522147, 0.355071909]
  [-0.21, 0.82, 0.82], 2.01 → [0.140910765, 1.62816383]
  [-0.72, 0.63, -0.72], 2 → [1.89118216, -0.688608522]
`,
);

answers(
  'depthAcross',
  depthAcross,
  `
  [[0.2, 0.85, 0.36], [0.61, -0.76, -0.58], [-0.26, 0.74, -0.3]], [0.75, -0.19, -0.98], [-0.93, -0.44, -0.14], [1.8, -2.52, -2.38] → 1.46347949
  [[0.84, -0.77, -0.23], [-0.38, -0.8, 0.11], [-0.55, -0.82, -0.68]], [-0.68, -0.67, 0.28], [0.17, 0.13, -0.3], [-3.06, 2.29, 3.22] → 0.561596973
  [[-0.85, 0.38, -0.18], [-0.97, 0.99, -0.48], [0.86, -0.57, -0.36]], [-0.21, -0.06, -0.48], [-0.08, -0.67, 0.93], [-2.1, 3.9, 2.89] → 1.9651661
`,
);

// By hand: a triangle in the plane of x and y faces z, and so do its normals; seen from below it hides nothing.
answers(
  'looksAway',
  (toEye: Vec3, normal: Vec3) => {
    const corners: Corners = [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ];
    return Number(looksAway(corners, [normal, normal, normal], toEye));
  },
  `
  [0, 0, 1], [0, 0, 1] → 0
  [0, 0, -1], [0, 0, 1] → 1
  [0, 0, 1], [0, 0, -1] → 1
`,
);

answers(
  'suggestiveShare',
  (corners: Corners, normals: Corners, bends: Vec3, toEye: Vec3, radius: number) => {
    const at = (k: number) => ({ position: corners[k], normal: normalize(normals[k]), bend: bends[k] });
    return suggestiveShare([at(0), at(1), at(2)], toEye, radius);
  },
  `
  [[0.07, 0.02, 0.01], [0.08, 0.09, -0.06], [0, 0.05, 0.07]], [[-0.22, 0.01, 0.75], [0.2, 0.26, 0.86], [-0.18, 0.24, 1.16]], [-1.48, 0.2, 0.66], [-1.29, 1.86, 1.76], 1.69 → 0.947859454
  [[0, -0.1, 0.1], [0, -0.05, -0.06], [0.07, -0.03, 0.04]], [[-0.11, 0.12, 1.22], [-0.28, -0.24, 1.14], [0.04, 0.08, 1]], [-0.69, 1.98, 1.88], [0.91, 0.99, 0.55], 2.86 → 0.837293132
  [[-0.09, 0.05, 0.02], [-0.08, 0.07, -0.06], [-0.06, 0.09, 0.06]], [[0, 0.09, 1.05], [0.11, 0.22, 0.81], [-0.08, -0.11, 1.03]], [-1.84, -0.35, -1.33], [-0.47, 0.98, 1.69], 2.89 → 0.101034706
  [[0.02, 0.02, 0.1], [-0.01, 0.06, 0.06], [-0.03, -0.05, -0.1]], [[-0.01, 0.08, 0.83], [-0.2, -0.05, 0.74], [-0.19, 0.2, 0.96]], [-0.15, -1.08, 1.74], [0.58, -0.63, 0.92], 2.31 → 0.658827907
  [[-0.09, -0.02, 0.09], [-0.05, 0.01, 0.05], [0.06, -0.03, 0.07]], [[0.25, 0.29, 1.29], [-0.15, 0.27, 1.12], [-0.06, 0.13, 1.24]], [1.32, -1.95, 0.98], [-0.01, 0.87, 0.58], 2.06 → 0
`,
);
