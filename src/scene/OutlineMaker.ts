import type { Material, Mesh } from 'three';
import { deforms } from '../material/deformation/canDeform.js';
import { describeObject } from '../material/diagnostics/describeObject.js';
import { warn } from '../material/diagnostics/warn.js';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type {
  HatchingOutlineMaterial,
  HatchingOutlineParameters,
} from '../material/outlines/HatchingOutlineMaterial.js';
import type { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import type { MeshOutlines } from '../material/outlines/MeshOutlines.js';
import { isCutOut } from '../material/outlines/surfaceRules.js';
import type { MeshLook } from './geometryPlans.js';
import type { SkippedMesh } from './HatchedScene.js';
import { isBatched, materialsOf } from './surfaceMeshes.js';

/** Whether outlines would follow the geometry, and not the visible shape that the material's cut-out or fading leaves. */
function isWiderThanSeen(material: Material & { alphaMap?: unknown }): boolean {
  const { alphaHash, alphaMap, alphaTest, transparent } = material;
  return (alphaTest > 0 || alphaHash || (transparent && Boolean(alphaMap))) && !isCutOut(material);
}

let hasWarned = false;

/** Warns once that batches have no outlines. */
function warnOfBatch(mesh: Mesh): void {
  if (hasWarned) return;
  hasWarned = true;
  warn(
    `applyHatching: the ${describeObject(mesh)} is hatched without outlines, since a BatchedMesh has none. Use an InstancedMesh or single meshes where outlines are needed.`,
  );
}

/** Makes outlines for one kind of renderer. */
export interface OutlineKind<Look extends Material, Drawn> {
  /** @throws RangeError or TypeError for a wrong parameter */
  material(parameters: HatchingOutlineParameters, isDeforming: boolean): Look;
  outlines(mesh: Mesh | null, material: Look): Drawn;
}

/** Makes the outlines of a scene. Meshes that deform share a material of their own, since they need another program. */
export class OutlineMaker<
  Look extends Material = HatchingOutlineMaterial,
  Drawn extends MeshOutlines = HatchingOutlines,
> {
  /** The options that decide which edges are creases. */
  readonly creases: OutlineOptions;
  private readonly parameters: HatchingOutlineParameters;
  private readonly materials = new Map<boolean, Look>();
  private readonly made: Drawn[] = [];
  /** The meshes that are hatched without outlines, with the reason. */
  readonly without: SkippedMesh[] = [];

  constructor(
    { featureAngle, creaseLength, ...parameters }: OutlineOptions & HatchingOutlineParameters,
    private readonly kind: OutlineKind<Look, Drawn>,
  ) {
    this.creases = { featureAngle, creaseLength };
    this.parameters = parameters;
    // Wrong parameters throw here, before anything is baked.
    this.materialFor(false);
  }

  /**
   * Makes the outlines of a mesh whose geometry was baked, unless they would be where nothing of it is seen. They are not yet added to
   * the scene.
   */
  addOutlines({ mesh, geometry, material }: MeshLook): void {
    if (isBatched(mesh)) {
      warnOfBatch(mesh);
      this.leaveOut(mesh, 'a BatchedMesh has none');
      return;
    }
    if (materialsOf({ material }).every(isWiderThanSeen)) {
      this.leaveOut(mesh, 'they would be drawn where its picture or its opacity cuts it away');
      return;
    }
    const outlines = this.kind.outlines(mesh, this.materialFor(deforms(geometry, mesh)));
    this.made.push(outlines);
  }

  /** Outlines without a mesh, with which the program of outlines is compiled. */
  get samples(): readonly Drawn[] {
    return [this.kind.outlines(null, this.materialFor(false))];
  }

  /** All outlines made so far. */
  get outlines(): readonly Drawn[] {
    return this.made;
  }

  dispose(): void {
    for (const outlines of this.made) outlines.dispose();
    for (const material of this.materials.values()) material.dispose();
  }

  private leaveOut(mesh: Mesh, why: string): void {
    this.without.push({ mesh, reason: `The ${describeObject(mesh)} is hatched without outlines: ${why}.` });
  }

  private materialFor(isDeforming: boolean): Look {
    let material = this.materials.get(isDeforming);
    if (!material) {
      material = this.kind.material(this.parameters, isDeforming);
      this.materials.set(isDeforming, material);
    }
    return material;
  }
}
