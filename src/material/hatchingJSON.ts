import { Material, Plane, type Texture, Vector2, Vector3 } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName, type PropertyNameOf } from '../look/hatchingProperties.js';
import { isDefault, plainValue } from '../look/presetParameters.js';
import { givenValue, hasOwner } from '../look/queries.js';
import { ownedEntries } from './checkProperty.js';
import type { HatchingMaterialParameters } from './checkValues.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { isTonalArtMap } from './propertyValues.js';

/** The JSON that three.js writes of any material, and the hatching properties that are not at their defaults. */
export type HatchingMaterialJSON = ReturnType<Material['toJSON']>;

/**
 * The properties of a material that are not at their defaults, as JSON: colours as numbers, vectors as arrays. Textures are written by
 * three's own `Material.toJSON`. A tonal art map is left out, but the name of its style is kept.
 */
export function propertiesToJSON(material: HatchingMaterialProperties): Record<string, unknown> {
  const json: Record<string, unknown> = {};
  for (const [key, property] of Object.entries<HatchingProperty>(HATCHING_PROPERTIES)) {
    const name = key as HatchingPropertyName;
    if (property.kind === 'texture' || !hasOwner(material, property)) continue;
    const value = plainValue(givenValue(material, name));
    if (isTonalArtMap(value) || isDefault(name, value, material.technique)) continue;
    const { owner } = property;
    if (owner === 'composition' || owner === 'perTriangle') json[owner] = { ...Object(json[owner]), [name]: value };
    else json[name] = value;
  }
  return json;
}

/**
 * Sets on a material what `toJSON` wrote. three.js writes every property by its name, so none of its loaders, which differ between
 * versions, is needed. Textures are looked up by their uuid; missing ones are left out. The JSON may come from anywhere: unknown
 * properties are ignored, and nothing is set if a value is of the wrong kind.
 */
export function setFromJSON(
  material: HatchingMaterialProperties,
  json: HatchingMaterialJSON,
  textures: Readonly<Record<string, Texture>>,
): void {
  checkRecord('what it is given', json);
  const values: Record<string, unknown> = {};
  const plain = plainProperties();
  for (const [name, value] of Object.entries(json)) {
    if (name === 'clippingPlanes') values[name] = planesFrom(value);
    else if (name === 'composition' || name === 'perTriangle') {
      checkRecord(name, value);
      values[name] = Object.fromEntries(ownedEntries(name, value as object));
    } else if (isOwn(material, name)) {
      const { kind } = HATCHING_PROPERTIES[name];
      if (kind === 'texture') values[name] = textureFrom(name, value, textures);
      else values[name] = kind === 'vector2' && Array.isArray(value) ? new Vector2().fromArray(value) : value;
    } else if (plain.has(name)) {
      const known = plain.get(name);
      const expected = known === null ? 'number' : typeof known;
      check(name, typeof value === expected || (known === null && value === null), value, expected);
      values[name] = value;
    }
  }
  const { uuid, userData } = json;
  check('uuid', uuid === undefined || typeof uuid === 'string', uuid, 'string');
  if (userData !== undefined) checkRecord('userData', userData);
  material.setValues(values as HatchingMaterialParameters);
  if (uuid !== undefined) Object.assign(material, { uuid });
  if (userData !== undefined) material.userData = userData;
}

/** Whether a material itself has a property of the table. */
function isOwn(material: HatchingMaterialProperties, name: string): name is PropertyNameOf<undefined> {
  if (!Object.hasOwn(HATCHING_PROPERTIES, name)) return false;
  const property: HatchingProperty = HATCHING_PROPERTIES[name as HatchingPropertyName];
  return property.owner === undefined || (property.owner === 'shadowMaterial' && hasOwner(material, property));
}

/** Names of properties that identify a material, and the version that three.js counts up. */
const FIXED = /^(is[A-Z]|_|uuid$|type$|version$)/;

/** Properties outside the table whose JSON is a plain value, each with an example value. Most are properties of every material. */
function plainProperties(): Map<string, unknown> {
  const { blendColor, ...others } = new Material();
  const properties = {
    ...others,
    ...{ alphaTest: 0, blendColor: 0, fog: true, normalMapType: 0 },
    ...{ wireframe: false, wireframeLinewidth: 1 },
  };
  return new Map(
    Object.entries(properties).filter(
      ([name, value]) =>
        !FIXED.test(name) && (value === null || ['string', 'number', 'boolean'].includes(typeof value)),
    ),
  );
}

function textureFrom(name: string, uuid: unknown, textures: Readonly<Record<string, Texture>>): Texture | null {
  check(name, uuid === null || typeof uuid === 'string', uuid, 'uuid of a texture');
  return Object.hasOwn(textures, String(uuid)) ? textures[String(uuid)] : null;
}

function planesFrom(value: unknown): Plane[] {
  const planes = Array.isArray(value) ? value : [undefined];
  return planes.map((plane) => {
    const numbers: unknown[] = [...(Array.isArray(plane?.normal) ? plane.normal : []), plane?.constant];
    check('clippingPlanes', numbers.length === 4 && numbers.every(Number.isFinite), value, 'list of planes');
    const [x, y, z, constant] = numbers as number[];
    return new Plane(new Vector3(x, y, z), constant);
  });
}

function checkRecord(name: string, value: unknown): void {
  check(name, typeof value === 'object' && value !== null && !Array.isArray(value), value, 'JSON object');
}

function check(name: string, isRight: boolean, value: unknown, expected: string): void {
  if (isRight) return;
  throw new TypeError(`HatchingMaterial.fromJSON: ${name} is ${JSON.stringify(value)}, but must be a ${expected}.`);
}
