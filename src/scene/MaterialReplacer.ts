import { type Color, Material, type Mesh } from 'three';
import { GLASS, paperOfGlass } from '../look/glass.js';
import type { HatchingMaterialParameters } from '../material/checkValues.js';
import { deforms } from '../material/deformation/canDeform.js';
import type { HatchingComposition } from '../material/groups/HatchingComposition.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { isReplaced } from './leftAlone.js';
import { acceptable, COPIED, Replacement, surfaceProperties } from './Replacement.js';
import type { SurfaceMaterial } from './SurfaceMaterial.js';

/** The number of digits in which equal scales agree; further ones may differ by rounding. */
const SCALE_DIGITS = 6;

/**
 * Makes the hatching materials of a scene: one for each source material and scale of the meshes that use it. Meshes that deform get
 * materials of their own, because they need another program.
 */
export class MaterialReplacer {
  /** The replacements of all meshes so far, keyed by the source, the scale, and whether the mesh deforms. */
  readonly used = new Map<string, Replacement>();
  /** Those of them that are new. */
  readonly added: Replacement[] = [];

  /**
   * @param known the replacements that exist already
   * @param composition that the new materials share, unless a function of parameters gives them another
   */
  constructor(
    private readonly parameters:
      | HatchingMaterialParameters
      | ((source: Material, mesh: Mesh) => HatchingMaterialParameters),
    private readonly make: () => HatchingMaterial,
    private readonly known: ReadonlyMap<string, Replacement>,
    private readonly composition: HatchingComposition,
  ) {}

  /** The new materials. */
  get materials(): readonly HatchingMaterial[] {
    return this.added.map(({ material }) => material);
  }

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

  /** Gives strokes the same size in world space, on all new materials whose parameters set no `tilesPerObjectUnit`. */
  setTilesPerUnit(tilesPerWorldUnit: number): void {
    for (const one of this.added) if (one.scale !== null) one.give('tilesPerObjectUnit', tilesPerWorldUnit * one.scale);
  }

  dispose(): void {
    for (const { material } of this.added) material.dispose();
  }

  /** The parameters of each material, without those of the composition, which the scene sets once. */
  private get ownParameters(): HatchingMaterialParameters {
    const { composition: _composition, ...own } = this.parameters as HatchingMaterialParameters;
    return own;
  }

  private hatchingMaterialFor(source: Material, mesh: Mesh, scale: number): HatchingMaterial {
    const key = `${source.uuid} ${scale.toPrecision(SCALE_DIGITS)} ${deforms(mesh.geometry, mesh)}`;
    let replacement = this.used.get(key) ?? this.known.get(key);
    if (!replacement) {
      const parameters = typeof this.parameters === 'function' ? this.parameters(source, mesh) : this.ownParameters;
      const material = this.make();
      material.composition = this.composition;
      hatchingMaterialFrom(source, parameters, material);
      const ownScale = parameters.tilesPerObjectUnit === undefined ? scale : null;
      replacement = new Replacement(key, source, material, Object.keys(parameters), ownScale);
      this.added.push(replacement);
    }
    this.used.set(key, replacement);
    return replacement.material;
  }
}

/**
 * Turns a new hatching material into the one that replaces `source`. It takes over colour, maps and their settings (the textures are
 * shared, not copied), emission, opacity, sides, vertex colours, depth, blending, stencil, clipping, fog, wireframe, name, visibility
 * and user data. A material with `transmission` is drawn as glass, which hides nothing behind it.
 *
 * @param parameters override the values of `source`
 */
function hatchingMaterialFrom(
  source: Material,
  parameters: HatchingMaterialParameters,
  material: HatchingMaterial,
): void {
  // Material.copy clones user data through JSON, which loses some values. As the prototype of another object the source would become slow.
  const { alphaTest } = source;
  Material.prototype.copy.call(material, { ...source, alphaTest, userData: {} } as Material);
  material.toneMapped = false;
  material.userData = { ...source.userData };
  // The planes are shared, so that moving them keeps clipping both materials.
  material.clippingPlanes = source.clippingPlanes;
  const surface: SurfaceMaterial = source;
  const { fog, wireframe, wireframeLinewidth } = surface;
  for (const name of COPIED) if (surface[name]) (material[name] as Color).copy(surface[name] as Color);
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
      { paperOpacity: paperOfGlass(material.technique, Math.min(transmission, 1)) },
      parameters.paperOpacity !== undefined && { paperOpacity: parameters.paperOpacity },
    );
}
