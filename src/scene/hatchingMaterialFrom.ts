import { type Color, Material, type NormalMapTypes, type Texture, type Vector2 } from 'three';
import { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';

/** The properties that the surface materials of three.js have beyond `Material`. Other materials may have them too. */
interface SurfaceMaterial extends Material {
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
}

const plainProperties = [
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
 * Creates the hatching material that replaces `source`. It takes over colour, maps and their settings (the textures are shared,
 * not copied), emission, opacity, sides, vertex colours, depth, blending, stencil, clipping, fog, wireframe, name, visibility and
 * user data.
 *
 * @param parameters override what is taken over from `source`
 */
export function hatchingMaterialFrom(source: Material, parameters: HatchingMaterialParameters): HatchingMaterial {
  const material = new HatchingMaterial();
  // Material.copy clones user data through JSON, which loses some values.
  Material.prototype.copy.call(material, Object.create(source, { userData: { value: {} } }));
  material.userData = { ...source.userData };
  // The planes are shared, so that moving them keeps clipping both materials.
  material.clippingPlanes = source.clippingPlanes;
  const surface: SurfaceMaterial = source;
  const { color, emissive, normalScale, fog, wireframe, wireframeLinewidth } = surface;
  if (color) material.color.copy(color);
  if (emissive) material.emissive.copy(emissive);
  if (normalScale) material.normalScale.copy(normalScale);
  for (const name of plainProperties) {
    if (surface[name] !== undefined) Object.assign(material, { [name]: surface[name] });
  }
  material.fog = fog ?? true;
  material.wireframe = wireframe ?? false;
  material.wireframeLinewidth = wireframeLinewidth ?? 1;
  material.setValues(parameters);
  return material;
}
