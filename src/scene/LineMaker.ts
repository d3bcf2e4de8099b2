import type { Material, Mesh } from 'three';
import { describeObject } from '../geometry/describeObject.js';
import type { LineOptions } from '../geometry/prepareHatchingGeometry.js';
import { HatchingLineMaterial, type HatchingLineParameters } from '../lines/HatchingLineMaterial.js';
import { HatchingLines } from '../lines/HatchingLines.js';
import { deforms } from '../material/deformation/bindVertices.js';
import type { MeshLook } from './HatchedScene.js';
import { isBatched, materialsOf } from './surfaceMeshes.js';

/** Whether a map cuts out parts of a surface. Its lines would follow the outline of the geometry, and not of the picture on it. */
const isCutOut = ({ alphaTest, alphaHash }: Material): boolean => alphaTest > 0 || alphaHash;

let hasWarned = false;

/** Says once that batches have no lines. */
function warnOfBatch(mesh: Mesh): void {
  if (hasWarned) return;
  hasWarned = true;
  console.warn(
    `applyHatching: the ${describeObject(mesh)} is hatched without lines, since a BatchedMesh has none. Use an InstancedMesh or single meshes where lines are needed.`,
  );
}

/** Makes the lines of a scene. Meshes that deform share a material of their own, since they need another shader program. */
export class LineMaker {
  /** The options that decide which edges are creases. */
  readonly creases: LineOptions;
  private readonly parameters: HatchingLineParameters;
  private readonly materials = new Map<boolean, HatchingLineMaterial>();
  private readonly made: HatchingLines[] = [];

  constructor({ creaseAngle, creaseLength, ...parameters }: LineOptions & HatchingLineParameters) {
    this.creases = { creaseAngle, creaseLength };
    this.parameters = parameters;
    // Wrong parameters throw here, before anything is baked.
    this.materialFor(false);
  }

  /** Makes the lines of a mesh whose geometry was baked, unless it is a cut-out. They are not yet added to the scene. */
  addLines({ mesh, geometry, material }: MeshLook): void {
    if (isBatched(mesh)) {
      warnOfBatch(mesh);
      return;
    }
    if (materialsOf({ material }).every(isCutOut)) return;
    const lines = new HatchingLines(mesh, this.materialFor(deforms(geometry, mesh)));
    lines.layers.mask = mesh.layers.mask;
    this.made.push(lines);
  }

  /** All lines that were made. */
  get lines(): readonly HatchingLines[] {
    return this.made;
  }

  dispose(): void {
    for (const lines of this.made) lines.dispose();
    for (const material of this.materials.values()) material.dispose();
  }

  private materialFor(isDeforming: boolean): HatchingLineMaterial {
    let material = this.materials.get(isDeforming);
    if (!material) {
      material = new HatchingLineMaterial(this.parameters);
      material.writeUniforms(isDeforming, false);
      this.materials.set(isDeforming, material);
    }
    return material;
  }
}
