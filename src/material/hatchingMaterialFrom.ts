import { type Color, Material, type Texture } from 'three';
import { HatchingMaterial } from './HatchingMaterial.js';
import type { HatchingMaterialParameters } from './HatchingMaterialParameters.js';

/** What three's own surface materials have beside the base class, and a material of any kind may have. */
interface SurfaceMaterial extends Material {
  color?: Color;
  map?: Texture | null;
  alphaMap?: Texture | null;
  fog?: boolean;
  wireframe?: boolean;
  wireframeLinewidth?: number;
}

/**
 * A hatching material that takes the place of `source`: with its colour, maps (shared, not copied), opacity, sides, vertex
 * colours, depth, blending, stencil, clipping, fog, wireframe, name, visibility and user data.
 *
 * @param parameters what the material is to have of its own; they win
 */
export function hatchingMaterialFrom(source: Material, parameters: HatchingMaterialParameters): HatchingMaterial {
  const material = new HatchingMaterial();
  // Material's copy sends user data through JSON, which not everything survives.
  Material.prototype.copy.call(material, Object.create(source, { userData: { value: {} } }));
  material.userData = { ...source.userData };
  // Moved planes go on cutting, as with the source.
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
