import type { OutlineOptions } from '../geometry/prepareHatchingGeometry.js';
import { frozen, PRESET_MATERIALS, type PresetName } from '../material/facts/presetMaterials.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import type { HatchingOutlineParameters } from '../outlines/HatchingOutlineMaterial.js';
import type { MapDrawing } from '../tam/TonalArtMap.js';

export type { PresetName };

/** A complete look: the material, outlines and tonal art map, in the form of the options of `applyHatching`. */
export interface HatchingPreset {
  /** The parameters of the material, including ink and paper. */
  readonly material: Readonly<HatchingMaterialParameters>;
  /** The options and parameters of the outlines. */
  readonly outlines: Readonly<OutlineOptions & HatchingOutlineParameters>;
  /** The options of `TonalArtMap.generate`; `null` if the preset needs no map. */
  readonly tonalArtMap: Readonly<MapDrawing> | null;
}

const BLACK = '#1c1a17';

const makePresets = () =>
  ({
    pen: {
      material: PRESET_MATERIALS.pen,
      outlines: { outlineWidth: 1.8, wobble: 1, ink: BLACK },
      tonalArtMap: { style: 'hatching' },
    },
    crossHatching: {
      material: PRESET_MATERIALS.crossHatching,
      outlines: { outlineWidth: 1.4, wobble: 1, ink: BLACK },
      tonalArtMap: { style: 'contours' },
    },
    engraving: {
      material: PRESET_MATERIALS.engraving,
      outlines: { outlineWidth: 1.5, ink: BLACK },
      tonalArtMap: null,
    },
    technical: {
      material: PRESET_MATERIALS.technical,
      outlines: { outlineWidth: 1.6, creases: 1, materialBorders: 1, shadeWeights: [1, 1], ink: BLACK },
      tonalArtMap: null,
    },
    woodcut: {
      material: PRESET_MATERIALS.woodcut,
      outlines: { outlineWidth: 3.2, ink: '#120e0a' },
      tonalArtMap: null,
    },
    stipple: {
      material: PRESET_MATERIALS.stipple,
      outlines: { outlineWidth: 1, ink: BLACK },
      tonalArtMap: null,
    },
    pencil: {
      material: PRESET_MATERIALS.pencil,
      outlines: { outlineWidth: 1.3, wobble: 1, tooth: 0.4, toothSize: 1.6, ink: '#34343a' },
      tonalArtMap: { style: 'hatching' },
    },
    charcoal: {
      material: PRESET_MATERIALS.charcoal,
      outlines: { outlineWidth: 4, wobble: 1, tooth: 0.6, toothSize: 2, ink: '#1d1a19' },
      tonalArtMap: { style: 'hatching' },
    },
    chalk: {
      material: PRESET_MATERIALS.chalk,
      outlines: { outlineWidth: 2.6, wobble: 1, tooth: 0.55, toothSize: 2, ink: '#f4f1e6' },
      tonalArtMap: { style: 'hatching' },
    },
  }) as const satisfies Record<PresetName, HatchingPreset>;

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
