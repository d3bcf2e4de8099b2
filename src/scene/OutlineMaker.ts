import type { Material, Mesh } from 'three';
import type { OutlineOptions } from '../geometry/prepareHatchingGeometry.js';
import { deforms } from '../material/deformation/canDeform.js';
import { describeObject } from '../mistakes/describeObject.js';
import { tell } from '../mistakes/tell.js';
import { HatchingOutlineMaterial, type HatchingOutlineParameters } from '../outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../outlines/HatchingOutlines.js';
import type { MeshLook } from './MeshLook.js';
import { isBatched, materialsOf } from './surfaceMeshes.js';

/** Whether a map cuts out parts of a surface. Its outlines would follow the outline of the geometry, and not of the picture on it. */
const isCutOut = ({ alphaTest, alphaHash }: Material): boolean => alphaTest > 0 || alphaHash;

let hasWarned = false;

/** Says once that batches have no outlines. */
function warnOfBatch(mesh: Mesh): void {
  if (hasWarned) return;
  hasWarned = true;
  tell(
    `applyHatching: the ${describeObject(mesh)} is hatched without outlines, since a BatchedMesh has none. Use an InstancedMesh or single meshes where outlines are needed.`,
  );
}

/** Makes the outlines of a scene. Meshes that deform share a material of their own, since they need another shader program. */
export class OutlineMaker {
  /** The options that decide which edges are creases. */
  readonly creases: OutlineOptions;
  private readonly parameters: HatchingOutlineParameters;
  private readonly materials = new Map<boolean, HatchingOutlineMaterial>();
  private readonly made: HatchingOutlines[] = [];

  constructor({ featureAngle, creaseLength, ...parameters }: OutlineOptions & HatchingOutlineParameters) {
    this.creases = { featureAngle, creaseLength };
    this.parameters = parameters;
    // Wrong parameters throw here, before anything is baked.
    this.materialFor(false);
  }

  /** Makes the outlines of a mesh whose geometry was baked, unless it is a cut-out. They are not yet added to the scene. */
  addOutlines({ mesh, geometry, material }: MeshLook): void {
    if (isBatched(mesh)) {
      warnOfBatch(mesh);
      return;
    }
    if (materialsOf({ material }).every(isCutOut)) return;
    const outlines = new HatchingOutlines(mesh, this.materialFor(deforms(geometry, mesh)));
    outlines.layers.mask = mesh.layers.mask;
    this.made.push(outlines);
  }

  /** Outlines without a mesh, to compile the program of outlines with. */
  get samples(): readonly HatchingOutlines[] {
    return [new HatchingOutlines(null, this.materialFor(false))];
  }

  /** All outlines that were made. */
  get outlines(): readonly HatchingOutlines[] {
    return this.made;
  }

  dispose(): void {
    for (const outlines of this.made) outlines.dispose();
    for (const material of this.materials.values()) material.dispose();
  }

  private materialFor(isDeforming: boolean): HatchingOutlineMaterial {
    let material = this.materials.get(isDeforming);
    if (!material) {
      material = new HatchingOutlineMaterial(this.parameters);
      material.writeUniforms(isDeforming, false);
      this.materials.set(isDeforming, material);
    }
    return material;
  }
}
