/** Known in three.js 0.170 to 0.187: data that renderers and objects keep under private names. */
import type { BatchedMesh, Material, Object3D, Texture, WebGLRenderer } from 'three';

/** Has WebGLRenderer read the clipping planes of a material again. It keeps them from one draw to the next, as if none could change. */
export function forgetClipping(renderer: WebGLRenderer, material: Material): void {
  (renderer.properties.get(material) as { clippingState?: unknown }).clippingState = null;
}

/** The matrices of a BatchedMesh, by which three's own materials draw it; null for other objects. */
export const batchMatrices = (object: Object3D): Texture | null =>
  'isBatchedMesh' in object ? (object as BatchedMesh & { readonly _matricesTexture: Texture })._matricesTexture : null;

/** The clipping planes of the frame that a WebGPURenderer is drawing; undefined if it draws none, or has no such data. */
export const clippingOfFrame = <Clipping>(renderer: object): Clipping | undefined =>
  (renderer as { _currentRenderContext?: { clippingContext: Clipping } | null })._currentRenderContext?.clippingContext;
