/** Known in three.js 0.170 to 0.187: by which members of a mesh WebGPURenderer tells how to draw it. */
import { type InstancedMesh, type Material, type Matrix4, Mesh, type Skeleton, type SkinnedMesh } from 'three';

/** Draws the surface of a mesh with another material, in a scene of its own. Shares the geometry, the matrices and the pose. */
export class PosedCopy<Look extends Material> extends Mesh<Mesh['geometry'], Look> {
  /** The mesh that it was last drawn for. */
  source: Mesh | null = null;
  isSkinnedMesh = false;
  skeleton: Skeleton | undefined;
  bindMatrix: Matrix4 | undefined;
  bindMatrixInverse: Matrix4 | undefined;
  /** Instances. Their matrices are left to the material. @internal */
  override count = 1;

  constructor(material: Look) {
    super(undefined, material);
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
    this.matrixWorldAutoUpdate = false;
  }

  /** Takes over what the vertices of a mesh are computed from. */
  take(mesh: Mesh): void {
    const { skeleton, bindMatrix, bindMatrixInverse } = mesh as Partial<SkinnedMesh>;
    this.source = mesh;
    this.geometry = mesh.geometry;
    this.matrixWorld = mesh.matrixWorld;
    this.layers.mask = mesh.layers.mask;
    this.morphTargetInfluences = mesh.morphTargetInfluences;
    this.isSkinnedMesh = skeleton !== undefined;
    this.skeleton = skeleton;
    this.bindMatrix = bindMatrix;
    this.bindMatrixInverse = bindMatrixInverse;
    this.count = 'isInstancedMesh' in mesh ? (mesh as InstancedMesh).count : 1;
  }
}
