import { type Color, Material, type NormalMapTypes, type Texture, type Vector2 } from 'three';
import { GLASS } from '../look/glass.js';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';

/** The properties of three's surface materials beyond those of `Material`. Other materials may have some of them. */
export interface SurfaceMaterial extends Material {
  color?: Color;
  map?: Texture | null;
  alphaMap?: Texture | null;
  normalMap?: Texture | null;
  normalMapType?: NormalMapTypes;
  normalScale?: Vector2;
  bumpMap?: Texture | null;
  bumpScale?: number;
  flatShading?: boolean;
  aoMap?: Texture | null;
  aoMapIntensity?: number;
  lightMap?: Texture | null;
  lightMapIntensity?: number;
  emissive?: Color;
  emissiveIntensity?: number;
  emissiveMap?: Texture | null;
  fog?: boolean;
  wireframe?: boolean;
  wireframeLinewidth?: number;
  transmission?: number;
  transmissionMap?: Texture | null;
}

/** The properties of surfaces that a hatching material has under the same name, and whose values it shares. */
export const surfaceProperties = [
  'map',
  'alphaMap',
  'normalMap',
  'normalMapType',
  'bumpMap',
  'bumpScale',
  'flatShading',
  'aoMap',
  'aoMapIntensity',
  'lightMap',
  'lightMapIntensity',
  'emissiveIntensity',
  'emissiveMap',
] as const satisfies (keyof SurfaceMaterial)[];

/**
 * Turns a new hatching material into the one that replaces `source`. It takes over colour, maps and their settings (the textures are
 * shared, not copied), emission, opacity, sides, vertex colours, depth, blending, stencil, clipping, fog, wireframe, name, visibility
 * and user data. A material with `transmission` is drawn as glass, which hides nothing behind it.
 *
 * @param parameters override the values of `source`
 */
export function hatchingMaterialFrom(
  source: Material,
  parameters: HatchingMaterialParameters,
  material: HatchingMaterial,
): HatchingMaterial {
  // Material.copy clones user data through JSON, which loses some values.
  Material.prototype.copy.call(material, Object.create(source, { userData: { value: {} } }));
  material.toneMapped = false;
  material.userData = { ...source.userData };
  // The planes are shared, so that moving them keeps clipping both materials.
  material.clippingPlanes = source.clippingPlanes;
  const surface: SurfaceMaterial = source;
  const { color, emissive, normalScale, fog, wireframe, wireframeLinewidth } = surface;
  if (color) material.color.copy(color);
  if (emissive) material.emissive.copy(emissive);
  if (normalScale) material.normalScale.copy(normalScale);
  for (const name of surfaceProperties) {
    if (surface[name] !== undefined) Object.assign(material, { [name]: acceptable(name, surface) });
  }
  material.fog = fog ?? true;
  material.wireframe = wireframe ?? false;
  material.wireframeLinewidth = wireframeLinewidth ?? 1;
  material.setValues(parameters);
  const { transmission = 0, transmissionMap } = surface;
  if (transmission > 0 && !transmissionMap)
    Object.assign(
      material,
      GLASS,
      { paperOpacity: 1 - Math.min(transmission, 1) },
      parameters.paperOpacity !== undefined && { paperOpacity: parameters.paperOpacity },
    );
  return material;
}

const warned = new Set<string>();

/**
 * The value of a property in the range of a hatching material. three.js also draws with numbers out of range, such as an
 * `emissiveIntensity` of −1: they are clamped, and NaN becomes the default. One warning reports it.
 */
export function acceptable(name: keyof SurfaceMaterial, source: SurfaceMaterial): unknown {
  const value = source[name];
  const property = Object.hasOwn(HATCHING_PROPERTIES, name)
    ? (HATCHING_PROPERTIES[name as HatchingPropertyName] as HatchingProperty)
    : null;
  if (property?.kind === 'switch') return Boolean(value);
  if (property?.kind !== 'number') return value;
  const { from = -Infinity, to = Infinity } = property.range ?? {};
  const taken = Number.isFinite(value)
    ? Math.min(Math.max(value as number, from), to)
    : HATCHING_DEFAULTS[name as HatchingPropertyName];
  if (taken !== value && !warned.has(name)) {
    warned.add(name);
    console.warn(
      `applyHatching: ${name} is ${value} on the ${source.type}${source.name ? ` "${source.name}"` : ''}, and is hatched as ${taken}.`,
    );
  }
  return taken;
}
