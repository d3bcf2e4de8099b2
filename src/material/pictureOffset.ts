import type { Camera, Vector2, Vector4 } from 'three';

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
