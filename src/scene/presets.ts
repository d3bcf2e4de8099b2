import type { LineOptions } from '../geometry/prepareHatchingGeometry.js';
import type { HatchingLineParameters } from '../lines/HatchingLineMaterial.js';
import type { ToneCurve } from '../material/fitToneCurve.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import type { MapDrawing } from '../tam/TonalArtMap.js';

/** Everything that makes a look: strokes, lines and map, as `applyHatching` takes them. */
export interface HatchingPreset {
  /** Parameters of the material, its ink and paper among them. */
  readonly material: Readonly<HatchingMaterialParameters>;
  /** The lines that suit it. */
  readonly lines: Readonly<LineOptions & HatchingLineParameters>;
  /** What `TonalArtMap.generate` draws for it; `null` if it needs no map. */
  readonly tonalArtMap: Readonly<MapDrawing> | null;
}

/** The names of the presets. */
export type PresetName =
  | 'pen'
  | 'crossHatching'
  | 'engraving'
  | 'technical'
  | 'woodcut'
  | 'stipple'
  | 'pencil'
  | 'charcoal';

/** Leaves lights blank and the deepest shade open, as printed line drawings do: much paper, and ink where it counts. */
const PRINTED: ToneCurve = [
  [0, 0],
  [0.15, 0],
  [0.3, 0.06],
  [0.45, 0.22],
  [0.6, 0.45],
  [0.75, 0.69],
  [0.9, 0.87],
  [1, 0.93],
];

const BLACK = '#1c1a17';
const WHITE = '#f7f3e8';

const makePresets = () =>
  ({
    pen: {
      material: {
        technique: 'anchored',
        screenConstancy: 1,
        strokeWidth: 1.5,
        strokeRotation: Math.PI / 2,
        toneCurve: PRINTED,
        reflectedLight: 0.3,
        ink: BLACK,
        paper: WHITE,
      },
      lines: { lineWidth: 1.8, wobble: 0.5, ink: BLACK },
      tonalArtMap: { style: 'hatching' },
    },
    crossHatching: {
      material: {
        technique: 'anchored',
        screenConstancy: 1,
        strokeWidth: 1.3,
        strokeRotation: Math.PI / 4,
        toneCurve: PRINTED,
        reflectedLight: 0.2,
        ink: BLACK,
        paper: WHITE,
      },
      lines: { lineWidth: 1.4, wobble: 0.5, ink: BLACK },
      tonalArtMap: { style: 'crossHatching' },
    },
    engraving: {
      material: {
        technique: 'engraved',
        screenConstancy: 1,
        lineField: 'light',
        lineSpacing: 4.5,
        crossFrom: 0.52,
        crossAngle: Math.PI / 3,
        handmade: 0.4,
        toneCurve: PRINTED,
        reflectedLight: 0.25,
        ink: BLACK,
        paper: WHITE,
      },
      lines: { lineWidth: 1.5, ink: BLACK },
      tonalArtMap: null,
    },
    technical: {
      material: {
        technique: 'engraved',
        screenConstancy: 1,
        lineField: 'y',
        lineSpacing: 5,
        crossFrom: 1,
        handmade: 0,
        toneCurve: PRINTED,
        reflectedLight: 0.25,
        ink: BLACK,
        paper: WHITE,
      },
      lines: { lineWidth: 1.6, creases: 1, materialBorders: 1, shadeWeights: [1, 1], ink: BLACK },
      tonalArtMap: null,
    },
    woodcut: {
      material: {
        technique: 'anchored',
        screenConstancy: 1,
        anchorSpacing: 0.6,
        strokeWidth: 4.4,
        strokeRotation: 0,
        toneCurve: PRINTED,
        reflectedLight: 0.19,
        ink: '#120e0a',
        paper: '#ece0c4',
      },
      lines: { lineWidth: 3, ink: '#120e0a' },
      tonalArtMap: { style: 'woodcut' },
    },
    stipple: {
      material: {
        technique: 'anchored',
        screenConstancy: 1,
        strokeWidth: 2.2,
        toneCurve: PRINTED,
        reflectedLight: 0.36,
        ink: BLACK,
        paper: WHITE,
      },
      lines: { lineWidth: 1, ink: BLACK },
      tonalArtMap: { style: 'stippling' },
    },
    pencil: {
      material: {
        technique: 'anchored',
        screenConstancy: 1,
        strokeWidth: 1.3,
        edgePixels: 2,
        strokeRotation: Math.PI / 2,
        reflectedLight: 0.4,
        ink: '#4b4a50',
        paper: '#fbfaf6',
      },
      lines: { lineWidth: 1.5, wobble: 1, ink: '#4b4a50' },
      tonalArtMap: { style: 'pencil' },
    },
    charcoal: {
      material: {
        technique: 'anchored',
        screenConstancy: 1,
        strokeWidth: 2.6,
        strokeRotation: Math.PI / 2,
        reflectedLight: 0.3,
        ink: '#24211f',
        paper: '#efe9dc',
      },
      lines: { lineWidth: 3, wobble: 1, ink: '#24211f' },
      tonalArtMap: { style: 'charcoal' },
    },
  }) as const satisfies Record<PresetName, HatchingPreset>;

export const presets: Readonly<Record<PresetName, HatchingPreset>> = /* @__PURE__ */ makePresets();
