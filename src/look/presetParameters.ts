import { defaultOf } from './defaultOf.js';
import type { HatchingPropertyName } from './hatchingProperties.js';
import { PRESET_MATERIALS, type PresetName } from './presetMaterials.js';

/** Values of properties, by name. */
type Values = Readonly<Partial<Record<HatchingPropertyName, unknown>>>;

/** What was worked out for the first material of each preset. */
const resolved = /* @__PURE__ */ new Map<PresetName, Values>();

/**
 * Parameters with those that their preset stands for; what they name themselves overrides it. Allocates nothing for what has no preset,
 * such as a material.
 *
 * @throws RangeError if there is no preset of this name
 */
export function spelledOut<Parameters extends { readonly preset?: PresetName | undefined }>(
  given: Parameters,
): Parameters {
  if (!Object.hasOwn(given, 'preset')) return given;
  const { preset, ...own } = given;
  return (preset === undefined ? own : { ...presetParameters(preset), ...own }) as Parameters;
}

/**
 * The parameters that a preset stands for: its own, and the defaults of those that only other presets name, so that nothing remains
 * of a preset that was set before.
 *
 * @throws RangeError if there is no preset of this name
 */
function presetParameters(preset: PresetName): Values {
  if (!Object.hasOwn(PRESET_MATERIALS, preset)) {
    throw new RangeError(
      `HatchingMaterial: there is no preset "${preset}". Use one of ${Object.keys(PRESET_MATERIALS).join(', ')}; of a preset of your own pass its material.`,
    );
  }
  const known = resolved.get(preset);
  if (known) return known;
  const own: Values = PRESET_MATERIALS[preset];
  const named = new Set(Object.values(PRESET_MATERIALS).flatMap(Object.keys)) as Set<HatchingPropertyName>;
  const parameters: Values = Object.fromEntries(
    [...named].map((name) => [name, own[name] ?? defaultOf(name, PRESET_MATERIALS[preset].technique)]),
  );
  resolved.set(preset, parameters);
  return parameters;
}
