/** Known in three.js 0.170 to 0.187: data that batches keep under private names. */
import type { BatchedMesh, Object3D, Texture } from 'three';

/** The matrices of a BatchedMesh, by which three's own materials draw it; null for other objects. */
export const batchMatrices = (object: Object3D): Texture | null =>
  'isBatchedMesh' in object ? (object as BatchedMesh & { readonly _matricesTexture: Texture })._matricesTexture : null;
