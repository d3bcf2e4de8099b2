import type { Mesh, SkinnedMesh } from 'three';

/** The numbers that deform a mesh: morph target influences, bone matrices and bind matrices. */
export class Pose {
  private numbers = new Float32Array(0);
  private length = -1;
  private hasChanged = true;

  /** Copies the pose of `mesh`. Returns whether it differs from the previous one. Allocates only if the pose has grown. */
  update(mesh: Mesh): boolean {
    const length = this.length;
    this.length = 0;
    this.hasChanged = false;
    if (mesh.morphTargetInfluences) this.add(mesh.morphTargetInfluences);
    if ('isSkinnedMesh' in mesh) {
      const { skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh;
      if (skeleton.boneMatrices) this.add(skeleton.boneMatrices);
      this.add(bindMatrix.elements);
      this.add(bindMatrixInverse.elements);
    }
    return this.hasChanged || this.length !== length;
  }

  private add(numbers: ArrayLike<number>): void {
    const start = this.length;
    this.length += numbers.length;
    if (this.length > this.numbers.length) {
      const grown = new Float32Array(this.length);
      grown.set(this.numbers);
      this.numbers = grown;
      this.hasChanged = true;
    }
    for (let i = 0; i < numbers.length; i++) {
      const number = Math.fround(numbers[i]);
      if (this.numbers[start + i] === number) continue;
      this.numbers[start + i] = number;
      this.hasChanged = true;
    }
  }
}
