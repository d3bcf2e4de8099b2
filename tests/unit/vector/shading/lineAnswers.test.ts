import { mat4, vec3 } from 'gl-matrix';
import { normalize, type Vec3 } from '../../../../src/look/vectors.js';
import { cutFor, cutWidth, rowOctaves } from '../../../../src/vector/shading/carving.js';
import { leftOf, otherShare, sharedByTwo, takenOf } from '../../../../src/vector/shading/crossedTones.js';
import {
  across,
  type CutDirection,
  fieldAt,
  fieldLight,
  firstField,
} from '../../../../src/vector/shading/fieldAxis.js';
import {
  handPoint,
  handPressure,
  handTone,
  handWidth,
  hash01,
  slowWaves,
  turnOf,
} from '../../../../src/vector/shading/hand.js';
import {
  cutFamilies,
  familyGradient,
  familyValue,
  formVarying,
  readCut,
  readForm,
} from '../../../../src/vector/shading/lineFunctions.js';
import { penFor, strokeAt } from '../../../../src/vector/shading/penStrokes.js';
import { octaveOf, octaves, powerOf2, riseOf, roomOf, spacedBy } from '../../../../src/vector/shading/ruledLines.js';
import { changePerPixel, screenMap } from '../../../../src/vector/shading/screenGradient.js';
import { type Along, alongLines, differing, numberOf } from '../../../../src/vector/shading/strokeLengths.js';
import { engravingDarkness } from '../../../gpu/engravingDarkness.js';
import type { LineSettings } from '../../../gpu/hatchingSpec.js';
import type { HatchingReference, ReferenceLight } from '../../../reference/hatchingReference.js';
import { answers } from './answers.js';

/** Engraved lines, strokes of a pen and cuts of a gouge. */

answers(
  'hash01',
  hash01,
  `
  # By hand: the last nine of the Thue–Morse digits before place 31 are 100110100, so 1/2 + 1/16 + 1/32 + 1/128.
  1 → 0.6015625
  2 → 0.205078125
  3 → 0.807617188
  5 → 0.0126953125
  0.5 → 0.80078125
  0.375 → 0.100585938
  17 → 0.249389648
  40.25 → 0.516937256
  -0.5 → 0.30078125
  -7 → 0.717773438
  -0.015625 → 0.0859375
  # By hand: below 0 half a turn from the hash of 3.
  -3 → 0.307617188
`,
);

answers(
  'turnOf',
  turnOf,
  `
  0 → 0
  # By hand: of the digits 0101… nine are left, 0.010101010 = 1/4 + 1/16 + 1/64 + 1/256.
  1 → 0.33203125
  2 → 0.666015625
  3 → 0.999023438
  4 → 0.33203125
  0.5 → 0.666015625
  0.75 → 0.999023438
  5 → 0.665039063
  300 → 0.998474121
`,
);

answers(
  'handWidth',
  handWidth,
  `
  1, 1 → 1.05078125
  3, 0.4 → 1.06152344
  0.375, 1 → 0.800292969
  -7, 0.8 → 1.08710938
  40.25, 0.5 → 1.00423431
  # By hand: a ruling machine draws all lines alike.
  17, 0 → 1
`,
);

answers(
  'slowWaves',
  slowWaves,
  `
  [-1.05, 0.93, -1.03] → [-0.690740936, 0.745536955, 0.988001099]
  [1.41, 0.87, -0.56] → [-0.165504053, 0.954665933, -0.95781669]
  [0, -1.12, -1.79] → [-0.81679888, -0.499408936, 0.942612282]
  [1.48, -1.74, -1.35] → [-0.696046379, -0.796045521, -0.979155363]
`,
);

answers(
  'handPoint and handPressure',
  (place: Vec3, irregularity: number) => {
    const waves = slowWaves(place);
    return [...handPoint(place, waves, irregularity), handPressure(waves, irregularity)];
  },
  `
  [-1.05, 0.93, -1.03], 0.6 → [-1.05497333, 0.935367866, -1.02288639, -0.0926951209]
  [1.41, 0.87, -0.56], 0.6 → [1.40880837, 0.876873595, -0.56689628, -0.0284401946]
  [0, -1.12, -1.79], 0.6 → [-0.00588095193, -1.12359574, -1.78321319, 0.0734249987]
  [1.48, -1.74, -1.35], 0.6 → [1.47498847, -1.74573153, -1.35704992, 0.0997352284]
`,
);

// By hand: tone + pressure · tone · (1 − tone).
answers(
  'handTone',
  handTone,
  `
  0.2, 0.5 → 0.55
  -0.3, 0.4 → 0.328
  0.3, 0 → 0
  0.3, 1 → 1
`,
);

answers(
  'octaves',
  octaves,
  `
  20 → 4.25
  0.3 → -1.8
  0.0721 → -3.8464
  7.5 → 2.875
  # By hand: half way from 2 to 4, and from 1/2 to 1.
  3 → 1.5
  0.75 → -0.5
`,
);

answers(
  'powerOf2',
  powerOf2,
  `
  4.25 → 20
  -1.8 → 0.3
  0.1 → 1.1
  1.5 → 3
  -0.5 → 0.75
`,
);

// By hand: at a spacing of 3, lines that are multiples of 4 have a room of 3, those half way between them of 1, and all others none.
answers(
  'roomOf',
  roomOf,
  `
  2, 1.5 → 3
  7, 1.5 → 3
  1, 1.5 → 1
  0, 1.5 → 0
  3, 3 → 8
  2, 3 → 0
`,
);

// By hand: 8 pixels at 1/4 a pixel are 2, in octaves 1; 64 of 256 parts of a tile at a rise of 1/2 are 1/8, in octaves −3.
answers(
  'octaveOf',
  (screenSpaceShare: number, minLineSpacing: number, coarsest: number) =>
    octaveOf({ lineSpacing: 64, minLineSpacing, screenSpaceShare }, 0.5, 1 / 32, coarsest),
  `
  1, 3, 100 → 1
  0, 3, 100 → -3
  0.5, 3, 100 → -1
  0, 4, 100 → -3
  0, 16, 100 → -1
  1, 3, 0.5 → 0.5
`,
);

// By hand: between 2/3 and 3/2 of the change on the triangle, which counts as at least a sixteenth of the other.
answers(
  'spacedBy',
  spacedBy,
  `
  1, 1 → 1
  2, 1 → 1.5
  1, 2 → 1.33333333
  1, 1.2 → 1
  1, 0 → 0.09375
`,
);

// By hand: slope / 0.4, up to 1.
answers(
  'riseOf',
  riseOf,
  `
  0.1 → 0.25
  0.4 → 1
  1 → 1
`,
);

// By hand: all of the tone up to where others begin, and of the excess 0.4, or with a pen 0.6.
answers(
  'takenOf',
  takenOf,
  `
  0.3, 0.5, 0.4 → 0.3
  0.7, 0.5, 0.4 → 0.58
  0.7, 0.5, 0.6 → 0.62
  1, 0.375, 0.6 → 0.75
`,
);

// By hand: 1 − 0.3 / 0.42, and 1 − 0.3 / 0.38.
answers(
  'leftOf',
  leftOf,
  `
  0.7, 0.58 → 0.285714286
  0.7, 0.62 → 0.210526316
  0.5, 0.5 → 0
`,
);

// By hand: shares of blank multiply, 0.75 · 2/3 = 0.5.
answers(
  'sharedByTwo',
  sharedByTwo,
  `
  0.5, 0.5 → [0.25, 0.333333333]
  0.5, 1 → [0.5, 0]
  0.5, 0 → [0, 0.5]
`,
);
answers(
  'otherShare',
  otherShare,
  `
  1, 1 → 1
  0.7, 1 → 0.7
  1, 0.2 → 0.2
`,
);

// By hand: the cross product with the world's up; with z, where the axis is within 37° of up.
answers(
  'across',
  across,
  `
  [1, 0, 0] → [0, 0, 1]
  [0.6, 0, 0.8] → [-0.8, 0, 0.6]
  [0, 1, 0] → [1, 0, 0]
  [0.6, 0.8, 0] → [0.8, -0.6, 0]
`,
);

answers(
  'firstField',
  (direction: CutDirection, axis: Vec3, bend: number, rotation: number) => {
    const field = firstField(direction, { axis: normalize(axis), bend }, rotation);
    return [...field.axis, field.bend];
  },
  `
  "light", [1, 2, 2], 0.3, 0.5 → [-0.136283717, 0.585055041, 0.79946066, 0.263274769]
  "towardsLight", [2, -1, 2], 0.2, -0.4 → [-0.391676247, -0.129806114, 0.910900703, 0.0778836685]
  "light", [0, 1, 0], 0, 0.7 → [0.644217687, 0.764842187, 0, 0]
  # By hand: the axis itself, without a lamp.
  "y", [1, 0, 0], 0.3, 0.5 → [0, 1, 0, 0]
  "slant", [1, 0, 0], 0.3, 0.5 → [0.48, 0.64, 0.6, 0]
`,
);

answers(
  'fieldAt',
  (axis: Vec3, bend: number, point: Vec3) => {
    const { value, gradient } = fieldAt({ axis: normalize(axis), bend }, point);
    return [value, ...gradient];
  },
  `
  [1, 2, -1], 0.3, [-0.01, 0.58, -1.41] → [0.790053242, 0.538999869, 0.84208392, 0.0193342311]
  [-2, 1, 3], -0.2, [1.38, -0.11, -0.45] → [-1.01997794, -0.32477519, 0.30811543, 0.894195704]
  [0, 1, 2], 0.05, [1.51, -1.69, 1.92] → [0.755202501, -0.0784627638, 0.55257905, 0.829758994]
  # By hand: planes across the axis; and a lamp 2 away, to which the point is nearer by 2 − √5 = −0.236.
  [0, 0, 1], 0, [3, 4, 5] → [5, 0, 0, 1]
  [1, 0, 0], 0.5, [0, 1, 0] → [-0.236067977, 0.894427191, -0.447213595, 0]
`,
);

answers(
  'fieldLight',
  (lamps: readonly (readonly [toLight: Vec3, luminance: number, isFar: boolean])[]) => {
    const { axis, bend } = fieldLight(lamps.map(([toLight, luminance, isFar]) => ({ toLight, luminance, isFar })));
    return [...axis, bend];
  },
  `
  [[[-0.86, 1.51, 0.63], 2, true]] → [-0.465266071, 0.816920659, 0.340834447, 0]
  [[[-0.15, 2.88, -0.31], 1.76, false], [[-1.68, -1.31, 1.79], 0.97, true]] → [0.159874196, 0.94098328, -0.298313104, 0.272382115]
  [[[-0.55, 2.87, -1.57], 2.73, true], [[-1.31, -0.19, -1.22], 2.72, false], [[0.2, -0.64, 0.59], 0.75, true]] → [-0.472995403, 0.546299441, -0.691254128, 0.262936982]
  [[[-2.04, -2.52, -2.15], 2.46, false], [[-1.27, -2.4, -0.25], 0.88, true], [[-0.86, -2.98, 1.02], 1.11, false], [[-1.17, 0.41, 1.27], 1.49, true]] → [-0.461646143, -0.823231129, -0.330413903, 0.230383732]
  # By hand: up without lights; a lamp has the reciprocal of its distance.
  [] → [0, 1, 0, 0]
  [[[0, 0, 4], 1, false]] → [0, 0, 1, 0.25]
  # By hand: tan 2a = Σ w sin 2b / Σ w cos 2b = 1/2 for weights 2 at 0° and 1 at 45°.
  [[[1, 0, 0], 2, true], [[1, 1, 0], 1, true]] → [0.973248989, 0.229752921, 0, 0]
`,
  5,
);

const X_PLANES = cutFamilies({ axis: [1, 0, 0], bend: 0 });
const turned = (angle: number, side: 'B' | 'C') => ({ cosine: Math.cos(angle), sine: Math.sin(angle), side });

// By hand: planes across x lie at a sine to the surface; side B is z, side C is −y, and the one along the surface counts.
answers(
  'readCut',
  (normal: Vec3) => {
    const { slope, firstShare, shareB } = readCut(X_PLANES, [0.2, 0.3, 0.4], normalize(normal), 0);
    return [slope, firstShare, shareB];
  },
  `
  [0, 0, 1] → [1, 1, 0]
  [0, 1, 0] → [1, 1, 1]
  [0, 1, 1] → [1, 1, 0.5]
  # A sine of 0.12 is half way from 0.06 to 0.18.
  [0.992773892, 0, 0.12] → [0.12, 0.5, 0.5]
`,
);

// By hand: cosine · x + sine · side.
answers(
  'familyValue and familyGradient',
  (angle: number, side: 'B' | 'C') => {
    const reading = readCut(X_PLANES, [0.2, 0.3, 0.4], [0, 0, 1], 0);
    const lean = turned(angle, side);
    return [familyValue(X_PLANES, reading, lean), ...familyGradient(X_PLANES, reading, lean)];
  },
  `
  0, "B" → [0.2, 1, 0, 0]
  1.57079633, "B" → [0.4, 0, 0, 1]
  1.57079633, "C" → [-0.3, 0, -1, 0]
  1.04719755, "B" → [0.446410162, 0.5, 0, 0.866025404]
`,
);

const SIZE = 480;
const view = mat4.lookAt(mat4.create(), [1, 1.5, 4], [0, 0, 0], [0, 1, 0]);
const cameraOf = (isOrthographic: boolean) => ({
  view: [...view],
  projection: isOrthographic
    ? [...mat4.ortho(mat4.create(), -2, 2, -2, 2, 0.1, 50)]
    : [...mat4.perspective(mat4.create(), 0.8, 1, 0.1, 50)],
});

/** The screen map of a place in the world. */
function mapAt(isOrthographic: boolean, place: Vec3, normal: Vec3) {
  const back = mat4.invert(mat4.create(), view)!;
  const [x, y, z] = vec3.transformMat4([0, 0, 0], [...place], view);
  const row = (i: number): Vec3 => [back[i], back[4 + i], back[8 + i]];
  const unitsPerPixel = (2 * (isOrthographic ? 1 : -z)) / (cameraOf(isOrthographic).projection[5] * SIZE);
  return screenMap(normal, [row(0), row(1), row(2)], { view: [x, y, z], isOrthographic, unitsPerPixel });
}

answers(
  'changePerPixel',
  (isOrthographic: boolean, place: Vec3, normal: Vec3, gradient: Vec3) =>
    changePerPixel(gradient, mapAt(isOrthographic, place, normal)),
  `
  false, [0.29, -0.71, -0.54], [-0.81, 0.13, 0.84], [1.79, -1.63, -0.05] → 0.0179253253
  true, [-0.84, 0.25, 0.59], [0.51, -0.45, 0.13], [1.74, -1.76, 0.74] → 0.0120680691
  false, [0.14, 0.96, -0.34], [0.98, -0.43, -0.59], [1.91, -1.18, -1.53] → 0.0071817425
  true, [0.14, 0.61, -0.64], [-0.81, 0.66, -0.22], [-0.61, -0.59, 0.58] → 0.0134015328
  false, [0.09, 0.17, -0.61], [-0.72, -0.38, 0.32], [-0.32, 0.27, -1.08] → 0.0708337618
  true, [-0.43, 0.81, -0.7], [0.23, -0.22, -0.46], [-1.25, 1.73, 0.55] → 0.0132717725
`,
);

answers(
  'alongLines',
  (
    isOrthographic: boolean,
    place: Vec3,
    normal: Vec3,
    gradient: Vec3,
    strokeLength: number,
    screenSpaceShare: number,
  ) => {
    const map = mapAt(isOrthographic, place, normal);
    const { places, share, period, longer } = alongLines(place, normal, gradient, map, {
      strokeLength,
      screenSpaceShare,
    });
    return [...places, share, period, longer];
  },
  `
  false, [0.29, -0.71, -0.54], [-0.81, 0.13, 0.84], [1.79, -1.63, -0.05], 47, 0.45 → [0.29, -0.71, 0.253313404, 0.25, 0]
  true, [-0.84, 0.25, 0.59], [0.51, -0.45, 0.13], [1.74, -1.76, 0.74], 128, 0.04 → [0.59, 0.25, 0, 0.5, 0]
  false, [0.14, 0.96, -0.34], [0.98, -0.43, -0.59], [1.91, -1.18, -1.53], 110, 0.61 → [-0.34, 0.96, 0.0789959303, 0.5, 0]
  true, [0.14, 0.61, -0.64], [-0.81, 0.66, -0.22], [-0.61, -0.59, 0.58], 61, 0.13 → [-0.64, 0.61, 1, 0.25, 0]
  false, [0.09, 0.17, -0.61], [-0.72, -0.38, 0.32], [-0.32, 0.27, -1.08], 52, 0.26 → [0.09, 0.17, 0, 0.25, 0]
  true, [-0.43, 0.81, -0.7], [0.23, -0.22, -0.46], [-1.25, 1.73, 0.55], 39, 0.11 → [-0.43, 0.81, 1, 0.125, 0]
`,
);

// By hand: (log₂ of the repeat − octave) / 5, from 0.01 to 1.
answers(
  'differing',
  differing,
  `
  -3, 4 → 1
  0, 4 → 0.4
  2, 4 → 0.01
  0, Infinity → 1
`,
);

// By hand: the remainder of least size.
answers(
  'numberOf',
  numberOf,
  `
  5.5, 4 → 1.5
  -1, 4 → -1
  7, 4 → -1
  7, Infinity → 7
`,
);

type AlongRow = readonly [places: readonly [number, number], share: number, period: number, longer: number];
const alongOf = ([places, share, period, longer]: AlongRow): Along => ({ places, share, period, longer });

answers(
  'strokeAt: width and offset',
  (
    along: AlongRow,
    tone: number,
    irregularity: number,
    repeat: number,
    octave: number,
    share: number,
    line: number,
  ) => {
    const { width, astray } = strokeAt(penFor(tone, alongOf(along), irregularity, repeat, octave), share, line);
    return [width, astray];
  },
  `
  [[-3.35, 0.08], 0.65, 0.5, 0.37], 0.12, 0.27, Infinity, -1.07, 1, -9.25 → [0.0825042591, -0.00343863244]
  [[3.53, 4.43], 0.54, 0.5, 0], 0.06, 0.34, 4, 1.68, 0.6, -6.25 → [0.0776058589, -0.00269193137]
  [[-4.18, -4.87], 0.79, 2, 0], 0.11, 0.13, Infinity, -0.09, 1, -9.25 → [0.308293513, -0.00195135081]
  [[-2.72, -2.37], 0.31, 2, 0.52], 0.12, 0.09, 4, 1.83, 1, 3.25 → [0.170135268, 0.000227779409]
  [[-0.96, -4.22], 0.56, 1, 0], 0.45, 0.59, Infinity, -0.36, 0.8, 5 → [0.0307488241, -0.000987742799]
  [[1.85, -2.24], 0.15, 0.25, 0], 0.5, 0.99, 4, -1.97, 1, 7.75 → [0.526140131, -0.00972505602]
  [[2.94, -4.86], 0.48, 1, 0.32], 0.71, 0.16, Infinity, 0.52, 1, -4 → [0.713916156, -0.0000259020362]
  [[2.35, 4.08], 0.27, 1, 0], 0.3, 0.3, 4, -0.53, 0.87, -8 → [0.188887949, 0]
  [[4.08, 3.86], 0.47, 0.5, 0], 0.24, 0.28, Infinity, -0.69, 1, 3.5 → [0.278447214, 0.00715304757]
  [[2.1, -3.31], 0.51, 0.5, 0.33], 0.25, 0.29, 4, -0.11, 1, 6.75 → [0.240218828, 0.00284219574]
  [[-3.53, -2.59], 0.32, 1, 0], 0.9, 0.85, Infinity, -1.53, 0.48, 4.75 → [0.432, 0]
  [[-0.14, 3.93], 0.54, 2, 0], 0.44, 0.35, 4, -0.02, 1, 1 → [0.489660464, -0.0000406246191]
  [[3.32, -2.3], 0.63, 2, 0.45], 0.1, 0.54, Infinity, 1.95, 1, 4 → [0, 0.00199864021]
  [[2.32, -3.73], 0.19, 1, 0], 0.51, 0.49, 4, -0.06, 0.11, 9.5 → [0.0783730914, 0.000807847442]
`,
);

answers(
  'cutWidth',
  (along: AlongRow, tone: number, repeat: number, octave: number, line: number) =>
    cutWidth(cutFor(tone, alongOf(along), repeat, octave), line),
  `
  [[-3.35, 0.08], 0.65, 0.5, 0.37], 0.12, Infinity, -1.07, -9.25 → 0.949177447
  [[3.53, 4.43], 0.54, 0.5, 0], 0.06, 4, 1.68, -6.25 → 0.938975669
  [[-4.18, -4.87], 0.79, 2, 0], 0.11, Infinity, -0.09, -9.25 → 0.838092823
  [[-2.72, -2.37], 0.31, 2, 0.52], 0.12, 4, 1.83, 3.25 → 0.882437335
  [[-0.96, -4.22], 0.56, 1, 0], 0.45, Infinity, -0.36, 5 → 0.939619859
  [[1.85, -2.24], 0.15, 0.25, 0], 0.5, 4, -1.97, 7.75 → 0.566250315
  [[2.94, -4.86], 0.48, 1, 0.32], 0.71, Infinity, 0.52, -4 → 0.314056239
  [[2.35, 4.08], 0.27, 1, 0], 0.3, 4, -0.53, -8 → 0.557219444
  [[4.08, 3.86], 0.47, 0.5, 0], 0.24, Infinity, -0.69, 3.5 → 0.822184536
  [[2.1, -3.31], 0.51, 0.5, 0.33], 0.25, 4, -0.11, 6.75 → 0.692187299
  [[-3.53, -2.59], 0.32, 1, 0], 0.9, Infinity, -1.53, 4.75 → 0.200684778
  [[-0.14, 3.93], 0.54, 2, 0], 0.44, 4, -0.02, 1 → 0.510882937
  # By hand: a black block has no cuts, and a white one is cut away.
  [[0.3, 0.4], 1, 0.5, 0], 1, Infinity, 0, 3 → 0
  [[0.3, 0.4], 1, 0.5, 0], 0, Infinity, 0, 3 → 1
`,
);

// By hand: octaves of 0.24 / rare, from 0 to 2; 0.24 / 0.08 = 3 is half way from 2 to 4.
answers(
  'rowOctaves',
  rowOctaves,
  `
  0.5 → 0
  0.08 → 1.5
  0.92 → 1.5
  0.06 → 2
  0.01 → 2
`,
);

// By hand: the function is 2 at the place, and 0.25 lower at its vertex; the hand adds its offset along the gradient.
answers(
  'readForm',
  (gradient: Vec3, value: number, place: Vec3, irregularity: number, isInk: boolean) => {
    const read = readForm(formVarying(gradient, value, place), place, irregularity, isInk);
    return [read.value, read.pressure];
  },
  `
  [1, 2, 0], 2, [0.5, 0, 0], 0, true → [2, 0]
  # At [-1.05, 0.93, -1.03] the waves are those above: 0.6 · 0.012 · (−0.690740936 + 2 · 0.745536955), and 0.25 · 0.6 · 0.988001099.
  [1, 2, 0], 2, [-1.05, 0.93, -1.03], 0.6, true → [2.0057624, 0.0555050439]
  [1, 2, 0], 2, [-1.05, 0.93, -1.03], 0.6, false → [2.0057624, -0.0926951209]
`,
);

/** Fragments: everything together, in all fields, media and shadows. */
const matrixWorld = [...mat4.fromRotation(mat4.create(), 0.7, [1, 2, 0.5])!];
const sun: ReferenceLight = { type: 'directional', color: [3, 3, 3], position: [1, 2, 3], target: [0, 0, 0] };
const lamp: ReferenceLight = { type: 'point', color: [4, 2, 1], position: [2, 1.5, 1], decay: 2 };
const LIGHTS = { none: [], sun: [sun], lamp: [lamp], both: [sun, lamp] };
const form: NonNullable<LineSettings['form']> = [
  { linear: [1.5, 5, 0.5], squares: [1.2, -0.6, 0.4] },
  { linear: [4.5, -2.2, 1], squares: [0, 0.5, -0.3] },
];

answers(
  'darkness of fragments',
  (
    direction: LineSettings['direction'],
    technique: 'engraving' | 'pen' | 'woodcut',
    shadowStrokes: 'tone' | 'cross' | 'reorient',
    isOrthographic: boolean,
    lit: keyof typeof LIGHTS,
    dark: keyof typeof LIGHTS,
    [lineSpacing, strokeLength, crossFrom, irregularity, screenSpaceShare]: readonly [
      number,
      number,
      number,
      number,
      number,
    ],
    place: Vec3,
    normal: Vec3,
    flatNormal: Vec3,
    tone: number,
    unshadowed: number,
  ) => {
    const reference = {
      toWorld: (p: Vec3) => vec3.transformMat4([0, 0, 0], [...p], matrixWorld as unknown as mat4),
      tone: (_at: Vec3, _normal: Vec3, hasShadows = true) => (hasShadows ? tone : unshadowed),
      turnsAway: (light: ReferenceLight) => LIGHTS[dark].includes(light as never),
    } as unknown as HatchingReference;
    const isForm = direction === 'form' || direction === 'acrossForm';
    const darknessOf = engravingDarkness(
      {
        lines: {
          direction,
          technique,
          lineSpacing,
          strokeLength,
          crossFrom,
          crossAngle: 1.05,
          irregularity,
          ...(isForm && { form }),
        },
        ...{ lights: LIGHTS[lit], matrixWorld, camera: cameraOf(isOrthographic), width: SIZE, height: SIZE },
        material: { strokeAngle: 0.3, tilesPerObjectUnit: 3, shadowStrokes },
        ...{ screenSpaceShare, centre: [0.2, -0.1, 0.05] as const },
      },
      reference,
    );
    return darknessOf([...place], [...normal], [...normal], [...flatNormal], false);
  },
  `
  "light", "engraving", "tone", true, "sun", "none", [6, 65, 0.8, 0.49, 0.04], [-0.78, -0.54, -0.42], [-0.83, 0.08, -0.29], [-0.98, 0.22, -0.28], 0.49, 0.49 → 0.148091233
  "x", "engraving", "tone", false, "both", "none", [8.3, 88, 0.86, 0.3, 0.8], [0.79, -0.36, -0.7], [-0.84, 0.24, -0.15], [-0.73, 0.33, -0.03], 0.48, 0.48 → 0.131089329
  "y", "engraving", "tone", false, "sun", "none", [3.6, 127, 0.55, 0.9, 0.45], [-0.74, -0.88, 0.17], [-0.3, 0.48, 0.49], [-0.37, 0.42, 0.66], 0.12, 0.12 → 0.0310108897
  "acrossForm", "engraving", "tone", false, "lamp", "none", [7.3, 98, 0.35, 0.42, 0.31], [0.7, -0.76, 0.05], [0.37, 0.2, -0.12], [0.43, 0.14, -0.12], 0.25, 0.25 → 0.260675569
  "slant", "pen", "tone", false, "lamp", "none", [5.8, 55, 0.55, 1, 0.16], [0.16, 0.04, -0.3], [0.57, 0.78, -0.84], [0.48, 0.78, -0.75], 0.61, 0.61 → 0.552861516
  "form", "pen", "tone", false, "both", "none", [3.3, 116, 0.57, 0.72, 0.96], [0.91, -0.68, -0.46], [0.21, 0.48, -0.36], [0.41, 0.63, -0.48], 0.66, 0.66 → 0.74883363
  "light", "woodcut", "tone", false, "lamp", "none", [8.9, 123, 0.74, 0.36, 0.56], [-0.61, -0.89, 0.16], [0.53, -0.13, -0.33], [0.49, -0.19, -0.29], 0.38, 0.38 → 0.654106188
  "towardsLight", "woodcut", "tone", false, "both", "none", [6.4, 111, 0.65, 0.34, 0.88], [0.61, -0.86, 0.66], [0.08, 0.02, 0.83], [-0.11, -0.01, 0.88], 0.65, 0.65 → 0.966673564
  "y", "woodcut", "tone", false, "lamp", "none", [6.7, 40, 0.86, 0.7, 0.05], [0.93, 0.12, 0.9], [-0.07, 0.86, 0.59], [-0.06, 0.96, 0.66], 0.74, 0.74 → 0.950243766
  "acrossForm", "woodcut", "tone", false, "both", "none", [5.6, 121, 0.86, 0.56, 0.14], [-0.1, 0.08, 0.16], [-0.67, 0.64, -0.75], [-0.55, 0.63, -0.72], 0.66, 0.66 → 0.793552939
  "towardsLight", "engraving", "cross", true, "lamp", "none", [6.1, 129, 0.23, 0.46, 0.9], [0.7, -0.42, 0.88], [-0.44, -0.05, -0.62], [-0.54, -0.09, -0.43], 0.7516, 0.73 → 0.362832623
  "z", "engraving", "cross", false, "lamp", "none", [8.2, 90, 0.66, 0.79, 0.11], [0.63, -0.61, -0.97], [-0.04, -0.7, -0.37], [-0.15, -0.72, -0.3], 0.7376, 0.18 → 0.582542982
  "slant", "engraving", "cross", false, "both", "none", [3.3, 117, 0.47, 0.18, 0.85], [0.23, 0.2, -0.42], [0.35, 0.18, 0.71], [0.17, 0.18, 0.74], 0.4978, 0.07 → 0.133581064
  "towardsLight", "pen", "cross", false, "sun", "none", [8.5, 73, 0.45, 0.81, 0.36], [-0.64, -0.4, -0.08], [0.56, -0.41, -0.62], [0.74, -0.5, -0.49], 0.5474, 0.38 → 0.387021499
  "x", "pen", "cross", false, "lamp", "none", [3.4, 49, 0.45, 0.88, 0.74], [0.49, 0.14, 0.24], [-0.18, 0.18, 0.82], [-0.3, 0.22, 0.92], 0.5372, 0.11 → 0.962728233
  "form", "pen", "cross", false, "both", "none", [6.7, 129, 0.94, 0.65, 0.19], [0.19, 0.19, 0.39], [0.25, -0.41, -0.76], [0.42, -0.49, -0.61], 0.55, 0.4 → 0.880493866
  "acrossForm", "pen", "cross", false, "sun", "none", [5.5, 84, 0.12, 0.83, 0.71], [0.01, -0.36, 0.94], [-0.11, 0.32, 0.3], [0.01, 0.28, 0.43], 0.6868, 0.46 → 0.875912729
  "light", "woodcut", "cross", true, "lamp", "none", [8.5, 78, 0.99, 0.53, 0.64], [-0.26, 0.08, -0.27], [-0.36, 0.99, 0.07], [-0.5, 1.09, 0.09], 0.2811, 0.09 → 0.725010627
  "x", "woodcut", "cross", false, "sun", "none", [7.1, 127, 0.12, 0.72, 0.25], [-0.59, -0.22, 0.9], [-0.94, -0.41, 0.96], [-0.8, -0.53, 0.93], 0.4848, 0.44 → 0.0804177282
  "z", "woodcut", "cross", false, "both", "none", [7.2, 118, 0.63, 0.25, 0.81], [-0.07, -0.22, -0.06], [-0.88, -0.39, -0.64], [-1.01, -0.4, -0.54], 0.7148, 0.08 → 0.119408056
  "slant", "woodcut", "cross", true, "sun", "none", [5.2, 65, 0.98, 0.3, 0.91], [-0.33, -0.43, -0.73], [-0.18, 0.82, -0.15], [-0.06, 0.92, -0.24], 0.648, 0.2 → 0.756938283
  "form", "woodcut", "cross", false, "lamp", "none", [6.4, 105, 0.69, 0.29, 0.12], [0.46, -0.11, -0.42], [0.96, 0.15, 0.51], [1.09, 0.35, 0.5], 0.4708, 0.46 → 0.68520202
  "acrossForm", "woodcut", "cross", false, "both", "none", [8.3, 95, 0.66, 0.03, 0.88], [-0.65, 0.03, 0.27], [0.85, -0.47, -0.14], [0.88, -0.51, -0.07], 0.846, 0.8 → 0.912919855
  "form", "engraving", "reorient", false, "sun", "sun", [6.2, 30, 0.42, 0.94, 0.27], [-0.4, -0.36, -0.44], [0.37, -0.88, -0.33], [0.33, -0.85, -0.48], 0.16, 0.16 → 0.0347397565
  "light", "pen", "reorient", false, "both", "sun", [5.7, 130, 0.59, 0.18, 0.41], [-0.55, -0.14, 0.39], [0.1, 0.78, -0.48], [0.09, 0.94, -0.53], 0.76, 0.76 → 0.724140979
  "towardsLight", "pen", "reorient", false, "sun", "lamp", [4.5, 58, 0.85, 0.19, 0.2], [0.24, 0.43, 0.24], [-0.58, 0.95, -0.88], [-0.43, 0.82, -0.84], 0.92, 0.92 → 0.877989644
  "x", "pen", "reorient", false, "lamp", "lamp", [4.6, 113, 0.62, 0.95, 0.75], [-0.68, 0.3, 0.24], [-0.56, -0.31, -0.87], [-0.57, -0.4, -0.7], 0.37, 0.37 → 0.925270398
  "y", "pen", "reorient", false, "both", "lamp", [3.5, 128, 0.72, 0.26, 0.62], [0.72, 0.08, 0.92], [0.51, 0.87, -0.87], [0.55, 0.85, -1.03], 0.24, 0.24 → 0.64172429
  "z", "pen", "reorient", true, "sun", "both", [6.2, 119, 0.24, 0.88, 0.02], [-0.47, 0.63, -0.68], [-0.89, 0.74, 0.86], [-0.83, 0.85, 0.76], 0.45, 0.45 → 0.929189648
  "slant", "pen", "reorient", false, "lamp", "both", [3.2, 93, 0.55, 0.27, 0.11], [0.09, -0.56, -0.67], [-0.01, 0.03, -0.15], [-0.06, 0.21, -0.23], 0.92, 0.92 → 0.92261346
  "acrossForm", "pen", "reorient", false, "sun", "sun", [4.9, 122, 0.65, 0.49, 0.81], [0.88, -0.01, 0.62], [0.62, 0.71, -0.18], [0.73, 0.63, -0.12], 0.24, 0.24 → 0.40820803
  "towardsLight", "woodcut", "reorient", true, "both", "sun", [7.9, 68, 0.77, 0.91, 0.49], [-0.9, -0.13, 0.15], [-0.72, -0.97, -0.95], [-0.7, -1.09, -0.86], 0.59, 0.59 → 0.9180625
  "y", "woodcut", "reorient", false, "lamp", "lamp", [8.5, 85, 0.66, 0.87, 0.58], [0.1, 0.21, -0.59], [0.94, -0.06, 0.37], [0.89, 0.12, 0.49], 0.42, 0.42 → 0.155688514
  "form", "woodcut", "reorient", true, "lamp", "both", [3, 40, 0.42, 0.18, 0.19], [0.13, 0.55, -0.06], [0.17, 0.67, -0.07], [0.18, 0.72, 0.02], 0.2, 0.2 → 0.507336423
  "y", "pen", "tone", false, "both", "none", [5.3, 58, 0.35, 0.04, 0.64], [0.55, 0.96, 0.73], [0.41, 0.99, 0.46], [0.32, 1.11, 0.32], 0.3, 0.3 → 0.30279107
  "z", "pen", "tone", false, "sun", "none", [6.5, 128, 0.3, 0.8, 0.22], [-0.27, -0.08, -0.02], [0.38, 0.47, -0.99], [0.33, 0.44, -1.13], 0.1, 0.1 → 0.0834101852
  "z", "woodcut", "tone", false, "both", "none", [5.9, 140, 0.14, 0.33, 0.68], [-0.77, -0.76, 0.78], [-0.27, 0.05, -0.89], [-0.16, 0.17, -0.99], 0.72, 0.72 → 0.587469901
  "slant", "woodcut", "tone", false, "sun", "none", [3.1, 94, 0.17, 0.85, 0.62], [0.76, 0.49, 0.02], [-0.83, 0.2, 0.02], [-0.85, 0.26, -0.12], 0.48, 0.48 → 0.253751923
  "light", "pen", "cross", false, "both", "none", [6.1, 72, 0.3, 0.9, 0.24], [-0.97, 0.85, 0.24], [0.87, -0.35, 0.11], [0.74, -0.37, 0.21], 0.6173, 0.11 → 0.717484399
  "x", "woodcut", "reorient", true, "sun", "lamp", [3.8, 45, 0.76, 0.66, 0.99], [-0.41, 0.91, 0.17], [0.76, 0.16, -0.62], [0.65, 0.02, -0.71], 0.27, 0.27 → 0.736663654
`,
  4,
);
