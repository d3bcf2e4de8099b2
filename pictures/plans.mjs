/** The pictures of the documentation: what each shows, and how the drawings lie on the sheet. */

/** All presets, in the order of the playground. */
export const PRESET_NAMES = [
  'pen',
  'crossHatching',
  'engraving',
  'technical',
  'woodcut',
  'stipple',
  'pencil',
  'charcoal',
];

const HAND = { subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.45], shadows: true };
const PRINT = { preset: 'engraving', width: 640, height: 640, pixelRatio: 1.6, shadows: true };

/**
 * @typedef {object} Plan
 * @property {number} columns
 * @property {import('./page.js').Picture[]} pictures all of one size
 */

/** @type {Record<string, Plan>} */
export const PLANS = {
  presets: {
    columns: 4,
    pictures: PRESET_NAMES.map((preset) => ({ ...HAND, preset, width: 400, height: 500, pixelRatio: 1.5 })),
  },
  engraved: {
    columns: 4,
    pictures: [
      { ...PRINT, subject: 'dragon', view: [0.22, 0.18, 1], light: [-1, 1.2, 0.85] },
      { ...PRINT, subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.35], material: { lineField: 'y' } },
      { ...PRINT, subject: 'gear', view: [0.7, 0.5, 1], light: [-0.35, 1.1, 0.75], zoom: 0.9 },
      { ...PRINT, subject: 'bunny', view: [0, 0.1, 1], light: [-1, 1, 0.3], material: { crossAngle: Math.PI / 2 } },
    ].map((picture) => ({ ...picture, width: 450, height: 450, pixelRatio: 1.3 })),
  },
  hero: {
    columns: 3,
    pictures: [
      { ...PRINT, subject: 'dragon', view: [0.22, 0.18, 1], light: [-1, 1.2, 0.85], zoom: 0.97 },
      { ...PRINT, subject: 'nefertiti', view: [0.62, 0.02, 1], light: [-0.75, 0.8, 1], zoom: 0.95 },
      { ...PRINT, subject: 'hand', view: [0.1, 0.05, 1], light: [-1, 0.7, 0.35], zoom: 0.95 },
      { ...PRINT, subject: 'gear', view: [0.7, 0.5, 1], light: [-0.35, 1.1, 0.75], zoom: 0.85 },
      { ...PRINT, subject: 'fox', view: [-1, 0.25, 0.8], light: [0.3, 1.2, 0.6], zoom: 0.97 },
      { ...PRINT, subject: 'bunny', view: [0, 0.1, 1], light: [-1, 1.1, -0.02], zoom: 0.9 },
    ],
  },
};

/** The files of subjects that npm packages do not carry. */
export const SUBJECT_FILES = { nefertiti: 'nefertiti_lowres.obj', fox: 'Fox.glb', man: 'CesiumMan.glb' };
