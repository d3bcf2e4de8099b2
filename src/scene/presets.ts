import type { OutlineOptions } from '../geometry/prepareHatchingGeometry.js';
import type { ToneCurve } from '../material/fitToneCurve.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import type { HatchingOutlineParameters } from '../outlines/HatchingOutlineMaterial.js';
import type { MapDrawing } from '../tam/TonalArtMap.js';

/** A complete look: the material, outlines and tonal art map, in the form of the options of `applyHatching`. */
export interface HatchingPreset {
  /** The parameters of the material, including ink and paper. */
  readonly material: Readonly<HatchingMaterialParameters>;
  /** The options and parameters of the outlines. */
  readonly outlines: Readonly<OutlineOptions & HatchingOutlineParameters>;
  /** The options of `TonalArtMap.generate`; `null` if the preset needs no map. */
  readonly tonalArtMap: Readonly<MapDrawing> | null;
}

/** The tone curve of printed line drawings: lights stay blank, and some paper shows even in the deepest shade. */
const PRINTED: ToneCurve = [
  [0, 0],
  [0.15, 0],
  [0.3, 0.06],
  [0.45, 0.22],
  [0.6, 0.44],
  [0.75, 0.65],
  [0.9, 0.8],
  [1, 0.86],
];

/** The tone curve of a woodcut: blank paper or solid ink, and little in between. */
const CUT: ToneCurve = [
  [0, 0],
  [0.25, 0],
  [0.45, 0.2],
  [0.65, 0.7],
  [0.85, 0.95],
  [1, 1],
];

/** The tone curve of pencil and charcoal: the tooth of the paper takes a little grey even in the lights. */
const RUBBED: ToneCurve = [
  [0, 0.04],
  [0.2, 0.08],
  [0.5, 0.4],
  [0.8, 0.8],
  [1, 0.95],
];

/** The tone curve of chalk on dark paper, which draws the lights and leaves the shade blank. */
const CHALKED: ToneCurve = [
  [0, 0.95],
  [0.2, 0.8],
  [0.55, 0.25],
  [0.85, 0.02],
  [1, 0],
];

const BLACK = '#1c1a17';
const WHITE = '#f7f3e8';

// biome-ignore lint/complexity/noExcessiveLinesPerFunction: it is a table.
const makePresets = () =>
  ({
    pen: {
      material: {
        technique: 'anchored',
        sizedOnScreen: 1,
        anchorSpacing: 0.4,
        strokeWidth: 1.5,
        strokeRotation: Math.PI / 2,
        strokeLayers: 'tone',
        crossFrom: 0.6,
        crossAngle: Math.PI / 3,
        toneCurve: PRINTED,
        reflectedLight: 0.35,
        ink: BLACK,
        paper: WHITE,
      },
      outlines: { outlineWidth: 1.8, wobble: 1, ink: BLACK },
      tonalArtMap: { style: 'hatching' },
    },
    crossHatching: {
      material: {
        technique: 'anchored',
        sizedOnScreen: 1,
        anchorSpacing: 0.4,
        strokeWidth: 1.2,
        strokeRotation: Math.PI / 4,
        strokeLayers: 'tone',
        crossFrom: 0.15,
        crossAngle: Math.PI / 2,
        toneCurve: PRINTED,
        reflectedLight: 0.25,
        ink: BLACK,
        paper: WHITE,
      },
      outlines: { outlineWidth: 1.4, wobble: 1, ink: BLACK },
      tonalArtMap: { style: 'contours' },
    },
    engraving: {
      material: {
        technique: 'engraved',
        sizedOnScreen: 1,
        lineField: 'light',
        lineSpacing: 4.5,
        crossFrom: 0.52,
        crossAngle: Math.PI / 3,
        handmade: 0.4,
        toneCurve: PRINTED,
        reflectedLight: 0.4,
        ink: BLACK,
        paper: WHITE,
      },
      outlines: { outlineWidth: 1.5, ink: BLACK },
      tonalArtMap: null,
    },
    technical: {
      material: {
        technique: 'engraved',
        sizedOnScreen: 1,
        lineField: 'y',
        lineSpacing: 5,
        crossFrom: 1,
        handmade: 0,
        toneCurve: PRINTED,
        reflectedLight: 0.25,
        ink: BLACK,
        paper: WHITE,
      },
      outlines: { outlineWidth: 1.6, creases: 1, materialBorders: 1, shadeWeights: [1, 1], ink: BLACK },
      tonalArtMap: null,
    },
    woodcut: {
      material: {
        technique: 'engraved',
        medium: 'woodcut',
        sizedOnScreen: 1,
        lineField: 'towards',
        lineSpacing: 7,
        crossFrom: 1,
        handmade: 0.6,
        toneCurve: CUT,
        reflectedLight: 0.15,
        ink: '#120e0a',
        paper: '#ece0c4',
      },
      outlines: { outlineWidth: 3.2, ink: '#120e0a' },
      tonalArtMap: null,
    },
    stipple: {
      material: {
        technique: 'anchored',
        sizedOnScreen: 1,
        anchorSpacing: 0.4,
        strokeWidth: 2.6,
        strokeRotation: Math.PI / 2,
        medium: 'stipple',
        strokeLayers: 'single',
        toneCurve: PRINTED,
        reflectedLight: 0.3,
        ink: BLACK,
        paper: WHITE,
      },
      outlines: { outlineWidth: 1, ink: BLACK },
      tonalArtMap: null,
    },
    pencil: {
      material: {
        technique: 'anchored',
        sizedOnScreen: 1,
        anchorSpacing: 0.5,
        strokeWidth: 2,
        strokeRotation: 0.75 * Math.PI,
        strokeLayers: 'tone',
        crossFrom: 0.45,
        crossAngle: Math.PI / 6,
        medium: 'dry',
        tooth: 0.4,
        toothSize: 1.6,
        softness: 0.9,
        smudge: 0.2,
        toneCurve: RUBBED,
        reflectedLight: 0.4,
        ink: '#34343a',
        paper: '#fbfaf6',
      },
      outlines: { outlineWidth: 1.3, wobble: 1, tooth: 0.4, toothSize: 1.6, ink: '#34343a' },
      tonalArtMap: { style: 'hatching' },
    },
    charcoal: {
      material: {
        technique: 'anchored',
        sizedOnScreen: 1,
        anchorSpacing: 0.5,
        strokeWidth: 6,
        strokeRotation: Math.PI / 4,
        strokeLayers: 'single',
        medium: 'dry',
        tooth: 0.6,
        toothSize: 2,
        softness: 0.9,
        smudge: 0.5,
        toneCurve: RUBBED,
        reflectedLight: 0.3,
        ink: '#1d1a19',
        paper: '#e6dccb',
      },
      outlines: { outlineWidth: 4, wobble: 1, tooth: 0.6, toothSize: 2, ink: '#1d1a19' },
      tonalArtMap: { style: 'hatching' },
    },
    chalk: {
      material: {
        technique: 'anchored',
        sizedOnScreen: 1,
        anchorSpacing: 0.5,
        strokeWidth: 7,
        strokeRotation: 0,
        strokeLayers: 'single',
        medium: 'dry',
        tooth: 0.55,
        toothSize: 2,
        softness: 0.7,
        smudge: 0.25,
        toneCurve: CHALKED,
        reflectedLight: 0,
        ink: '#f4f1e6',
        paper: '#2f3a38',
      },
      outlines: { outlineWidth: 2.6, wobble: 1, tooth: 0.55, toothSize: 2, ink: '#f4f1e6' },
      tonalArtMap: { style: 'hatching' },
    },
  }) as const satisfies Record<string, HatchingPreset>;

/** The names of the presets. */
export type PresetName = keyof ReturnType<typeof makePresets>;

function frozen<Value>(value: Value): Value {
  if (typeof value === 'object' && value !== null) for (const part of Object.values(value)) frozen(part);
  return Object.freeze(value);
}

/**
 * The presets: looks to start from, each with material, outlines and map.
 *
 * ```ts
 * await applyHatching(gltf.scene, presets.engraving);
 * await applyHatching(gltf.scene, { ...presets.pen, material: { ...presets.pen.material, ink: 'navy' } });
 * ```
 *
 * They are made for lights whose intensities sum to π. Widths and distances are in CSS pixels; `scalePreset` adapts them to a print.
 */
export const presets: Readonly<Record<PresetName, HatchingPreset>> = /* @__PURE__ */ frozen(
  /* @__PURE__ */ makePresets(),
);
