import { Color, type MaterialParameters, type NormalMapTypes, type Texture } from 'three';
import type { HatchingNumber, HatchingProperty } from '../look/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from '../look/hatchingProperties.js';
import type { PresetName } from '../look/presetMaterials.js';
import { isDefault } from '../look/presetParameters.js';
import { isUsedBy } from '../look/queries.js';
import { checkNumber } from './checkNumber.js';
import { warn } from './diagnostics/warn.js';
import type { SceneExtent } from './fading/SceneExtent.js';
import { fittedCurve, type ToneCurve } from './fitToneCurve.js';
import type { HatchingMaterialOptions } from './HatchingMaterialProperties.js';
import { checkHatchingMap, type HatchingMap, isVector2Like, isVector3Like } from './propertyValues.js';

/** The parameters of `new HatchingMaterial()` and `setValues()`. */
export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    /**
     * The name of the preset to start from. The other parameters override it one by one; properties that the preset does not set have
     * their defaults.
     */
    preset?: PresetName | undefined;
    /** Defines of your own, added to those of the material. */
    defines?: Record<string, unknown> | undefined;
    /** The space of `normalMap`: `TangentSpaceNormalMap`, the default, or `ObjectSpaceNormalMap`. */
    normalMapType?: NormalMapTypes | undefined;
    /** The extent of the scene, relative to which `depthFade` measures depth. */
    extent?: SceneExtent | null | undefined;
    fog?: boolean | undefined;
    wireframe?: boolean | undefined;
    clipping?: boolean | undefined;
    lights?: boolean | undefined;
  };

/**
 * Checks parameters before any of them is set, so that a wrong one changes nothing. Parameters of three's `Material` are not checked.
 *
 * @throws TypeError, RangeError or Error naming the first property of the library whose value is of the wrong kind or out of its range
 */
export function checkValues(parameters: HatchingMaterialParameters): void {
  // An object read from JSON may have this as an own property, and three.js would set it as the prototype of the material.
  if (Object.hasOwn(parameters, '__proto__')) throw new TypeError('HatchingMaterial: "__proto__" is no parameter.');
  if (Object.hasOwn(parameters, 'material')) {
    throw new TypeError('HatchingMaterial: this is a whole preset. Pass its material: presets.pen.material.');
  }
  for (const [name, value] of Object.entries(parameters)) {
    // three.js itself warns of undefined values, and keeps the present ones.
    if (value !== undefined && Object.hasOwn(HATCHING_PROPERTIES, name))
      checkValue(name as HatchingPropertyName, value);
  }
}

function checkValue(name: HatchingPropertyName, value: unknown): void {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  switch (property.kind) {
    case 'number':
      if (!isWord(name, value)) checkNumber(name, value, property.range);
      break;
    case 'choice':
    case 'switch':
      checkChoice(name, value);
      break;
    case 'color':
      checkColor(`HatchingMaterial.${name}`, value);
      break;
    case 'texture':
      check(name, value === null || (value as Partial<Texture>).isTexture === true, 'a THREE.Texture or null');
      break;
    case 'vector2':
      check(name, isVector2Like(value), 'a THREE.Vector2 or an array of two finite numbers');
      break;
    case 'point':
      checkPoint(name, value);
      break;
    case 'curve':
      fittedCurve(value as ToneCurve);
      break;
    case 'tonalArtMap':
      checkHatchingMap(value as HatchingMap);
  }
}

/** @throws TypeError unless `value` is null or a point */
export const checkPoint = (name: HatchingPropertyName, value: unknown): void =>
  check(name, value === null || isVector3Like(value), 'null, a THREE.Vector3 or an array of three finite numbers');

/**
 * Whether a property accepts this value, `null` or `'auto'`, instead of a number: because it is the default or has a meaning of its
 * own.
 */
export const isWord = (name: HatchingPropertyName, value: unknown): boolean =>
  (typeof value !== 'number' && value === HATCHING_DEFAULTS[name]) ||
  (value === 'auto' && (HATCHING_PROPERTIES[name] as HatchingNumber).isAuto === true);

/** @throws Error unless `value` is one of the property's choices; TypeError unless it is a boolean, for a property that is a switch */
export function checkChoice(name: HatchingPropertyName, value: unknown): void {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  if (property.kind === 'switch') check(name, typeof value === 'boolean', 'true or false');
  if (property.kind !== 'choice' || property.choices.includes(value as string)) return;
  if (value === 'auto' && property.defaultFor) return;
  throw new Error(
    `HatchingMaterial.${name}: "${String(value)}" is not known; use one of ${property.choices.join(', ')}.`,
  );
}

/**
 * @param owner the property, as the error names it
 * @throws TypeError unless three.js knows `value` as a colour
 */
export function checkColor(owner: string, value: unknown): void {
  if (isColor(value)) return;
  throw new TypeError(`${owner}: expected a THREE.Color, a number such as 0xff0000, or a CSS colour such as 'navy'.`);
}

function check(name: string, isRight: boolean, expected: string): void {
  if (!isRight) throw new TypeError(`HatchingMaterial.${name}: expected ${expected}.`);
}

function isColor(value: unknown): boolean {
  if (typeof value !== 'string') return Number.isFinite(value) || (value as Partial<Color> | null)?.isColor === true;
  if (/^\w+$/.test(value)) return Object.hasOwn(Color.NAMES, value.toLowerCase());
  // If three.js cannot parse a colour, it leaves the components unchanged, here NaN.
  const { r } = Object.assign(new Color(), { r: Number.NaN }).set(value);
  return Number.isFinite(r);
}

const warned = new Set<string>();

/** Warns once of each parameter that is set but not used by the technique. */
export function warnOfUnused(parameters: HatchingMaterialParameters, technique: HatchingTechnique): void {
  for (const name of Object.keys(parameters)) {
    if (!Object.hasOwn(HATCHING_PROPERTIES, name)) continue;
    const property: HatchingProperty = HATCHING_PROPERTIES[name as HatchingPropertyName];
    // A map may be set for any technique: materials share it.
    if (property.kind === 'tonalArtMap') continue;
    const key = `${name} ${technique}`;
    if (isUsedBy(technique, property) || warned.has(key)) continue;
    if (isDefault(name as HatchingPropertyName, parameters[name as HatchingPropertyName], technique)) continue;
    warned.add(key);
    warn(
      `HatchingMaterial: "${name}" is not used by the technique "${technique}", only by ${property.techniques?.join(' and ')}.`,
    );
  }
}
