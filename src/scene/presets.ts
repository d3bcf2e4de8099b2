import { HATCHING_DEFAULTS } from '../look/hatchingProperties.js';
import { frozen, PRESET_MATERIALS, PRESET_SHADOWS, type PresetName } from '../look/presetMaterials.js';
import { mergedParameters } from '../look/presetParameters.js';
import { needsMap } from '../look/queries.js';
import type { HatchingMaterialParameters } from '../material/checkValues.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { ApplyHatchingOptions, HatchingPreset } from './ApplyHatchingOptions.js';

export type { HatchingPreset, PresetName };

const BLACK = '#1c1a17';

/** The outlines of the presets. */
const makeOutlines = (): Record<PresetName, HatchingPreset['outlines']> => ({
  pen: { outlineWidth: 1.8, wobble: 1, ink: BLACK },
  crossHatching: { outlineWidth: 1.4, wobble: 1, ink: BLACK },
  engraving: { outlineWidth: 1.5, ink: BLACK },
  banknote: { outlineWidth: 0.9, ink: '#18332f' },
  technical: {
    outlineWidth: 1.6,
    weights: { innerContours: 0.6, creases: 0.6, materialBorders: 0.6, intersections: 0.6, lit: 1, shade: 1 },
    lostEdges: 0,
    accents: 0,
    ink: BLACK,
  },
  woodcut: { outlineWidth: 3.2, ink: '#120e0a' },
  stipple: { outlineWidth: 1, ink: BLACK },
  pencil: { outlineWidth: 1.7, wobble: 1, paperGrain: 0.35, paperGrainSize: 1.6, ink: '#34343a' },
  charcoal: { outlineWidth: 4.5, wobble: 1, paperGrain: 0.5, paperGrainSize: 2, ink: '#1d1a19' },
  // Chalk draws the light on dark paper, so its contours must not be lost there.
  chalk: { outlineWidth: 3.4, lostEdges: 0, wobble: 1, paperGrain: 0.5, paperGrainSize: 2, ink: '#f4f1e6' },
});

/** The map that a material names, or its default map. */
function mapOf(material: HatchingMaterialParameters): HatchingPreset['tonalArtMap'] {
  if (!needsMap(material)) return null;
  return { style: (material.tonalArtMap ?? HATCHING_DEFAULTS.tonalArtMap) as StrokeStyleName };
}

function makePresets(): Record<PresetName, HatchingPreset> {
  const entries = Object.entries(makeOutlines()).map(([name, outlines]) => {
    const material: HatchingMaterialParameters = PRESET_MATERIALS[name as PresetName];
    const shadow = PRESET_SHADOWS[name as PresetName];
    return [name, { material, outlines, ...(shadow && { shadow }), tonalArtMap: mapOf(material) }];
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

/**
 * The options of `applyHatching` for a preset, overridden by your own options. Parameters of the material and of the outlines override
 * those of the preset one by one, all other options as a whole. `outlines: false` leaves out the outlines of the preset, `outlines:
 * true` keeps them.
 *
 * @param preset the name of a preset, or a preset of your own
 * @throws RangeError if there is no preset of this name
 */
export function withPreset(
  preset: PresetName | HatchingPreset,
  { preset: _preset, ...options }: ApplyHatchingOptions = {},
): ApplyHatchingOptions {
  const { material, outlines, tonalArtMap } = presetOf(preset);
  const { material: own = {}, outlines: ownOutlines = true } = options;
  const namesMap = typeof own === 'object' && own?.tonalArtMap !== undefined;
  // A preset with `tonalArtMap: null` needs no map. If your options change its technique to one that does, it gets the default map.
  const ofPreset = tonalArtMap ?? undefined;
  return {
    ...options,
    material:
      typeof own === 'function'
        ? (...args) => mergedParameters(material, own(...args))
        : mergedParameters(material, own),
    outlines:
      typeof ownOutlines === 'object' && ownOutlines !== null
        ? overridden(outlines, ownOutlines)
        : ownOutlines && outlines,
    tonalArtMap: options.tonalArtMap === undefined && !namesMap ? ofPreset : options.tonalArtMap,
  };
}

/** The outlines of a preset with your own options over them, weight by weight. */
function overridden(outlines: HatchingPreset['outlines'], own: HatchingPreset['outlines']): HatchingPreset['outlines'] {
  const hasBoth = outlines.weights && typeof own.weights === 'object' && own.weights !== null;
  return { ...outlines, ...own, ...(hasBoth && { weights: { ...outlines.weights, ...own.weights } }) };
}

function presetOf(preset: PresetName | HatchingPreset): HatchingPreset {
  if (typeof preset === 'object' && preset !== null) return preset;
  if (Object.hasOwn(presets, preset)) return presets[preset];
  throw new RangeError(
    `applyHatching: there is no preset "${preset}". Use one of ${Object.keys(presets).join(', ')}, or pass a preset of your own.`,
  );
}
