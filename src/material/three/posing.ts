/** Known in three.js 0.170 to 0.187: by which members of an object its renderers tell how to draw it. */
import {
  BufferGeometry,
  type InstancedMesh,
  type Matrix4,
  type Mesh,
  Object3D,
  Points,
  type Skeleton,
  type SkinnedMesh,
} from 'three';

/** The corners of a mesh as points, or its vertices if it has an index. Renderers upload bones and morph targets as for a skinned mesh. */
export class CornerPoints extends Points {
  isSkinnedMesh = false;
  skeleton: Skeleton | undefined;
  bindMatrix: Matrix4 | undefined;
  bindMatrixInverse: Matrix4 | undefined;

  /** Takes over the pose of a mesh. The skeleton refers to the mesh: remove it after the draw, so that the mesh stays collectable. */
  takePose(mesh: Mesh): void {
    const { skeleton, bindMatrix, bindMatrixInverse } = mesh as Partial<SkinnedMesh>;
    this.morphTargetInfluences = mesh.morphTargetInfluences;
    this.isSkinnedMesh = skeleton !== undefined;
    this.skeleton = skeleton;
    this.bindMatrix = bindMatrix;
    this.bindMatrixInverse = bindMatrixInverse;
  }
}

/** A draw range with which WebGLRenderer builds the program, and then neither binds nor draws. */
export const NO_CORNERS: { readonly start: number; readonly count: number } = { start: 1, count: -2 };

/** A count of vertices for which renderers draw nothing. With 0 they would make a draw call, and read textures that do not exist. */
export const NO_VERTICES = -1;

/**
 * An object that renderers draw as a sprite: from triangles, in the order of transparent objects. A mesh would be exported, would cast
 * shadows, and would be found by code that looks for surfaces.
 */
export abstract class SpriteLike extends Object3D {
  /** @internal */
  readonly isSprite = true;
  /** True while instances are drawn, as those of an InstancedMesh. @internal */
  isInstancedMesh = false;
  /** @internal */
  instanceMatrix: InstancedMesh['instanceMatrix'] | null = null;
  /** Instances have neither colours nor morph targets here; an override material reads both. @internal */
  readonly instanceColor = null;
  /** @internal */
  readonly morphTexture = null;
  /** @internal */
  override count = 0;
  /** A geometry without attributes: vertices read their data from textures, and other materials draw nothing. @internal */
  readonly geometry = new BufferGeometry();

  abstract readonly mesh: Mesh | null;

  /** Exposes the instances of the mesh to three.js until the end of the draw, since they decide the program. @internal */
  showInstances(): void {
    const { mesh } = this;
    if (!mesh || !('isInstancedMesh' in mesh)) return;
    const { instanceMatrix, count } = mesh as InstancedMesh;
    this.isInstancedMesh = true;
    this.instanceMatrix = instanceMatrix;
    this.count = count;
  }

  /** Ends what `showInstances` began. @internal */
  hideInstances(): void {
    this.isInstancedMesh = false;
    this.instanceMatrix = null;
  }
}

/** Objects for `WebGLRenderer.compile`, which visits what it is given as a scene. They stay in their own scene, whose lights apply. */
export class ObjectList extends Object3D {
  constructor(private readonly objects: readonly Object3D[]) {
    super();
  }

  override traverse(callback: (object: Object3D) => void): void {
    for (const object of this.objects) callback(object);
  }

  override traverseVisible(): void {}
}
