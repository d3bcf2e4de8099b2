import type { Material, Mesh } from 'three';
import { deforms } from '../material/deformation/canDeform.js';
import type { SceneExtent } from '../material/fading/SceneExtent.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import { hatchingMaterialFrom } from './hatchingMaterialFrom.js';
import { isReplaced } from './leftAlone.js';
import { MaterialFollower } from './MaterialFollower.js';

/** The number of digits in which equal scales agree; further ones may differ by rounding. */
const SCALE_DIGITS = 6;

/**
 * Makes the hatching materials of a scene: one for each source material and scale of the meshes that use it. Meshes that deform get
 * materials of their own, because they need another program.
 */
export class MaterialReplacer {
  readonly materials: HatchingMaterial[] = [];
  /** Copy changes from the materials that were replaced. */
  readonly followers: MaterialFollower[] = [];
  /** Keyed by the source, the scale, and whether the mesh deforms. */
  private readonly replacements = new Map<string, HatchingMaterial>();
  /** The scales of materials whose parameters set no `tilesPerUnit`. */
  private readonly scales = new Map<HatchingMaterial, number>();

  constructor(
    private readonly parameters:
      | HatchingMaterialParameters
      | ((source: Material, mesh: Mesh) => HatchingMaterialParameters),
    private readonly make: () => HatchingMaterial,
  ) {}

  /**
   * The material or materials that replace those of a mesh, made on first use.
   *
   * @param old the material or materials of the mesh
   * @param scale world units per unit of the mesh's object space
   */
  replacementFor(mesh: Mesh, old: Material | Material[], scale: number): Material | Material[] {
    const replace = (source: Material | null | undefined): Material =>
      source && isReplaced(source, mesh) ? this.hatchingMaterialFor(source, mesh, scale) : source!;
    return Array.isArray(old) ? old.map(replace) : replace(old);
  }

  /** Gives strokes the same size in world space, on all materials whose parameters set no `tilesPerUnit`. */
  setTilesPerUnit(tilesPerWorldUnit: number): void {
    for (const [material, scale] of this.scales) material.tilesPerUnit = tilesPerWorldUnit * scale;
  }

  /** Sets the extent of the scene on all materials whose parameters set none. */
  setExtent(extent: SceneExtent): void {
    for (const material of this.materials) material.extent ??= extent;
  }

  dispose(): void {
    for (const material of this.materials) material.dispose();
  }

  private hatchingMaterialFor(source: Material, mesh: Mesh, scale: number): HatchingMaterial {
    const key = `${source.uuid} ${scale.toPrecision(SCALE_DIGITS)} ${deforms(mesh.geometry, mesh)}`;
    let material = this.replacements.get(key);
    if (!material) {
      const parameters = typeof this.parameters === 'function' ? this.parameters(source, mesh) : this.parameters;
      material = hatchingMaterialFrom(source, parameters, this.make());
      this.replacements.set(key, material);
      this.materials.push(material);
      this.followers.push(new MaterialFollower(source, material, Object.keys(parameters)));
      if (parameters.tilesPerUnit === undefined) this.scales.set(material, scale);
    }
    return material;
  }
}
