import { DataTexture, FloatType, type InstancedMesh, RGBAFormat } from 'three';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';

/** Texels of a matrix, one per column. */
const MATRIX_TEXELS = 4;

/** The matrices of the instances of a mesh, as a texture. */
class InstancePlaces {
  private texture: DataTexture | null = null;
  private matrices: InstancedMesh['instanceMatrix'] | null = null;
  private version = -1;
  private count = -1;

  /** The current matrices. Writes the texture if they have changed. */
  of({ instanceMatrix, count }: InstancedMesh): DataTexture {
    const isSame = instanceMatrix === this.matrices && instanceMatrix.version === this.version && count === this.count;
    if (this.texture && isSame) return this.texture;
    this.matrices = instanceMatrix;
    this.version = instanceMatrix.version;
    this.count = count;
    const words = 4 * MATRIX_TEXELS * count;
    if (!this.texture || (this.texture.image.data as Float32Array).length < words) {
      this.texture?.dispose();
      const { width, height } = pullTextureSize(Math.max(1, MATRIX_TEXELS * count));
      this.texture = new DataTexture(new Float32Array(4 * width * height), width, height, RGBAFormat, FloatType);
    }
    const { array } = instanceMatrix;
    (this.texture.image.data as Float32Array).set(array.length > words ? array.subarray(0, words) : array);
    this.texture.needsUpdate = true;
    return this.texture;
  }

  dispose(): void {
    this.texture?.dispose();
    this.texture = null;
  }
}

const places = /* @__PURE__ */ new WeakMap<InstancedMesh, InstancePlaces>();

/** The current instance matrices of a mesh, as a texture that is disposed of with the mesh. */
export function placesOf(mesh: InstancedMesh): DataTexture {
  let known = places.get(mesh);
  if (!known) {
    const made = new InstancePlaces();
    known = made;
    places.set(mesh, made);
    mesh.addEventListener('dispose', () => {
      made.dispose();
    });
  }
  return known.of(mesh);
}
