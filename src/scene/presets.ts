import { HATCHING_DEFAULTS } from '../look/hatchingProperties.js';
import { frozen, PRESET_MATERIALS, type PresetName } from '../look/presetMaterials.js';
import { needsMap } from '../look/queries.js';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { MapDrawing } from '../strokes/tamImages/hatchImageOptions.js';

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

/** The outlines of the presets. */
const makeOutlines = (): Record<PresetName, HatchingPreset['outlines']> => ({
  pen: { outlineWidth: 1.8, wobble: 1, ink: BLACK },
  crossHatching: { outlineWidth: 1.4, wobble: 1, ink: BLACK },
  engraving: { outlineWidth: 1.5, ink: BLACK },
  banknote: { outlineWidth: 0.9, ink: '#18332f' },
  technical: {
    outlineWidth: 1.6,
    innerContours: 0.6,
    creases: 0.6,
    materialBorders: 0.6,
    lostEdges: 0,
    accents: 0,
    shadeWeights: [1, 1],
    ink: BLACK,
  },
  woodcut: { outlineWidth: 3.2, ink: '#120e0a' },
  stipple: { outlineWidth: 1, ink: BLACK },
  pencil: { outlineWidth: 1.7, wobble: 1, tooth: 0.35, toothSize: 1.6, ink: '#34343a' },
  charcoal: { outlineWidth: 4.5, wobble: 1, tooth: 0.5, toothSize: 2, ink: '#1d1a19' },
  // Chalk draws the light on dark paper, so its contours must not be lost there.
  chalk: { outlineWidth: 3.4, lostEdges: 0, wobble: 1, tooth: 0.5, toothSize: 2, ink: '#f4f1e6' },
});

/** The map that a material names, or its default map. */
function mapOf(material: HatchingMaterialParameters): HatchingPreset['tonalArtMap'] {
  if (!needsMap(material)) return null;
  return { style: (material.tonalArtMap ?? HATCHING_DEFAULTS.tonalArtMap) as StrokeStyleName };
}

function makePresets(): Record<PresetName, HatchingPreset> {
  const entries = Object.entries(makeOutlines()).map(([name, outlines]) => {
    const material: HatchingMaterialParameters = PRESET_MATERIALS[name as PresetName];
    return [name, { material, outlines, tonalArtMap: mapOf(material) }];
  });
  return Object.fromEntries(entries);
}

/**
 * The presets: looks to start from, each with material, outlines and map.
 *
 * ```ts
 * await applyHatching(gltf.scene, presets.engraving);
 * await applyHatching(gltf.scene, { ...presets.pen, material: { ...presets.pen.material, ink: 'navy' } });
 * ```
 *
 * They suit lights whose intensities sum to π. Widths and distances are in CSS pixels; `scalePreset` adapts them to a print.
 */
export const presets: Readonly<Record<PresetName, HatchingPreset>> = /* @__PURE__ */ frozen(
  /* @__PURE__ */ makePresets(),
);
