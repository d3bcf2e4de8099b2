/** The pictures of the documentation: what each shows, and how the drawings lie on the sheet. */

const HAND = { subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.45], shadows: true };
const PRINT = { preset: 'engraving', width: 640, height: 640, pixelRatio: 1.6, shadows: true };
/** A print of something that stands on the sheet, with dark hollows. */
const STANDING = { ...PRINT, ground: 'shadow', occlusion: 0.6, material: { shadowStrokes: 'cross' } };

const BUST = { subject: 'nefertiti', view: [0.62, 0.12, 1], light: [-0.75, 1.1, 0.8], zoom: 0.95 };
/** A light by which the shadow of the bust stays on the sheet. */
const BEHIND_THE_BUST = [-0.14, 1.43, 1];
const DRAGON = { subject: 'dragon', view: [0.22, 0.2, 1], light: [-0.8, 1.2, 0.85], zoom: 0.95 };
/** Settings that make the strokes of a preset turn with the light. */
const TURNING = { engraving: { direction: 'light' } };

/** Places of a light that is dragged from the left to the right, in degrees from the front. */
const LIGHT_STEPS = [-80, -40, 0, 40, 80];
const lightAt = (degrees) => [Math.sin((degrees * Math.PI) / 180), 1.35, Math.cos((degrees * Math.PI) / 180)];
/** The media that are neither pen nor graver. */
const MEDIA = ['pencil', 'charcoal', 'chalk', 'stipple', 'woodcut'];
/** Places of a camera that goes round a little, and of a light that goes round while the camera rests. */
const CAMERA_STEPS = [-8, -4, 0];
const MOVED_LIGHTS = [-10, 20, 50];
const viewAt = (degrees) => [
  Math.sin(((30 + degrees) * Math.PI) / 180),
  0.15,
  Math.cos(((30 + degrees) * Math.PI) / 180),
];
const FILLS = [
  { light: [1, 1.1, 0.5], strength: 0.3 },
  { light: [0.2, 0.8, 1], strength: 0.15 },
];

/**
 * @typedef {object} Plan
 * @property {number} columns
 * @property {import('./page.js').Picture[]} pictures all of one size
 */

/**
 * @param {string[]} presets the names of all presets, in the order of the library
 * @param {string[]} techniques the names of all techniques
 * @returns {Record<string, Plan>}
 */
export const plansOf = (presets, techniques) => ({
  presets: {
    columns: 5,
    pictures: presets.map((preset) => ({ ...HAND, preset, width: 400, height: 500, pixelRatio: 1.5 })),
  },
  presetsByModel: {
    columns: presets.length,
    pictures: [BUST, DRAGON, { subject: 'bunny', view: [0, 0.2, 1], light: [-0.8, 1.2, 0.6] }].flatMap((subject) =>
      presets.map((preset) => ({ ...subject, preset, width: 220, height: 220, pixelRatio: 0.6, shadows: true })),
    ),
  },
  media: {
    columns: 5,
    pictures: [BUST, DRAGON].flatMap((subject) =>
      MEDIA.map((preset) => ({
        ...subject,
        preset,
        width: 460,
        height: 460,
        pixelRatio: 1.1,
        shadows: true,
        occlusion: 0.6,
      })),
    ),
  },
  motion: {
    columns: CAMERA_STEPS.length + MOVED_LIGHTS.length,
    pictures: MEDIA.flatMap((preset) =>
      [
        ...CAMERA_STEPS.map((degrees) => ({ view: viewAt(degrees), light: lightAt(-40) })),
        ...MOVED_LIGHTS.map((degrees) => ({ view: viewAt(0), light: lightAt(degrees) })),
      ].map((moved) => ({
        ...moved,
        preset,
        subject: 'nefertiti',
        width: 300,
        height: 300,
        pixelRatio: 1,
        zoom: 2,
        shadows: true,
        occlusion: 0.6,
      })),
    ),
  },
  techniques: {
    columns: techniques.length,
    pictures: techniques.map((technique) => ({
      subject: 'dragon',
      view: [0.22, 0.18, 1],
      light: [-1, 1.2, 0.85],
      shadows: true,
      preset: technique === 'engraving' ? 'engraving' : 'pen',
      material: { technique },
      width: 450,
      height: 450,
      pixelRatio: 1.3,
    })),
  },
  form: {
    columns: 4,
    pictures: [
      DRAGON,
      BUST,
      { subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.45], zoom: 0.95 },
      { subject: 'bunny', view: [0, 0.2, 1], light: [-0.8, 1.2, 0.6], zoom: 0.95 },
      { subject: 'fox', view: [-1, 0.35, 0.8], light: [0.25, 1.6, 0.5], zoom: 0.95 },
      { subject: 'suzanne', view: [0.3, 0.1, 1], light: [-1, 0.9, 0.6], zoom: 0.9 },
    ].flatMap((subject) =>
      ['light', 'form'].map((direction) => ({
        ...PRINT,
        ...subject,
        width: 450,
        height: 450,
        pixelRatio: 1.3,
        material: { direction },
      })),
    ),
  },
  formStrokes: {
    columns: 4,
    pictures: [
      { ...HAND, preset: 'pen', zoom: 0.95 },
      { ...DRAGON, preset: 'crossHatching' },
      { ...BUST, preset: 'crossHatching' },
      { subject: 'fox', view: [-1, 0.35, 0.8], light: [0.25, 1.6, 0.5], zoom: 0.95, preset: 'pencil' },
    ].flatMap((picture) =>
      ['light', 'form'].map((direction) => ({
        ...picture,
        shadows: true,
        width: 450,
        height: 450,
        pixelRatio: 1.1,
        material: { direction },
      })),
    ),
  },
  engraving: {
    columns: 4,
    pictures: [
      { ...PRINT, subject: 'dragon', view: [0.22, 0.18, 1], light: [-1, 1.2, 0.85] },
      { ...PRINT, subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.35], material: { direction: 'y' } },
      { ...PRINT, subject: 'gear', view: [0.7, 0.5, 1], light: [-0.35, 1.1, 0.75], zoom: 0.9 },
      { ...PRINT, subject: 'bunny', view: [0, 0.1, 1], light: [-1, 1, 0.3], material: { crossAngle: Math.PI / 2 } },
    ].map((picture) => ({ ...picture, width: 450, height: 450, pixelRatio: 1.3 })),
  },
  engravings: {
    columns: 3,
    pictures: [
      { ...STANDING, subject: 'dragon', view: [0.22, 0.3, 1], light: [-0.8, 1.6, 0.85], zoom: 0.82 },
      { ...STANDING, ...BUST, light: BEHIND_THE_BUST, zoom: 0.85 },
      { ...PRINT, subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.35], zoom: 0.95 },
      { ...PRINT, subject: 'gear', view: [0.7, 0.5, 1], light: [-0.35, 1.1, 0.75], zoom: 0.85 },
      { ...STANDING, subject: 'fox', view: [-1, 0.35, 0.8], light: [0.25, 1.6, 0.5], zoom: 0.85 },
      { ...STANDING, subject: 'bunny', view: [0, 0.25, 1], light: [-0.8, 1.5, 0.1], zoom: 0.72 },
    ],
  },
  shadows: {
    columns: 3,
    pictures: ['pen', 'engraving'].flatMap((preset) =>
      ['tone', 'cross', 'reorient'].map((shadowStrokes) => ({
        preset,
        subject: 'dragonAndBall',
        width: 600,
        height: 440,
        pixelRatio: 1.2,
        view: [0.1, 0.32, 1],
        light: [-0.75, 1.1, 0.5],
        shadows: true,
        ground: 'floor',
        zoom: 0.82,
        material: { shadowStrokes, strokeLayers: 'single', crossFrom: 1, ...TURNING[preset] },
      })),
    ),
  },
  occlusion: {
    columns: 2,
    pictures: [
      { preset: 'engraving', subject: 'nefertiti', view: [0.4, 0.05, 1], light: [-0.3, 0.5, 1], zoom: 1.5 },
      { preset: 'pen', subject: 'bunny', view: [0, 0.25, 1], light: [-0.3, 1.3, 0.8], zoom: 0.9, ground: 'floor' },
    ].flatMap((picture) =>
      [0, 1].map((occlusion) => ({ ...picture, occlusion, width: 600, height: 600, pixelRatio: 1.3 })),
    ),
  },
  light: {
    columns: LIGHT_STEPS.length,
    pictures: [
      { subject: 'dragon', view: [0.22, 0.3, 1] },
      // Its shadow is long.
      { subject: 'nefertiti', view: [0.3, 0.15, 1], zoom: 0.64 },
      { subject: 'hand', view: [0.1, 0.2, 1] },
    ].flatMap((picture) =>
      LIGHT_STEPS.map((degrees) => ({
        ...STANDING,
        zoom: 0.75,
        ...picture,
        width: 400,
        height: 400,
        pixelRatio: 1,
        light: lightAt(degrees),
        material: { ...STANDING.material, ...TURNING.engraving },
      })),
    ),
  },
  lights: {
    columns: 3,
    pictures: ['pen', 'engraving'].flatMap((preset) =>
      [0, 1, 2].map((count) => ({
        ...STANDING,
        preset,
        subject: 'bunny',
        width: 600,
        height: 520,
        pixelRatio: 1.3,
        zoom: 0.8,
        view: [0, 0.25, 1],
        light: [-0.9, 1.4, 0.4],
        fills: FILLS.slice(0, count),
        material: { ...STANDING.material, ...TURNING[preset] },
      })),
    ),
  },
});

/** The subjects by which looks are judged: a face, a hand, a machine, an animal, a house and a draped cloth. */
const JUDGED = [
  { ...BUST, light: BEHIND_THE_BUST, zoom: 0.85, ground: 'shadow' },
  { ...HAND, zoom: 0.95 },
  { subject: 'gear', view: [0.7, 0.5, 1], light: [-0.35, 1.1, 0.75], zoom: 0.9 },
  { subject: 'fox', view: [-1, 0.35, 0.8], light: [0.25, 1.6, 0.5], zoom: 0.85, ground: 'shadow' },
  { subject: 'house', view: [0.75, 0.4, 1], light: [-0.5, 1.5, 0.9], zoom: 0.85, ground: 'shadow' },
  { subject: 'drapery', view: [0.25, 0.42, 1], light: [-0.5, 1.6, 0.8], zoom: 0.85, ground: 'shadow' },
];

/**
 * The sheet of all swatches.
 *
 * @param {string[]} hands the names of the example hands
 * @returns {{ columns: number, pictures: import('./page.js').SwatchPicture[] }}
 */
export const swatchPlan = (hands) => ({
  columns: 3,
  pictures: hands.map((hand) => ({ swatchesOf: hand, preset: 'pen', width: 620, height: 256 })),
});

/**
 * The sheet of all hands: the swatches of each, and a ball that it has drawn.
 *
 * @param {string[]} hands the names of the example hands
 * @returns {Plan}
 */
export const handPlan = (hands) => ({
  columns: 4,
  pictures: hands.map((hand) => ({
    ...{ subject: 'ball', preset: 'pen', hand, view: [0.1, 0.25, 1], light: [-1, 1.1, 0.9], zoom: 0.9 },
    ...{ width: 360, height: 360, pixelRatio: 1 },
  })),
});

/**
 * The sheets by which looks are judged, one for each preset: `npm run pictures -- looks`.
 *
 * @param {string[]} presets the names of all presets
 * @returns {Record<string, Plan>}
 */
export const lookPlans = (presets) =>
  Object.fromEntries(
    presets.map((preset) => [
      preset,
      {
        columns: 3,
        pictures: JUDGED.map((picture) => ({
          ...picture,
          preset,
          width: 560,
          height: 560,
          pixelRatio: 1,
          shadows: true,
          occlusion: 0.6,
        })),
      },
    ]),
  );

/** The files of subjects that npm packages do not carry. */
export const SUBJECT_FILES = { nefertiti: 'nefertiti_lowres.obj', fox: 'Fox.glb', man: 'CesiumMan.glb' };

/** Number of pictures in a round of the light, and the time that each is shown. */
const STEPS = 40;
const MILLISECONDS = 90;
/** The path of the light, in degrees: over the subject to the other side and back, nearer to the eye. */
const SWING = 75;
const TILT = { mean: 58, change: 14 };

/** The picture in motion at the top of the README: one subject, while a lamp is dragged over it. */
export function movingHero() {
  const picture = { ...STANDING, ...DRAGON, width: 700, height: 420, pixelRatio: 1.2, zoom: 0.9 };
  const eye = normalised(picture.view);
  const right = normalised([eye[2], 0, -eye[0]]);
  const up = [
    eye[1] * right[2] - eye[2] * right[1],
    eye[2] * right[0] - eye[0] * right[2],
    eye[0] * right[1] - eye[1] * right[0],
  ];
  const steps = Array.from({ length: STEPS }, (_, i) => {
    const turn = (2 * Math.PI * i) / STEPS;
    const side = radians(SWING * Math.sin(turn));
    const tilt = radians(TILT.mean + TILT.change * Math.cos(turn));
    const [x, y] = [Math.sin(tilt) * Math.sin(side), Math.sin(tilt) * Math.cos(side)];
    return {
      light: eye.map((value, axis) => Math.cos(tilt) * value + x * right[axis] + y * up[axis]),
      lamp: [picture.width * (0.5 + 0.46 * x), picture.height * (0.56 - 0.56 * y)],
    };
  });
  return { picture, steps, quality: 0.65, milliseconds: MILLISECONDS };
}

const radians = (degrees) => (degrees * Math.PI) / 180;
const normalised = (vector) => vector.map((value) => value / Math.hypot(...vector));
