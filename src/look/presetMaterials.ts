/** The materials of the presets, as plain data. */

/** The tone curve of a woodcut: blank paper or solid ink, and little in between. */
const CUT = [
  [0, 0],
  [0.28, 0],
  [0.45, 0.22],
  [0.62, 0.68],
  [0.8, 0.92],
  [0.93, 1],
  [1, 1],
] as const;

/** The tone curve of pencil and charcoal: lights are lifted off with an eraser, half tones are soft, and darks deep. */
const RUBBED = [
  [0, 0],
  [0.12, 0],
  [0.3, 0.08],
  [0.5, 0.38],
  [0.8, 0.84],
  [1, 0.98],
] as const;

/** The tone curve of chalk on dark paper, which draws the lights and leaves the shade blank. */
const CHALKED = [
  [0, 0.95],
  [0.2, 0.8],
  [0.55, 0.25],
  [0.85, 0.02],
  [1, 0],
] as const;

/**
 * Values in ink alone: the colours of surfaces are hatched as tones, and the darkest still show their form; only hollows are darker.
 * A fitted exposure gives lights, half tones and darks.
 */
const VALUES = {
  composition: { exposure: 'fit' },
  colorHatching: 0.8,
  colorFill: 0,
  hollowStrength: 1,
} as const;

const BLACK = '#1c1a17';
const WHITE = '#f7f3e8';

// biome-ignore lint/complexity/noExcessiveLinesPerFunction: it is a table.
const makeMaterials = () =>
  ({
    pen: {
      technique: 'pen',
      screenSpaceShare: 1,
      direction: 'auto',
      lineSpacing: 4.4,
      strokeLength: 72,
      crossFrom: 0.6,
      crossAngle: Math.PI / 3,
      irregularity: 0.6,
      toneCurve: 'printed',
      reflectedLight: 0.35,
      ...VALUES,
      ink: BLACK,
      paper: WHITE,
    },
    crossHatching: {
      technique: 'pen',
      screenSpaceShare: 1,
      direction: 'auto',
      lineSpacing: 3.8,
      strokeLength: 84,
      crossFrom: 0.28,
      crossAngle: Math.PI / 5,
      irregularity: 0.6,
      toneCurve: 'printed',
      reflectedLight: 0.25,
      ...VALUES,
      ink: BLACK,
      paper: WHITE,
    },
    engraving: {
      technique: 'engraving',
      screenSpaceShare: 1,
      direction: 'auto',
      lineSpacing: 4.5,
      crossFrom: 0.52,
      crossAngle: Math.PI / 3,
      irregularity: 0.4,
      toneCurve: 'printed',
      reflectedLight: 0.4,
      ...VALUES,
      ink: BLACK,
      paper: WHITE,
    },
    banknote: {
      technique: 'engraving',
      screenSpaceShare: 1,
      direction: 'form',
      lineSpacing: 3.2,
      crossFrom: 0.3,
      crossAngle: Math.PI / 3,
      irregularity: 0.1,
      toneCurve: 'printed',
      reflectedLight: 0.3,
      ...VALUES,
      ink: '#18332f',
      paper: '#f6f4e9',
    },
    technical: {
      technique: 'engraving',
      screenSpaceShare: 1,
      direction: 'y',
      lineSpacing: 5,
      crossFrom: 1,
      irregularity: 0,
      toneCurve: 'printed',
      reflectedLight: 0.25,
      ...VALUES,
      ink: BLACK,
      paper: WHITE,
    },
    woodcut: {
      technique: 'woodcut',
      screenSpaceShare: 1,
      direction: 'auto',
      lineSpacing: 7,
      strokeLength: 130,
      crossFrom: 1,
      irregularity: 0.6,
      toneCurve: CUT,
      reflectedLight: 0.15,
      ...VALUES,
      ink: '#120e0a',
      paper: '#ece0c4',
    },
    stipple: {
      technique: 'stipple',
      screenSpaceShare: 1,
      strokeWidth: 1.8,
      strokeLayers: 'single',
      toneCurve: 'printed',
      reflectedLight: 0.3,
      ...VALUES,
      ink: BLACK,
      paper: WHITE,
    },
    pencil: {
      technique: 'dryMedia',
      screenSpaceShare: 1,
      latticeSpacing: 0.5,
      strokeWidth: 1.5,
      direction: 'form',
      strokeLayers: 'tone',
      crossFrom: 0.45,
      crossAngle: Math.PI / 6,
      paperGrain: 0.35,
      paperGrainSize: 1.6,
      softness: 1,
      smudge: 0.4,
      toneCurve: RUBBED,
      reflectedLight: 0.4,
      ...VALUES,
      ink: '#34343a',
      paper: '#fbfaf6',
      tonalArtMap: 'pencil',
    },
    charcoal: {
      technique: 'dryMedia',
      screenSpaceShare: 1,
      latticeSpacing: 0.5,
      strokeWidth: 2.6,
      direction: 'sheet',
      strokeAngle: Math.PI / 4,
      strokeLayers: 'single',
      paperGrain: 0.5,
      paperGrainSize: 2,
      softness: 1,
      smudge: 0.75,
      toneCurve: RUBBED,
      reflectedLight: 0.3,
      ...VALUES,
      ink: '#1d1a19',
      paper: '#e6dccb',
      tonalArtMap: 'charcoal',
    },
    chalk: {
      technique: 'dryMedia',
      screenSpaceShare: 1,
      latticeSpacing: 0.5,
      strokeWidth: 3,
      direction: 'sheet',
      strokeAngle: Math.PI / 5,
      strokeLayers: 'single',
      paperGrain: 0.5,
      paperGrainSize: 2,
      softness: 1,
      smudge: 0.6,
      toneCurve: CHALKED,
      reflectedLight: 0,
      ...VALUES,
      ink: '#f4f1e6',
      paper: '#2f3a38',
      tonalArtMap: 'pencil',
    },
  }) as const;

/** The material parameters of every preset, with ink and paper. */
export const PRESET_MATERIALS = /* @__PURE__ */ frozen(/* @__PURE__ */ makeMaterials());

/** What presets say of their shadows on a ground: parameters of `HatchingShadowMaterial`. */
export const PRESET_SHADOWS: Readonly<Partial<Record<PresetName, { readonly shadowSoftness: number }>>> =
  /* @__PURE__ */ frozen({
    // Sharp edges that still end each line in a point.
    woodcut: { shadowSoftness: 0.05 },
  });

/** The names of the presets. */
export type PresetName = keyof typeof PRESET_MATERIALS;

/** Freezes a value and everything in it. */
export function frozen<Value>(value: Value): Value {
  if (typeof value === 'object' && value !== null) for (const part of Object.values(value)) frozen(part);
  return Object.freeze(value);
}
