import { type Camera, type IUniform, type Vector2, Vector4, type WebGLRenderer } from 'three';

/** Fields of three's cameras beyond those of `Camera`. */
export type ViewedCamera = Camera & {
  view?: {
    enabled: boolean;
    fullWidth: number;
    fullHeight: number;
    offsetX: number;
    offsetY: number;
    width: number;
    height: number;
  } | null;
};

/**
 * Writes the place of the sheet: its lower left corner relative to that of the render target, and its size, in pixels. A large picture
 * is drawn tile by tile, by `setViewOffset`; the sheet is then the whole picture. Allocates nothing.
 *
 * @param viewport the viewport that is drawn to, in pixels
 * @param offset receives the place of the render target within the sheet, if tiles are drawn
 */
export function writeSheet(sheet: Vector4, camera: Camera, viewport: Vector4, offset?: Vector2): void {
  sheet.copy(viewport);
  offset?.set(0, 0);
  const { view } = camera as ViewedCamera;
  if (!view?.enabled) return;
  const { fullWidth, fullHeight, offsetX, offsetY, width, height } = view;
  sheet.z *= fullWidth / width;
  sheet.w *= fullHeight / height;
  // View offsets count from the upper left, in units of the full view.
  sheet.x -= (offsetX * viewport.z) / width;
  sheet.y -= ((fullHeight - offsetY - height) * viewport.w) / height;
  offset?.set(0 - sheet.x, 0 - sheet.y);
}

const currentViewport = /* @__PURE__ */ new Vector4();

/** The part of the render target that is drawn to, in pixels: each camera of an ArrayCamera has its own. Valid until the next call. */
export const drawnPart = (renderer: WebGLRenderer, camera: Camera): Vector4 =>
  (camera as Camera & { viewport?: Vector4 }).viewport ?? renderer.getCurrentViewport(currentViewport);

/** Writes the uniforms that depend on that part of the render target. Allocates nothing. */
export function writePartUniforms(camera: Camera, drawn: Vector4, u: Record<string, IUniform>): void {
  u.viewportHeight.value = drawn.w;
  writeSheet(u.sheet.value, camera, drawn, u.toothOffset.value);
}
