import type { Material, Mesh } from 'three';
import { deforms } from './bindVertices.js';
import type { HatchingMaterial } from './HatchingMaterial.js';
import type { HatchingMaterialParameters } from './HatchingMaterialOptions.js';
import { hatchingMaterialFrom } from './hatchingMaterialFrom.js';
import { isSurface } from './surfaceMeshes.js';

/** Scales that differ by less than rounding does are one. */
const SCALE_DIGITS = 6;

/** Whether a material hatches already. */
export const isHatching = (material: Material): material is HatchingMaterial => 'isHatchingMaterial' in material;

/**
 * The hatching materials of a scene: one for every material it had and every scale of the meshes that wear it; and one more
 * for meshes that deform, whose program is another.
 */
export class MaterialReplacer {
  readonly materials: HatchingMaterial[] = [];
  /** By source, scale and whether the mesh deforms. */
  private readonly made = new Map<string, HatchingMaterial>();
  /** Scales of the materials whose parameters do not tell the size of their strokes. */
  private readonly scales = new Map<HatchingMaterial, number>();

  constructor(
    private readonly parameters:
      | HatchingMaterialParameters
      | ((source: Material, mesh: Mesh) => HatchingMaterialParameters),
  ) {}

  /**
   * What a mesh is to wear in the place of its material or materials, made when first asked for.
   *
   * @param scale world units per unit of the mesh's object space
   */
  materialFor(mesh: Mesh, scale: number): Material | Material[] {
    const replace = (source: Material): Material =>
      isSurface(source) && !isHatching(source) ? this.replacing(source, mesh, scale) : source;
    return Array.isArray(mesh.material) ? mesh.material.map(replace) : replace(mesh.material);
  }

  /** Gives the strokes one size in the world, on all materials that have none of their own. */
  sizeStrokes(tilesPerWorldUnit: number): void {
    for (const [material, scale] of this.scales) material.strokeScale = tilesPerWorldUnit * scale;
  }

  private replacing(source: Material, mesh: Mesh, scale: number): HatchingMaterial {
    const key = `${source.uuid} ${scale.toPrecision(SCALE_DIGITS)} ${deforms(mesh.geometry, mesh)}`;
    let material = this.made.get(key);
    if (!material) {
      const parameters = typeof this.parameters === 'function' ? this.parameters(source, mesh) : this.parameters;
      material = hatchingMaterialFrom(source, parameters);
      this.made.set(key, material);
      this.materials.push(material);
      if (parameters.strokeScale === undefined) this.scales.set(material, scale);
    }
    return material;
  }
}
