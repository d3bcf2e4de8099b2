/** Known in three.js 0.170 to 0.187: clipping planes that renderers keep under private names. */
import type { Material, WebGLRenderer } from 'three';

/** Has WebGLRenderer read the clipping planes of a material again. It keeps them from one draw to the next, as if none could change. */
export function forgetClipping(renderer: WebGLRenderer, material: Material): void {
  (renderer.properties.get(material) as { clippingState?: unknown }).clippingState = null;
}

/** The clipping planes of the frame that a WebGPURenderer is drawing; undefined if it draws none, or has no such data. */
export const clippingOfFrame = <Clipping>(renderer: object): Clipping | undefined =>
  (renderer as { _currentRenderContext?: { clippingContext: Clipping } | null })._currentRenderContext?.clippingContext;
