import { Color, type Texture } from 'three';
import type { HatchingNumber, HatchingOwner, HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { Hand } from '../strokes/hand/Hand.js';
import { checkNumber } from './checkNumber.js';
import { warn } from './diagnostics/warn.js';
import { fittedCurve, type ToneCurve } from './fitToneCurve.js';
import { checkHatchingMap, type HatchingMap, isVector2Like, isVector3Like } from './propertyValues.js';

/** How errors name the owners of properties. */
const OWNERS: Readonly<Record<HatchingOwner, string>> = {
  composition: 'HatchingComposition',
  perTriangle: 'HatchingMaterial.perTriangle',
  shadowMaterial: 'HatchingShadowMaterial',
};

/** The owner of a property, as errors name it. */
export function ownerOf(name: HatchingPropertyName): string {
  const { owner }: HatchingProperty = HATCHING_PROPERTIES[name];
  return owner ? OWNERS[owner] : 'HatchingMaterial';
}

/** The names of the properties of an owner. */
export function namesOfOwner(owner: HatchingOwner): readonly HatchingPropertyName[] {
  let names = ofOwners.get(owner);
  if (!names) {
    const all = Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
    names = all.filter((name) => (HATCHING_PROPERTIES[name] as HatchingProperty).owner === owner);
    ofOwners.set(owner, names);
  }
  return names;
}

const ofOwners = /* @__PURE__ */ new Map<HatchingOwner, readonly HatchingPropertyName[]>();

/** Those properties of an owner that an object has, with their values: a plain object, or an instance. */
export const ownedEntries = (owner: HatchingOwner, values: object): [HatchingPropertyName, unknown][] =>
  namesOfOwner(owner)
    .filter((name) => name in values)
    .map((name) => [name, (values as Readonly<Record<string, unknown>>)[name]]);

/**
 * Checks properties of an owner before any of them is set, and warns of others.
 *
 * @throws TypeError, RangeError or Error unless `values` is an object, and each of its values is of the right kind and in its range
 */
export function checkOwned(owner: HatchingOwner, values: unknown): void {
  if (typeof values !== 'object' || values === null || Array.isArray(values))
    throw new TypeError(`HatchingMaterial.${owner}: expected an object of its properties, such as ${EXAMPLES[owner]}.`);
  for (const [name, value] of ownedEntries(owner, values)) if (value !== undefined) checkValue(name, value);
  if (Object.getPrototypeOf(values) !== Object.prototype) return;
  for (const name of Object.keys(values))
    if (!namesOfOwner(owner).includes(name as HatchingPropertyName))
      warn(`${OWNERS[owner]}: "${name}" is no property of it.`);
}

const EXAMPLES: Readonly<Record<HatchingOwner, string>> = {
  composition: '{ vignette: 0.4 }',
  perTriangle: '{ sharpInk: true }',
  shadowMaterial: '{ shadowTone: 0.5 }',
};

/** @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range */
export function checkValue(name: HatchingPropertyName, value: unknown): void {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  switch (property.kind) {
    case 'number':
      numberOrWord(name, value, property);
      break;
    case 'choice':
    case 'switch':
      checkChoice(name, value);
      break;
    case 'color':
      checkColor(`${ownerOf(name)}.${name}`, value);
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
      break;
    case 'hand':
      checkHand(value);
  }
}

/** @throws TypeError unless `value` is null or can be a hand, whose strokes and numbers are checked when they are drawn */
export function checkHand(value: unknown): void {
  const { version, strokes, numbers } = Object(value) as Partial<Hand>;
  const isHand = version === 1 && Array.isArray(strokes) && strokes.length > 0 && typeof numbers === 'object';
  check('hand', value === null || isHand, 'a hand of version 1, as learnHand makes it, or null');
}

/** @throws TypeError unless `value` is null or a point */
export const checkPoint = (name: HatchingPropertyName, value: unknown): void =>
  check(name, value === null || isVector3Like(value), 'null, a THREE.Vector3 or an array of three finite numbers');

/**
 * Whether a property accepts this value, `null` or a word, instead of a number: because it is the default or has a meaning of its
 * own.
 */
export const isWord = (name: HatchingPropertyName, value: unknown): boolean =>
  (typeof value !== 'number' && value === HATCHING_DEFAULTS[name]) ||
  (HATCHING_PROPERTIES[name] as HatchingNumber).words?.includes(value as string) === true;

/** @throws RangeError unless `value` is a number in the property's range, or a word in place of one */
export function numberOrWord(
  name: HatchingPropertyName,
  value: unknown,
  { range, words = [] }: HatchingNumber,
): number | 'auto' | 'fit' {
  if (isWord(name, value)) return value as 'auto' | 'fit';
  const standard: unknown = HATCHING_DEFAULTS[name];
  return checkNumber(name, value, range, ownerOf(name), [
    ...words,
    ...(typeof standard === 'string' ? [standard] : []),
  ]);
}

/** @throws Error unless `value` is one of the property's choices; TypeError unless it is a boolean, for a property that is a switch */
export function checkChoice(name: HatchingPropertyName, value: unknown): void {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  if (property.kind === 'switch') check(name, typeof value === 'boolean', 'true or false');
  if (property.kind !== 'choice' || property.choices.includes(value as string)) return;
  if (value === 'auto' && property.defaultFor) return;
  throw new Error(
    `${ownerOf(name)}.${name}: "${String(value)}" is not known; use one of ${property.choices.join(', ')}.`,
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

function check(name: HatchingPropertyName, isRight: boolean, expected: string): void {
  if (!isRight) throw new TypeError(`${ownerOf(name)}.${name}: expected ${expected}.`);
}

function isColor(value: unknown): boolean {
  if (typeof value !== 'string') return Number.isFinite(value) || (value as Partial<Color> | null)?.isColor === true;
  if (/^\w+$/.test(value)) return Object.hasOwn(Color.NAMES, value.toLowerCase());
  // If three.js cannot parse a colour, it leaves the components unchanged, here NaN.
  const { r } = Object.assign(new Color(), { r: Number.NaN }).set(value);
  return Number.isFinite(r);
}
