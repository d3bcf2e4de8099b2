import type { HatchingProperty, TechniqueFamily } from './HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  HATCHING_TECHNIQUES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from './hatchingProperties.js';
import { PRESET_MATERIALS, type PresetName } from './presetMaterials.js';

/** Parameters of a material, by name. */
type Values = Readonly<Partial<Record<HatchingPropertyName | 'composition', unknown>>>;

/** The parameters of each preset, computed for its first material. */
const resolved = /* @__PURE__ */ new Map<PresetName, Values>();

/**
 * Expands the preset of parameters; parameters given beside it override it. Allocates nothing where there is no preset, as in a material.
 *
 * @throws RangeError if there is no preset of this name
 */
export function spelledOut<Parameters extends { readonly preset?: PresetName | undefined }>(
  given: Parameters,
): Parameters {
  if (!Object.hasOwn(given, 'preset')) return given;
  const { preset, ...own } = given;
  return (preset === undefined ? own : mergedParameters(presetParameters(preset), own)) as Parameters;
}

/**
 * Parameters overridden by others one by one, and so are the numbers of a composition that is given as a plain object. An instance replaces
 * it as a whole.
 */
export function mergedParameters<Base extends object, Own extends object>(base: Base, own: Own): Base & Own {
  const [{ composition: ofBase }, { composition: ofOwn }] = [base, own].map(Object) as WithComposition[];
  const merged = { ...base, ...own };
  return ofBase && ofOwn && !ofOwn.isHatchingComposition && !ofBase.isHatchingComposition
    ? { ...merged, composition: { ...ofBase, ...ofOwn } }
    : merged;
}

interface WithComposition {
  readonly composition?: { readonly isHatchingComposition?: boolean };
}

/**
 * The parameters of a preset: its own, and the defaults of those that only other presets set, so that nothing remains of an earlier preset.
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

/** The members of three.js colours and vectors that are used here. */
interface ThreeValue {
  isColor?: boolean;
  isVector2?: boolean;
  isVector3?: boolean;
  getHex(): number;
  toArray(): number[];
}

/** A value in the form of its default: colours as numbers, vectors as arrays. */
export function plainValue(value: unknown): unknown {
  const known = value as ThreeValue | null | undefined;
  if (known?.isColor) return known.getHex();
  if (known?.isVector2 || known?.isVector3) return known.toArray();
  return value;
}

/** The family of a technique. */
export const familyOf = (technique: HatchingTechnique): TechniqueFamily => HATCHING_TECHNIQUES[technique].family;

/** The default of a property under a technique. Colours are numbers, vectors arrays. */
export function defaultOf(
  name: HatchingPropertyName,
  technique: HatchingTechnique = HATCHING_DEFAULTS.technique,
): unknown {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  const ofTechnique = 'defaultFor' in property ? property.defaultFor?.[familyOf(technique)] : undefined;
  return ofTechnique ?? HATCHING_DEFAULTS[name];
}

/** Whether a value, plain or not, is the default of a property. */
export const isDefault = (name: HatchingPropertyName, value: unknown, technique: HatchingTechnique): boolean =>
  JSON.stringify(plainValue(value)) === JSON.stringify(defaultOf(name, technique));
