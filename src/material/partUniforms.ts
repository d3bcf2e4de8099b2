import { type Camera, type IUniform, Vector4, type WebGLRenderer } from 'three';
import { writeSheet } from './fading/writeSheet.js';
import { writePictureOffset } from './pictureOffset.js';

const viewport = /* @__PURE__ */ new Vector4();

/** The part of the render target that is drawn to, in pixels: each camera of an ArrayCamera has its own. Valid until the next call. */
export const drawnPart = (renderer: WebGLRenderer, camera: Camera): Vector4 =>
  (camera as Camera & { viewport?: Vector4 }).viewport ?? renderer.getCurrentViewport(viewport);

/** Writes the uniforms that depend on that part of the render target. Allocates nothing. */
export function writePartUniforms(camera: Camera, drawn: Vector4, u: Record<string, IUniform>): void {
  u.viewportHeight.value = drawn.w;
  writePictureOffset(u.toothOffset.value, camera, drawn);
  writeSheet(u.sheet.value, camera, drawn);
}
