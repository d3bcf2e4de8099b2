import { defaultOf } from './facts/defaultOf.js';
import type { HatchingPropertyName } from './facts/hatchingProperties.js';
import { PRESET_MATERIALS, type PresetName } from './facts/presetMaterials.js';
import type { HatchingMaterialParameters } from './HatchingMaterialParameters.js';

/** What was worked out for the first material of each preset. */
const resolved = /* @__PURE__ */ new Map<PresetName, HatchingMaterialParameters>();

/**
 * The parameters that a preset stands for: its own, and the defaults of those that only other presets name, so that nothing remains
 * of a preset that was set before.
 *
 * @throws RangeError if there is no preset of this name
 */
export function presetParameters(preset: PresetName): HatchingMaterialParameters {
  if (!Object.hasOwn(PRESET_MATERIALS, preset)) {
    throw new RangeError(
      `HatchingMaterial: there is no preset "${preset}". Use one of ${Object.keys(PRESET_MATERIALS).join(', ')}; of a preset of your own pass its material.`,
    );
  }
  const known = resolved.get(preset);
  if (known) return known;
  const own: HatchingMaterialParameters = PRESET_MATERIALS[preset];
  const named = new Set(Object.values(PRESET_MATERIALS).flatMap(Object.keys)) as Set<HatchingPropertyName>;
  const parameters: HatchingMaterialParameters = Object.fromEntries(
    [...named].map((name) => [name, own[name] ?? defaultOf(name, PRESET_MATERIALS[preset].technique)]),
  );
  resolved.set(preset, parameters);
  return parameters;
}
