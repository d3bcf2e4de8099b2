import { type Color, Material, type Texture } from 'three';
import { HatchingMaterial } from './HatchingMaterial.js';
import type { HatchingMaterialParameters } from './HatchingMaterialParameters.js';

/** Properties of three's own surface materials beyond the base class. Other materials may have them too. */
interface SurfaceMaterial extends Material {
  color?: Color;
  map?: Texture | null;
  alphaMap?: Texture | null;
  fog?: boolean;
  wireframe?: boolean;
  wireframeLinewidth?: number;
}

/**
 * A hatching material that replaces `source`, with its colour, maps (shared, not copied), opacity, sides, vertex
 * colours, depth, blending, stencil, clipping, fog, wireframe, name, visibility and user data.
 *
 * @param parameters override what is taken over from `source`
 */
export function hatchingMaterialFrom(source: Material, parameters: HatchingMaterialParameters): HatchingMaterial {
  const material = new HatchingMaterial();
  // Material.copy clones user data through JSON, which loses some values.
  Material.prototype.copy.call(material, Object.create(source, { userData: { value: {} } }));
  material.userData = { ...source.userData };
  // Shared, so that planes that move keep clipping.
  material.clippingPlanes = source.clippingPlanes;
  const { color, map, alphaMap, fog, wireframe, wireframeLinewidth } = source as SurfaceMaterial;
  if (color) material.color.copy(color);
  material.map = map ?? null;
  material.alphaMap = alphaMap ?? null;
  material.fog = fog ?? true;
  material.wireframe = wireframe ?? false;
  material.wireframeLinewidth = wireframeLinewidth ?? 1;
  material.setValues(parameters);
  return material;
}
