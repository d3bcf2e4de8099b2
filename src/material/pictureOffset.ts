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
 * Writes the offset of the drawn picture within the whole picture, in pixels from the lower left: a large picture is drawn tile by
 * tile, by `setViewOffset`. Allocates nothing.
 *
 * @param viewport the viewport of the drawn picture, in pixels
 */
export function writePictureOffset(target: Vector2, camera: Camera, viewport: Vector4): void {
  const { view } = camera as ViewedCamera;
  if (!view?.enabled) {
    target.set(0, 0);
    return;
  }
  const { fullHeight, offsetX, offsetY, width, height } = view;
  // View offsets count from the upper left, in units of the full view.
  const fromBelow = fullHeight - offsetY - height;
  target.set((offsetX * viewport.z) / width - viewport.x, (fromBelow * viewport.w) / height - viewport.y);
}

/**
 * Writes the place of the sheet: its lower left corner relative to that of the render target, and its size, in pixels. If a picture is
 * drawn in tiles, the sheet is the whole picture. Allocates nothing.
 *
 * @param viewport the viewport that is drawn to, in pixels
 */
export function writeSheet(sheet: Vector4, camera: Camera, viewport: Vector4): void {
  sheet.copy(viewport);
  const { view } = camera as ViewedCamera;
  if (!view?.enabled) return;
  const { fullWidth, fullHeight, offsetX, offsetY, width, height } = view;
  sheet.z *= fullWidth / width;
  sheet.w *= fullHeight / height;
  // View offsets count from the upper left.
  sheet.x -= (offsetX * viewport.z) / width;
  sheet.y -= ((fullHeight - offsetY - height) * viewport.w) / height;
}

const currentViewport = /* @__PURE__ */ new Vector4();

/** The part of the render target that is drawn to, in pixels: each camera of an ArrayCamera has its own. Valid until the next call. */
export const drawnPart = (renderer: WebGLRenderer, camera: Camera): Vector4 =>
  (camera as Camera & { viewport?: Vector4 }).viewport ?? renderer.getCurrentViewport(currentViewport);

/** Writes the uniforms that depend on that part of the render target. Allocates nothing. */
export function writePartUniforms(camera: Camera, drawn: Vector4, u: Record<string, IUniform>): void {
  u.viewportHeight.value = drawn.w;
  writePictureOffset(u.toothOffset.value, camera, drawn);
  writeSheet(u.sheet.value, camera, drawn);
}
